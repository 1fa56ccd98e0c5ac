# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The measurements of cid_end_to_end, for benchmark_table.py and plot_benchmark.py.

import csv
import statistics
from collections import defaultdict
from dataclasses import dataclass


@dataclass(frozen=True)
class Case:
    """What was measured; the rounds of one case make one summary."""

    input: str
    points: int
    work: str
    seeds: int = 100
    threads: int = 2


@dataclass(frozen=True)
class Summary:
    """What the rounds of a case gave."""

    rounds: int
    median: float  # seconds
    least: float  # seconds
    share: float  # of the work that was done, the rest being scaled; 1 for all of it
    peak: float  # MB (10^6 bytes) above the cloud, the largest of all rounds


def load(path):
    """Summaries by case, in the order of the file."""
    rows = defaultdict(list)
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            case = Case(
                row["input"],
                int(row["points"]),
                row["work"],
                int(row["seeds"]),
                int(row["threads"]),
            )
            rows[case].append(row)
    return {case: summarize(of_case) for case, of_case in rows.items()}


def loads(path):
    """The load averages of the machine, one for each measurement."""
    with open(path, newline="") as file:
        return [float(row["load"]) for row in csv.DictReader(file)]


def summarize(rows):
    seconds = [float(row["seconds"]) for row in rows]
    return Summary(
        len(rows),
        statistics.median(seconds),
        min(seconds),
        statistics.mean(float(row["share"]) for row in rows),
        max(float(row["peak_bytes"]) for row in rows) / 1e6,
    )
