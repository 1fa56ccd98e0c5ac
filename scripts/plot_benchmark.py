# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Pictures of the measurements: time against N, K and threads; memory against N.
#
# usage: plot_benchmark.py FOLDER
#   FOLDER has results.csv; the pictures are written to it.

import argparse
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from benchmark_results import load

ROOMS = {"room_even": ("room, even", "C0"), "room_sensor": ("room, sensor", "C1")}
MOST_MEMORY = {20_000: 50, 200_000: 120, 1_000_000: 400, 10_000_000: 2_000}


def curve(results, x, y, **fixed):
    """Sorted (x, y) of the cases in which everything else is as given."""
    pairs = [
        (getattr(case, x), getattr(summary, y))
        for case, summary in results.items()
        if all(getattr(case, name) == value for name, value in fixed.items())
    ]
    return tuple(zip(*sorted(pairs))) or ((), ())


def new_axes(title, x_label, y_label):
    _, axes = plt.subplots(figsize=(8, 4.2), layout="constrained")
    axes.set(title=title, xlabel=x_label, ylabel=y_label, xscale="log", yscale="log")
    axes.grid(which="both", alpha=0.25)
    return axes


def save(axes, path):
    axes.legend(fontsize="small", loc="upper left", bbox_to_anchor=(1, 1))
    axes.figure.savefig(path, dpi=100)
    plt.close(axes.figure)


def plot_scans(axes, results, y, **fixed):
    """The real scans, one mark each."""
    scans = sorted({case.input for case in results} - set(ROOMS))
    for scan, marker in zip(scans, "^sDvP"):
        xs, ys = curve(results, "points", y, input=scan, **fixed)
        axes.plot(xs, ys, marker, color="C2", label=scan)


def plot_time_against_points(results, path):
    axes = new_axes("100 seeds, 2 threads", "points", "seconds, cloud to labels")
    fixed = dict(seeds=100, threads=2)
    for room, (label, color) in ROOMS.items():
        for work, style in (("segment", "o-"), ("literal", "o--")):
            xs, ys = curve(results, "points", "median", input=room, work=work, **fixed)
            name = "ours" if work == "segment" else "literal"
            axes.plot(xs, ys, style, color=color, label=f"{name}, {label}")
    plot_scans(axes, results, "median", work="segment", **fixed)
    save(axes, path)


def plot_memory_against_points(results, path):
    axes = new_axes("100 seeds, 2 threads", "points", "peak MB above the cloud")
    fixed = dict(work="segment", seeds=100, threads=2)
    for room, (label, color) in ROOMS.items():
        xs, ys = curve(results, "points", "peak", input=room, **fixed)
        axes.plot(xs, ys, "o-", color=color, label=label)
    plot_scans(axes, results, "peak", **fixed)
    axes.plot(*zip(*MOST_MEMORY.items()), "k_", markersize=14, label="at most")
    save(axes, path)


def plot_against_setting(results, setting, path, **fixed):
    """Time against `seeds` or `threads`, for each room with at least two of them."""
    title = ", ".join(f"{value} {name}" for name, value in fixed.items())
    axes = new_axes(title, setting, "seconds, cloud to labels")
    values = set()
    for points, marker in zip(sorted({case.points for case in results}), "ov^sDP*X"):
        for room, (label, color) in ROOMS.items():
            of_room = dict(input=room, points=points, work="segment", **fixed)
            xs, ys = curve(results, setting, "median", **of_room)
            if len(xs) >= 2:
                name = f"{label}, {points:,} points"
                axes.plot(xs, ys, marker + "-", color=color, label=name)
                values.update(xs)
    axes.set_xticks(sorted(values), labels=[str(value) for value in sorted(values)])
    axes.minorticks_off()
    save(axes, path)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=Path)
    folder = parser.parse_args().folder
    results = load(folder / "results.csv")
    plot_time_against_points(results, folder / "time_points.png")
    plot_memory_against_points(results, folder / "memory_points.png")
    plot_against_setting(results, "seeds", folder / "time_seeds.png", threads=2)
    plot_against_setting(results, "threads", folder / "time_threads.png", seeds=100)


main()
