# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The experiments of the paper on a folder of scans; scripts/experiments.sh starts this.

import argparse
import os
import signal
import sys
from pathlib import Path

from clicks import Clicks
from heatmap import HeatMap
from labels import Labels
from noise import Noise
from peers import METHODS, Peers
from programs import Programs
from purity import Purity
from raw import Raw
from report import write_whole
from scans import scans_of, spread
from seeds import SeedSweep
from tables import Tables
from work import Store, do_all

EXPERIMENTS = {each.name: each for each in (Tables(), SeedSweep(), Purity(), Noise(), HeatMap(),
                                            Labels(), Peers(), Raw(), Clicks())}


def at_least_one(text):
    number = int(text)
    if number < 1:
        raise ValueError
    return number


def methods(text):
    chosen = text.split(",")
    if not set(chosen) <= set(METHODS):
        raise ValueError
    return chosen


def read_command_line(arguments):
    parser = argparse.ArgumentParser(
        prog="experiments.sh", allow_abbrev=False,
        description="Run an experiment of the paper on all scans of a dataset. What is done "
        "is kept in OUT_FOLDER and not done again.")
    parser.add_argument("experiment", metavar="EXPERIMENT", choices=[*EXPERIMENTS, "all"],
                        help=", ".join([*EXPERIMENTS, "all"]))
    parser.add_argument("dataset", metavar="DATASET_FOLDER", type=Path,
                        help="rooms of S3DIS, scans of ScanNet, PCD or PLY files, at any depth")
    parser.add_argument("out", metavar="OUT_FOLDER", type=Path)
    parser.add_argument("--jobs", metavar="N", type=at_least_one, default=os.cpu_count(),
                        help="scans worked on at the same time; default: one for each core")
    parser.add_argument("--starts", metavar="N", type=at_least_one, default=5,
                        help="random starts; default 5")
    parser.add_argument("--seeds", metavar="K", type=at_least_one, default=100,
                        help="seeds of a scan; default 100")
    parser.add_argument("--scans", metavar="N", type=at_least_one,
                        help="so many of the scans, evenly over the list; default: all")
    parser.add_argument("--methods", metavar="LIST", type=methods, default=METHODS,
                        help=f"of peers, with commas between; default {','.join(METHODS)}")
    parser.add_argument("--programs", metavar="FOLDER", type=Path, required=True,
                        help=argparse.SUPPRESS)
    options = parser.parse_args(arguments)
    if not options.dataset.is_dir():
        parser.error(f"{options.dataset}: there is no such folder")
    return options


def stop(signal_number, frame):
    raise KeyboardInterrupt


def run(experiment, scans, options, store, programs):
    """All of one experiment; gives the scans that failed, and why."""
    print(f"== {experiment.name}: {len(scans)} scans")
    items = [item for scan in scans for item in experiment.items(scan, options)]
    done, failures = do_all(items, store, programs, options.jobs)
    if done:
        experiment.summarize(done, options, options.out)
        tell_remarks(experiment, [item for item, _ in done], options, store)
        print((options.out / f"{experiment.name}.md").read_text(encoding="utf-8"))
    return failures


def tell_remarks(experiment, items, options, store):
    """Write, each once, what was repaired, left out or assumed when the scans were read."""
    remarks = list(dict.fromkeys(remark for item in items for remark in store.remarks(item)))
    path = options.out / f"{experiment.name}_remarks.txt"
    write_whole(path, "".join(remark + "\n" for remark in remarks).encode())
    if remarks:
        print(f"{len(remarks)} remarks on the scans (what was repaired, left out or assumed), "
              f"with file and line: {path}")


def main(arguments):
    options = read_command_line(arguments)
    scans = spread(scans_of(options.dataset, options.out), options.scans)
    if not scans:
        raise SystemExit(f"{options.dataset}: holds no scan; PCD or PLY files, or folders of "
                         "scans of S3DIS or ScanNet are needed")
    signal.signal(signal.SIGTERM, stop)
    programs = Programs(options.programs, max(1, os.cpu_count() // options.jobs))
    store = Store(options.out, programs.version())
    chosen = EXPERIMENTS.values() if options.experiment == "all" else [
        EXPERIMENTS[options.experiment]]
    failures = {}
    try:
        for experiment in chosen:
            for name, error in run(experiment, scans, options, store, programs).items():
                failures[f"{name} ({experiment.name})"] = error
    except KeyboardInterrupt:
        raise SystemExit("Stopped. The same command goes on where it was.") from None
    if failures:
        print(f"{len(failures)} failed; they are not in the tables:", file=sys.stderr)
        for name, error in failures.items():
            print(f"  {name}: {error}", file=sys.stderr)
        raise SystemExit(1)


if __name__ == "__main__":
    main(sys.argv[1:])
