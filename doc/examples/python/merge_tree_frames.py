#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Frames of a slider over the merge tree: one tree, cut at many numbers of parts.
#
#   merge_tree_frames.py room.pcd OUTPUT_FOLDER

import sys
from pathlib import Path

import pcl_cid
from drawing import draw_from_above, palette, plt, save

COUNTS = (80, 40, 20, 10)


def main(path, folder):
    points = pcl_cid.read(path).points
    scan = pcl_cid.Scan(points)
    scan.propose(100)
    tree = scan.merge_tree()
    colors = palette(len(tree))
    for frame, count in enumerate(COUNTS):
        part_of_group = tree.cut(count=count)
        figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.5))
        draw_from_above(left, points, colors[part_of_group[scan.groups]])
        left.set_title(f"{count} parts")
        right.plot(tree.heights, lw=1)
        right.axvline(len(tree) - count, color="r")
        right.set_xlabel("merges")
        right.set_ylabel("group CID (Eq. 3), metres")
        save(figure, folder / f"merge_tree_{frame}.png")


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
