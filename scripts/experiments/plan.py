# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# What a workflow is to do: its scans, and the files that it makes of them. Both Snakefiles and
# their command lines ask it; paths of results are below the folder of the workflow.

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from programs import Programs
from scans import scans_of, spread


# A file that is there after a run with jobs that failed.
FAILED = "failed"


@dataclass(frozen=True)
class Wanted:
    """A file that is made of a scan, and the logs that say why it is not there."""

    scan: str
    result: str
    logs: tuple

    def reason(self):
        """Why it failed: the last line of the first log that has any."""
        for log in map(Path, self.logs):
            lines = log.read_text(errors="replace").strip().splitlines() if log.exists() else []
            if lines:
                return lines[-1].strip()
        return f"ended without a word, which may be for want of memory; nothing in {self.logs[0]}"


class Plan:
    """Of a configuration, made in the folder of the workflow where no other is named. What its kinds add: `wanted`."""

    def __init__(self, config, out=None):
        self.config = config
        self.out = out or Path.cwd()
        self.targets = config["targets"]
        self.threads = config["threads"]
        # Whether to summarize without the scans that failed.
        self.partial = config.get("partial", False)

    @cached_property
    def scans(self):
        dataset = Path(self.config["dataset"])
        return spread(scans_of(dataset, self.out), self.config["scans"])

    @cached_property
    def version(self):
        return Programs(Path(self.config["programs"]), self.threads).version()

    def wanted(self, target):
        """The files that the summary of a target is made of."""
        raise NotImplementedError

    def missing(self, target):
        """For each scan that lacks a file, the first of those."""
        first = {}
        for each in self.wanted(target):
            if not Path(each.result).exists():
                first.setdefault(each.scan, each)
        return first

    def left_out(self, target):
        """The scans that a summary does without."""
        return list(self.missing(target)) if self.partial else []

    def results(self, target):
        """The files that a summary reads."""
        left_out = self.left_out(target)
        return [each.result for each in self.wanted(target) if each.scan not in left_out]


def complaint(dataset, scans):
    """What is wrong with the scans of a dataset; None if nothing is."""
    if not scans:
        return (f"{dataset}: holds no scan; PCD or PLY files, or folders of scans of S3DIS or "
                "ScanNet are needed")
    for scan in scans:
        # Snakemake's wildcards, and how it names a job of a cluster.
        if set(scan.name) & set("{},=:"):
            return f"{scan.path}: its name in the dataset must be without {{ }} , = and :"
    return None
