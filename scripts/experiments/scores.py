# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Average precision over many scans, from what is known of each.
#
# All predictions are equally sure, so AP is R (1 + P) / 2; see doc/core/evaluation.md.

import statistics
from collections import defaultdict

THRESHOLDS = (25, 50, 75)


def sums(results):
    """For each class, its counts over all scans."""
    total = defaultdict(lambda: defaultdict(int))
    for result in results:
        for name, counted in result["classes"].items():
            for key, count in counted.items():
                total[name][key] += count
    return total


def average_precision(counted, threshold):
    """Of one class; None when there is nothing to find."""
    if not counted["truths"]:
        return None
    if not counted["predictions"]:
        return 0.0
    right = counted[f"right{threshold}"]
    return right / counted["truths"] * (1 + right / counted["predictions"]) / 2


def mean(values):
    """Over those that are defined."""
    known = [value for value in values if value is not None]
    return statistics.fmean(known) if known else None


def pooled(results):
    """AP25, AP50 and AP75 by class, and the `mean` over the classes."""
    figures = {
        name: tuple(average_precision(counted, t) for t in THRESHOLDS)
        for name, counted in sums(results).items()
    }
    figures["mean"] = tuple(mean(column) for column in zip(*figures.values()))
    return figures


def over_starts(results_by_start):
    """The figures of each start, averaged."""
    of_each = [pooled(results) for results in results_by_start]
    return {
        name: tuple(mean(column) for column in zip(*(each[name] for each in of_each)))
        for name in of_each[0]
    }


def weighted(results, figure, weight):
    """A figure of the scans as if they were one."""
    total = sum(result[weight] for result in results)
    known = [result for result in results if result[figure] is not None]
    return sum(result[figure] * result[weight] for result in known) / total if total else None


def summary(items):
    """What there is to say of (item, result) pairs with the same setting but for the start."""
    by_start = defaultdict(list)
    for item, result in items:
        by_start[item.settings["start"]].append(result)
    starts = list(by_start.values())
    classes = over_starts(starts)
    ap50 = [pooled(results)["mean"][1] for results in starts]
    return {
        "starts": len(starts),
        "scans": len(starts[0]),
        "classes": classes,
        "mean": classes["mean"],
        "ap50_of_starts": ap50,
        "truths": {name: counted["truths"] for name, counted in sums(starts[0]).items()},
        "mean_iou": mean(weighted(r, "mean_iou", "truth_instances") for r in starts),
    }
