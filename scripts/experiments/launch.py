# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Start Snakemake on a plan, and tell which scans failed; what both command lines share.

import argparse
import contextlib
import fcntl
import json
import os
import re
import signal
import subprocess
import sys
from pathlib import Path

from plan import FAILED
from report import write_whole
from scans import scan_at

CONFIG = "config.json"
# A scan that fails fails alone.
HABITS = ("--keep-going", "--scheduler", "greedy")
# What a killed run left half done is done again. Jobs of a cluster have gone on without it:
# Snakemake takes up those that run, and what there is appeared whole.
HERE, ON_A_CLUSTER = "--rerun-incomplete", "--ignore-incomplete"


def at_least_one(text):
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"'{text}'; it must be a whole number, at least 1")
    return int(text)


def parser_for(script, description):
    """Of what both workflows take."""
    parser = argparse.ArgumentParser(
        prog=script, allow_abbrev=False, description=description,
        epilog="What else there is goes to Snakemake: -n (a dry run), --dag, --jobs N (on a "
        "cluster), --forcerun ...; it comes after OUT_FOLDER.")
    parser.add_argument("--cores", metavar="N", type=at_least_one,
                        help="cores of this machine; default: all")
    parser.add_argument("--threads", metavar="N", type=at_least_one, default=1,
                        help="cores that a job takes; default 1")
    parser.add_argument("--scans", metavar="N", type=at_least_one,
                        help="so many of the scans, evenly over the list; default: all")
    parser.add_argument("--profile", metavar="FOLDER",
                        help="of Snakemake, for a cluster; a folder, or a name that it knows")
    parser.add_argument("--programs", metavar="FOLDER", type=Path, required=True,
                        help=argparse.SUPPRESS)
    return parser


def add_folders(parser):
    parser.add_argument("dataset", metavar="DATASET_FOLDER", type=Path,
                        help="rooms of S3DIS, scans of ScanNet, PCD or PLY files, at any depth")
    parser.add_argument("out", metavar="OUT_FOLDER", type=Path)


def read_options(parser, arguments):
    """Gives ours, and those of Snakemake."""
    options, others = parser.parse_known_args(arguments)
    dataset, out = (Path(os.path.abspath(each)) for each in (options.dataset, options.out))
    if not options.dataset.exists():
        parser.error(f"{options.dataset}: there is no such folder")
    if not options.dataset.is_dir() and not scan_at(dataset, dataset.name):
        parser.error(f"{options.dataset}: is no folder, PCD or PLY file")
    if out == dataset or (out.exists() and not out.is_dir()):
        parser.error(f"{options.out}: OUT_FOLDER must be a folder of its own")
    inside = next((each for each in out.parents if scan_at(each, each.name)), None)
    if inside:
        parser.error(f"{options.out}: OUT_FOLDER must not be in a scan, {inside}")
    return options, others


@contextlib.contextmanager
def only_run(folder):
    """Snakemake's own locks outlive a run that is killed; this one ends with its process, and
    with a Snakemake that outlives ours."""
    with open(folder / "lock", "w", encoding="utf-8") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            sys.exit(f"{folder}: another run works in this folder; wait for its end")
        yield lock.fileno()


class Snakemake:
    """Snakemake on a Snakefile beside this file, for a folder."""

    def __init__(self, snakefile, folder, lock):
        self.options = ["--nolock",
                        "--snakefile", str(Path(__file__).with_name(snakefile)),
                        "--directory", str(folder), "--configfile", str(folder / CONFIG),
                        *HABITS]
        self.lock = lock
        self.stopped = False

    def run(self, targets=(), more=()):
        """To its end; gives its exit code."""
        # Targets come first: after others, options that take several values would take them.
        command = [sys.executable, "-BP", "-m", "snakemake", *targets, *self.options, *more]
        process = subprocess.Popen(command, pass_fds=[self.lock])

        def stop(number, frame):
            self.stopped = True
            # Ctrl-C reaches Snakemake without us.
            if number == signal.SIGTERM:
                process.terminate()

        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, stop)
        return process.wait()


def says(others, *names):
    """Whether there is one of these options among those of Snakemake."""
    return any(re.fullmatch(rf"{name}(=.*)?", word) for word in others for name in names)


def options_for_place(options, others):
    """What depends on where jobs run."""
    on_a_cluster = options.profile or says(others, "--cluster")
    words = [ON_A_CLUSTER if on_a_cluster else HERE]
    if options.profile:
        # Snakemake looks for its scripts when it is in OUT_FOLDER.
        folder = os.path.abspath(options.profile)
        words += ["--profile", folder if os.path.isdir(folder) else options.profile]
    # A number of jobs is one of cores where there is no cluster.
    if options.cores or not (on_a_cluster or says(others, r"-j\d*", "--jobs")):
        words += ["--cores", str(options.cores or "all")]
    return words


def launch(make_plan, snakefile, config, options, others):
    """Gives the exit code."""
    out = Path(os.path.abspath(options.out))
    out.mkdir(parents=True, exist_ok=True)
    with only_run(out) as lock:
        (out / FAILED).unlink(missing_ok=True)
        write_whole(out / CONFIG, json.dumps(config, indent=1).encode())
        snakemake = Snakemake(snakefile, out, lock)
        code = snakemake.run(more=[*options_for_place(options, others), *others])
        if snakemake.stopped and code != 0:
            print("Stopped. The same command goes on where it was.", file=sys.stderr)
            return 1
        if code < 0:
            print(f"Snakemake was ended by signal {-code}.", file=sys.stderr)
            return 1
        if (out / FAILED).exists():
            tell_failures(make_plan(config, out), snakemake)
        return code


def tell_failures(plan, snakemake):
    """The summaries of the scans that are done, and a list of the others."""
    missing = {target: plan.missing(target) for target in plan.targets}
    incomplete = [target for target in plan.targets if missing[target]]
    some_done = [target for target in incomplete if len(missing[target]) < len(plan.scans)]
    for target in set(incomplete) - set(some_done):
        for file in plan.files(target):
            (plan.out / file).unlink(missing_ok=True)
    if some_done:
        snakemake.run(some_done, ["--cores", "1", HERE, "--config", "partial=True"])
    failures = [f"{scan} ({target}): {each.reason()}"
                for target in plan.targets for scan, each in missing[target].items()]
    if failures:
        print(f"{len(failures)} failed; they are not in the tables:", file=sys.stderr)
        for failure in failures:
            print(f"  {failure}", file=sys.stderr)
