# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Label propagation from a few random starts: what tables, seeds and noise have in common.

from collections import defaultdict

import paper
from programs import DEFAULT
from scores import THRESHOLDS, pooled
from work import Item

# What each column is; options for raw scans that it does not name are the paper's.
COLUMNS = {f"{paper.SUBSAMPLE:,} points": {"subsample": paper.SUBSAMPLE},
           "all points": {"subsample": 0},
           "defaults": {"subsample": 0, **dict.fromkeys(paper.NOT_BY_DEFAULT, DEFAULT)}}


def propagation(scan, seeds, subsample, start, **disturbance):
    settings = {"seeds": seeds, "subsample": subsample, "start": start, **disturbance}
    return Item(scan, "propagate", settings)


def by_classes(done):
    """(item, result) pairs for each set of classes, which cannot be pooled with another."""
    groups = defaultdict(list)
    for pair in done:
        groups[pair[1]["classes_from"]].append(pair)
    return groups


def with_setting(done, **setting):
    """The pairs of the settings, without disturbances that are not named."""
    varying = ("noise", "keep", "groups", *paper.RAW_SCANS)
    wanted = {name: None for name in varying} | setting
    return [pair for pair in done
            if all(pair[0].settings.get(name) == value for name, value in wanted.items())]


def column_of(item):
    """The name of the column that an item belongs to, if it does."""
    return next((name for name, column in COLUMNS.items()
                 if with_setting([(item, None)], **column)), None)


def scan_row(item, result):
    """A scan's line in the CSV."""
    ap = pooled([result])["mean"]
    return {
        "scan": item.scan.name,
        "classes_from": result["classes_from"],
        **paper.RAW_SCANS, **item.settings,
        "points": result["points"],
        "truth_instances": result["truth_instances"],
        **{f"ap{t}": value for t, value in zip(THRESHOLDS, ap)},
        "mean_iou": result["mean_iou"],
        "seconds": result["seconds"],
    }
