#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Segment a scan by the label of 100 seeds, and score it.
#
#   segment_a_scan.py room.pcd OUTPUT_FOLDER

import sys
from pathlib import Path

import pcl_cid
from drawing import draw_from_above, palette, plt, save


def main(path, folder):
    cloud = pcl_cid.read(path)
    scan = pcl_cid.Scan(cloud)
    scan.propose(100)
    scan.label_seeds(scan.seeds, cloud["label"][scan.seeds])
    labels = scan.labels(clean_up=True)
    scores = pcl_cid.evaluate(labels, cloud["label"], protocol="paper")
    pcl_cid.write(folder / "labelled.pcd", cloud, label=labels)

    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 5))
    colors = palette(1 + max(labels.max(), scan.groups.max()))
    draw_from_above(left, cloud.points, colors[scan.groups])
    left.set_title(f"{len(scan.seeds)} groups")
    draw_from_above(right, cloud.points, colors[labels])
    right.set_title(f"labels of their seeds, AP50 {scores['mean']['ap50']:.3f}")
    save(figure, folder / "segment_a_scan.png")


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
