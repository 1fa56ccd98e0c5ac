# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The measurements as Markdown, next to what they must reach.
#
# usage: benchmark_table.py FOLDER [--doc FILE]
#   FOLDER has results.csv, machine.txt and kernels.json; table.md is written to it.
#   FILE takes the same text, and the pictures from images/, between its two marks.

import argparse
import json
from pathlib import Path

from benchmark_results import Case, load, loads

BEGIN = "<!-- begin: written by scripts/benchmark.sh --write-doc -->"
END = "<!-- end: written by scripts/benchmark.sh --write-doc -->"

ROOMS = ("room_even", "room_sensor")
LEAST_RATIO = {20_000: 500, 200_000: 4_000, 1_000_000: 15_000}
MOST_MEMORY = {20_000: 50, 200_000: 120, 1_000_000: 400, 10_000_000: 2_000}
BUSY_POINTS = 140_000
OFFICE = Case("office1", 254_456, "segment")

CURVES = """
### Curves

![Time against the number of points](images/benchmark_time_points.png)

![Time against the number of seeds](images/benchmark_time_seeds.png)

![Time against the number of threads](images/benchmark_time_threads.png)

![Memory against the number of points](images/benchmark_memory_points.png)
"""


def number(value):
    """Three significant digits, with thousands set apart."""
    return f"{value:,.0f}" if abs(value) >= 100 else f"{value:.3g}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines)


def requirement(name, bound, measured, at_least=False):
    """One line: the figure, what it must reach, what it is, whether it does."""
    limit = ("at least " if at_least else "at most ") + number(bound)
    if measured is None:
        return [name, limit, "not measured", "-"]
    reached = measured >= bound if at_least else measured <= bound
    return [name, limit, number(measured), "yes" if reached else "**no**"]


def ratio(results, above, below):
    """Ratio of the median times of two cases; None when one was not measured."""
    if above not in results or below not in results:
        return None
    return results[above].median / results[below].median


def speed_requirements(results):
    for points, bound in LEAST_RATIO.items():
        for room in ROOMS:
            yield requirement(
                f"literal / ours, {room}, {points:,} points",
                bound,
                ratio(
                    results,
                    Case(room, points, "literal"),
                    Case(room, points, "segment"),
                ),
                at_least=True,
            )
    for room in ROOMS:
        yield requirement(
            f"time at 10,000,000 / at 1,000,000 points, {room}",
            14,
            ratio(
                results,
                Case(room, 10_000_000, "segment"),
                Case(room, 1_000_000, "segment"),
            ),
        )


def memory_requirements(results):
    for points, bound in MOST_MEMORY.items():
        for room in ROOMS:
            summary = results.get(Case(room, points, "segment"))
            yield requirement(
                f"peak memory above the cloud in MB, {room}, {points:,} points",
                bound,
                summary and summary.peak,
            )


def scaling_requirements(results):
    for room in ROOMS:
        for work, name in (("cut", "merging to 30 parts"), ("merge", "the whole tree")):
            yield requirement(
                f"{name} / seeds, {room}, 20,000 points",
                1,
                ratio(results, Case(room, 20_000, work), Case(room, 20_000, "seeds")),
            )
    for room in ROOMS:
        for points in LEAST_RATIO:
            yield requirement(
                f"K = 1,000 / K = 100, {room}, {points:,} points",
                10,
                ratio(
                    results,
                    Case(room, points, "segment", seeds=1000),
                    Case(room, points, "segment"),
                ),
            )
    for room in ROOMS:
        yield requirement(
            f"1 thread / 2 threads, {room}, 1,000,000 points",
            1.85,
            ratio(
                results,
                Case(room, 1_000_000, "segment", threads=1),
                Case(room, 1_000_000, "segment"),
            ),
            at_least=True,
        )
    for room in ROOMS:
        yield requirement(
            f"office1 / {room} of its size ({OFFICE.points:,} points)",
            1.5,
            ratio(results, OFFICE, Case(room, OFFICE.points, "segment")),
        )


def correction_requirements(results):
    """What an annotator waits for after a click, in milliseconds."""
    for work, bound in (("add", 60), ("remove", 120)):
        for room in ROOMS:
            summary = results.get(Case(room, 1_000_000, work))
            yield requirement(
                f"`{work}` of one seed in ms, {room}, 1,000,000 points",
                bound,
                summary and 1000 * summary.median,
            )


def busy_requirements(results):
    """2 threads beside two busy processes, in wall and in processor time."""
    for work, name, bound in (("busy", "time", 1), ("busy_cpu", "processor time", 1.1)):
        yield requirement(
            f"{name} of 2 threads / 1 thread beside two busy processes, room",
            bound,
            ratio(
                results,
                Case("room", BUSY_POINTS, work),
                Case("room", BUSY_POINTS, work, threads=1),
            ),
        )


def reading_requirements(results):
    """Beside PCL's own readers; of a binary PCD PCL maps the file and looks at no value."""
    for kind, bound in (("pcd", 4), ("ascii_pcd", 0.5), ("ply", 1.5)):
        for room in ROOMS:
            yield requirement(
                f"`read_{kind}` / `pcl_{kind}`, {room}, 1,000,000 points",
                bound,
                ratio(
                    results,
                    Case(room, 1_000_000, f"read_{kind}", seeds=1, threads=1),
                    Case(room, 1_000_000, f"pcl_{kind}", seeds=1, threads=1),
                ),
            )


def requirement_table(results):
    rows = [
        *speed_requirements(results),
        *memory_requirements(results),
        *scaling_requirements(results),
        *correction_requirements(results),
        *busy_requirements(results),
        *reading_requirements(results),
    ]
    return table(["figure", "must be", "is", "reached"], rows)


def measurement_table(results):
    rows = []
    for case, summary in results.items():
        if case.work == "check":
            continue
        rows.append(
            [
                case.input,
                f"{case.points:,}",
                case.work,
                f"{case.seeds:,}",
                str(case.threads),
                number(summary.median),
                number(summary.least),
                str(summary.rounds),
                "all" if summary.share == 1 else f"{100 * summary.share:.2g} %",
                number(summary.peak),
            ]
        )
    head = ["input", "points", "work", "K", "threads", "median s", "least s"]
    return table(head + ["rounds", "done", "peak MB"], rows)


def checked_inputs(results):
    names = [
        f"{case.input} ({case.points:,})" for case in results if case.work == "check"
    ]
    return (
        "The literal method found the same groups for 50 random points and all seeds "
        "in each of: " + ", ".join(names) + "."
        if names
        else "The groups were not compared with those of the literal method."
    )


def kernel_table(path):
    rows = []
    for kernel in json.loads(path.read_text())["benchmarks"]:
        name, _, points = kernel["name"].split("/")[:3]
        rows.append(
            [
                name,
                kernel["label"],
                f"{int(points):,}",
                f"{number(kernel['real_time'])} {kernel['time_unit']}",
            ]
        )
    return table(["step", "room", "points", "time"], rows)


def machine(folder):
    load_averages = loads(folder / "results.csv")
    lines = (folder / "machine.txt").read_text().splitlines()
    lines.append(
        f"Load average while measuring: {min(load_averages):.2g} to "
        f"{max(load_averages):.2g}"
    )
    return "\n".join(f"* {line}" for line in lines)


def report(folder):
    results = load(folder / "results.csv")
    parts = [
        "### Machine",
        machine(folder),
        "### What must be reached",
        requirement_table(results),
        checked_inputs(results),
        "### All measurements",
        measurement_table(results),
        "### Single steps",
        kernel_table(folder / "kernels.json"),
    ]
    return "\n\n".join(parts) + "\n"


def insert(text, document):
    """Replace what stands between the marks of a document."""
    before, begin, rest = document.read_text().partition(BEGIN)
    _, end, after = rest.partition(END)
    if not begin or not end:
        raise SystemExit(f"{document} has no place for the table: {BEGIN} ... {END}")
    document.write_text(f"{before}{begin}\n\n{text}\n{end}{after}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=Path)
    parser.add_argument("--doc", type=Path)
    arguments = parser.parse_args()
    text = report(arguments.folder)
    (arguments.folder / "table.md").write_text(text)
    if arguments.doc:
        insert(text + CURVES, arguments.doc)


main()
