#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The heat map of Fig. 1: CID from a point to all others, beside the plain distance.
#
#   heat_map.py room.pcd OUTPUT_FOLDER

import sys
from pathlib import Path

import numpy as np

import pcl_cid
from drawing import draw_from_above, plt, save


def main(path, folder):
    points = pcl_cid.read(path).points
    scan = pcl_cid.Scan(points)
    start = int(scan.propose(1) and scan.seeds[0])
    heats = {
        "Euclidean distance": np.linalg.norm(points - points[start], axis=1),
        "CID (Eq. 2)": scan.cid_from(start),
    }
    figure, both = plt.subplots(1, 2, figsize=(11, 5))
    for axes, (title, heat) in zip(both, heats.items()):
        drawn = draw_from_above(axes, points, heat, cmap="inferno")
        axes.plot(*points[start, :2], "c*", ms=12)
        axes.set_title(title)
        figure.colorbar(drawn, ax=axes, shrink=0.7, label="metres")
    save(figure, folder / "heat_map.png")


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
