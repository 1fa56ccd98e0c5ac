# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Measure something on a scan; rules of experiments.smk start this. The result appears whole
# or not at all.

import argparse
import contextlib
import hashlib
import json
import os
import shutil
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

from clicks import annotate
from heatmap import heat_map
from labels import carry_labels
from peers import cid_curve, run_method
from programs import ProgramError, Programs, propagate, remarks_in
from purity import merge_curve
from scans import scan_at
from work import PICTURE, Item


@dataclass(frozen=True)
class Measurement:
    """(item, programs, folder for temporary files) -> result, a dict; may leave a picture."""

    work: Callable
    draws: bool = False

    def files(self, stem):
        """Its result, and the picture beside it."""
        return [stem + ".json"] + ([stem + ".png"] if self.draws else [])


MEASUREMENTS = {
    "propagate": Measurement(propagate),
    "merge": Measurement(merge_curve),
    "heatmap": Measurement(heat_map, draws=True),
    "labels": Measurement(carry_labels, draws=True),
    "curve": Measurement(cid_curve),
    "peers": Measurement(run_method),
    "clicks": Measurement(annotate),
}


def read_command_line():
    parser = argparse.ArgumentParser(allow_abbrev=False)
    parser.add_argument("kind", choices=MEASUREMENTS)
    parser.add_argument("scan", type=Path)
    parser.add_argument("settings", type=json.loads)
    parser.add_argument("result", type=Path)
    parser.add_argument("--programs", type=Path, required=True)
    parser.add_argument("--threads", type=int, required=True)
    return parser.parse_args()


@contextlib.contextmanager
def folder_for(result):
    """For temporary files; what a killed measurement left there is removed first."""
    folder = Path("work") / hashlib.sha256(str(result).encode()).hexdigest()[:16]
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    try:
        yield folder
    finally:
        shutil.rmtree(folder)


def measure(item, programs, result):
    measurement = MEASUREMENTS[item.kind]
    with folder_for(result) as folder:
        measured = measurement.work(item, programs, folder)
        stored = {"remarks": remarks_in(folder), "result": measured}
        new = folder / "result.json"
        new.write_text(json.dumps(stored), encoding="utf-8")
        if measurement.draws:
            os.replace(folder / PICTURE, result.with_suffix(".png"))
        os.replace(new, result)


def main():
    options = read_command_line()
    scan = scan_at(options.scan, options.scan.name)
    if not scan:
        sys.exit(f"{options.scan}: is no scan any more")
    item = Item(scan, options.kind, options.settings)
    try:
        measure(item, Programs(options.programs, options.threads), options.result)
    except (ProgramError, ValueError) as error:  # of others, the text alone may say too little
        sys.exit(str(error))


if __name__ == "__main__":
    main()
