#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# An annotator in a loop: seeds are proposed, then each click corrects a wrong point.
#
#   label_in_a_loop.py room.pcd OUTPUT_FOLDER

import sys
from pathlib import Path

import numpy as np

import pcl_cid
from drawing import draw_from_above, plt, save

CLICKS = 40


def wrong_point(labels, truth):
    """A point in the middle of what is wrong most often: one pair of labels."""
    wrong = np.flatnonzero(labels != truth)
    pairs = truth[wrong].astype(np.int64) << 32 | labels[wrong]
    values, counts = np.unique(pairs, return_counts=True)
    of_pair = wrong[pairs == values[counts.argmax()]]
    return of_pair[len(of_pair) // 2]


def main(path, folder):
    cloud = pcl_cid.read(path)
    truth = cloud["label"]
    scan = pcl_cid.Scan(cloud)
    scan.propose(30)
    scan.label_seeds(scan.seeds, truth[scan.seeds])
    right = [np.mean(scan.labels() == truth)]
    wrong_at_first = scan.labels() != truth
    for _ in range(CLICKS):
        click = wrong_point(scan.labels(), truth)
        scan.add_seeds([click], labels=[truth[click]])
        right.append(np.mean(scan.labels() == truth))

    figure, axes = plt.subplots(1, 3, figsize=(14, 4.5))
    pictures = {"wrong at first": wrong_at_first,
                f"wrong after {CLICKS} clicks": scan.labels() != truth}
    for each, (title, wrong) in zip(axes, pictures.items()):
        draw_from_above(each, cloud.points, np.where(wrong, 1.0, 0.15),
                        cmap="hot_r", vmin=0, vmax=1.6)
        each.set_title(title)
    axes[2].plot(range(30, 31 + CLICKS), 100 * np.array(right))
    axes[2].set_xlabel("clicks")
    axes[2].set_ylabel("right labels, %")
    save(figure, folder / "label_in_a_loop.png")


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
