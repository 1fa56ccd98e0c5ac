# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# What a workflow is to do: its scans, and the files that it makes of them. Both Snakefiles and
# their command lines ask it; paths of results are below the folder of the workflow.

import sys
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path

from programs import Programs, read_json
from scans import Scan, scans_of, spread

# A file that is there after a run with jobs that failed.
FAILED = "failed"


@dataclass(frozen=True)
class Step:
    """A file that a job makes, and the log of the job."""

    result: Path
    log: Path

    def reason(self):
        """Why the file is not there: the last line of the log."""
        lines = self.log.read_text(errors="replace").splitlines() if self.log.exists() else []
        words = [line.strip() for line in lines if line.strip()]
        return words[-1] if words else (
            f"ended without a word, which may be for want of memory; nothing in {self.log}")


@dataclass(frozen=True)
class Wanted:
    """A file that is made of a scan, by its last step."""

    scan: str
    result: str
    steps: tuple

    def missing_step(self):
        """The first whose file is not there: what later ones made is of another run."""
        return next((step for step in self.steps if not step.result.exists()), None)


class Plan:
    """Of a configuration, for the folder of the workflow; by default the one it is made in.
    What its kinds add: `wanted`, `files`."""

    def __init__(self, config, out=None):
        self.config = config
        self.out = out or Path.cwd()
        self.targets = config["targets"]
        self.threads = config["threads"]
        # Whether to summarize without the scans that failed.
        self.partial = config.get("partial", False)

    @cached_property
    def scans(self):
        """As they were when the run began: jobs do not look for them again."""
        return [Scan(each["name"], Path(each["path"]), each["is_scannet"])
                for each in self.config["scans"]]

    @cached_property
    def version(self):
        return Programs(Path(self.config["programs"]), self.threads).version()

    def wanted(self, target):
        """The files that the summary of a target is made of."""
        raise NotImplementedError

    def files(self, target):
        """Those of the summary whose names are known before."""
        raise NotImplementedError

    def step(self, result, log):
        return Step(self.out / result, self.out / log)

    def missing(self, target):
        """For each scan that lacks a file, the step that should have made the first of those."""
        first = {}
        for each in self.wanted(target):
            step = each.missing_step()
            if step:
                first.setdefault(each.scan, step)
        return first

    def left_out(self, target):
        """The scans that a summary does without."""
        return list(self.missing(target)) if self.partial else []

    def results(self, target):
        """The files that a summary reads."""
        left_out = self.left_out(target)
        return [each.result for each in self.wanted(target) if each.scan not in left_out]


def configuration(path, partial):
    """What a Snakefile hands to a summary."""
    return read_json(Path(path)) | {"partial": partial == "True"}


def listed_scans(dataset, out, count):
    """The scans of a dataset, or so many of them, as a configuration has them."""
    scans = scans_of(dataset, out)
    if not scans:
        sys.exit(f"{dataset}: holds no scan; PCD or PLY files, or folders of scans of S3DIS or "
                 "ScanNet are needed")
    for scan in scans:
        require_fit(str(scan.path), "{}\\", "its path")
        require_fit(scan.name, ",=:", f"{scan.path}: its name in the dataset")
    return [asdict(scan) | {"path": str(scan.path)} for scan in spread(scans, count)]


def require_fit(text, unfit, what):
    """Snakemake has wildcards in braces, and names a job of a cluster by what they stand for."""
    if set(text) & set(unfit) or not text.isprintable():
        shown = text.encode(errors="backslashreplace").decode()
        sys.exit(f"{shown}: {what} must be printable, in UTF-8, and without {' '.join(unfit)}")
