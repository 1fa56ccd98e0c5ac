#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Picture of the curves that pcl_cid_abstract --curve writes: number of parts against
# tightness.
#
# usage: plot_tightness.py PICTURE.png CURVE.csv ...   (Debian's python3-matplotlib)

import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

PANELS = [
    ("free_share", "free space, share of the volume"),
    ("mean_concavity", "mean hull concavity, metres"),
    ("max_concavity", "largest hull concavity, metres"),
]


def main():
    if len(sys.argv) < 3:
        raise SystemExit("usage: plot_tightness.py PICTURE.png CURVE.csv ...")
    picture, *curves = sys.argv[1:]
    figure, axes = plt.subplots(1, len(PANELS), figsize=(12, 3.6), layout="constrained")
    for path in curves:
        with open(path, encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        parts = [int(row["parts"]) for row in rows]
        for panel, (column, label) in zip(axes, PANELS):
            panel.plot(parts, [float(row[column]) for row in rows], ".-",
                       label=Path(path).stem)
            panel.set(xlabel="parts", ylabel=label, xscale="log")
            panel.grid(which="both", alpha=0.25)
    axes[0].legend(fontsize="small")
    figure.savefig(picture, dpi=100)


if __name__ == "__main__":
    main()
