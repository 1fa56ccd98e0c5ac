# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Label propagation from a few random starts: what tables, seeds and noise have in common.

from collections import defaultdict

import paper
from programs import propagate
from scores import THRESHOLDS, pooled
from work import Item

RESOLUTIONS = {paper.SUBSAMPLE: f"{paper.SUBSAMPLE:,} points", 0: "all points"}


def propagation(scan, seeds, subsample, start, **disturbance):
    settings = {"seeds": seeds, "subsample": subsample, "start": start, **disturbance}
    return Item(scan, "propagate", settings, propagate)


def by_classes(done):
    """(item, result) pairs for each set of classes, which cannot be pooled with another."""
    groups = defaultdict(list)
    for pair in done:
        groups[pair[1]["classes_from"]].append(pair)
    return groups


def with_setting(done, **setting):
    """Those pairs, and no disturbance that is not named."""
    varying = ("noise", "keep", *paper.RAW_SCANS)
    wanted = {name: None for name in varying} | setting
    return [pair for pair in done
            if all(pair[0].settings.get(name) == value for name, value in wanted.items())]


def scan_row(item, result):
    """A scan's line in the CSV."""
    ap = pooled([result])["mean"]
    return {
        "scan": item.scan.name,
        "classes_from": result["classes_from"],
        **item.settings,
        "points": result["points"],
        "truth_instances": result["truth_instances"],
        **{f"ap{t}": value for t, value in zip(THRESHOLDS, ap)},
        "mean_iou": result["mean_iou"],
        "seconds": result["seconds"],
    }
