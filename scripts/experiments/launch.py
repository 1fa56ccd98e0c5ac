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
import shutil
import signal
import subprocess
import sys
from pathlib import Path

from plan import FAILED
from report import write_whole

CONFIG = "config.json"
# A scan that fails fails alone; what a killed run left half done is done again.
HABITS = ("--keep-going", "--rerun-incomplete", "--scheduler", "greedy", "--quiet", "rules")


def at_least_one(text):
    number = int(text)
    if number < 1:
        raise ValueError
    return number


def parser_for(script, description):
    """Of what both workflows take."""
    parser = argparse.ArgumentParser(
        prog=script, allow_abbrev=False, description=description,
        epilog="What else there is goes to Snakemake: -n (a dry run), --dag, --profile FOLDER, "
        "--jobs N (on a cluster), --forcerun ...; it comes after OUT_FOLDER.")
    parser.add_argument("--cores", metavar="N", type=at_least_one,
                        help="cores of this machine; default: all")
    parser.add_argument("--threads", metavar="N", type=at_least_one, default=1,
                        help="cores that a job takes; default 1")
    parser.add_argument("--scans", metavar="N", type=at_least_one,
                        help="so many of the scans, evenly over the list; default: all")
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
    if not options.dataset.exists():
        parser.error(f"{options.dataset}: there is no such folder")
    return options, others


@contextlib.contextmanager
def only_run(folder):
    """Snakemake's own locks outlive a run that is killed; this one ends with its process, and
    with a Snakemake that outlives ours."""
    with open(folder / "lock", "w", encoding="utf-8") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            sys.exit(f"{folder}: another run works in this folder; wait for its end")
        yield lock.fileno()


class Snakemake:
    """Snakemake on a Snakefile beside this file, in the working directory."""

    def __init__(self, snakefile, options, lock):
        self.options = ["--nolock",
                        "--snakefile", str(Path(__file__).with_name(snakefile)),
                        "--directory", os.getcwd(), "--configfile", os.path.abspath(CONFIG),
                        *HABITS, *options]
        self.lock = lock
        self.stopped = False

    def run(self, targets=(), more=()):
        """To its end; gives its exit code."""
        # Targets come first: after others, options that take several values would take them.
        command = [sys.executable, "-B", "-m", "snakemake", *targets, *self.options, *more]
        process = subprocess.Popen(command, pass_fds=[self.lock])

        def stop(number, frame):
            self.stopped = True
            # Ctrl-C reaches Snakemake without us.
            if number == signal.SIGTERM:
                process.terminate()

        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, stop)
        return process.wait()


def cores(options, others):
    """A number of jobs is one of cores where there is no cluster."""
    if any(word.startswith(("-j", "--jobs")) for word in others) and not options.cores:
        return []
    return ["--cores", str(options.cores or "all")]


def launch(make_plan, snakefile, config, options, others):
    """Gives the exit code."""
    options.out.mkdir(parents=True, exist_ok=True)
    os.chdir(options.out)
    with only_run(Path.cwd()) as lock:
        shutil.rmtree("work", ignore_errors=True)  # of a run that was killed
        Path(FAILED).unlink(missing_ok=True)
        write_whole(Path(CONFIG), json.dumps(config, indent=1).encode())
        snakemake = Snakemake(snakefile, [*cores(options, others), *others], lock)
        code = snakemake.run()
        if snakemake.stopped:
            print("Stopped. The same command goes on where it was.", file=sys.stderr)
            return 1
        if os.path.exists(FAILED):
            tell_failures(make_plan(config), snakemake)
        return code


def tell_failures(plan, snakemake):
    """The summaries of the scans that are done, and a list of the others."""
    missing = {target: plan.missing(target) for target in plan.targets}
    some_done = [target for target in plan.targets
                 if missing[target] and len(missing[target]) < len(plan.scans)]
    if some_done:
        snakemake.run(some_done, ["--config", "partial=True"])
    failures = [f"{scan} ({target}): {each.reason()}"
                for target in plan.targets for scan, each in missing[target].items()]
    if failures:
        print(f"{len(failures)} failed; they are not in the tables:", file=sys.stderr)
        for failure in failures:
            print(f"  {failure}", file=sys.stderr)
