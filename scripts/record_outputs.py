#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# A record of all that the tools put out, to show that a change of the code has not changed
# one byte of it.
#
# usage: record_outputs.py make RECORD.json [options]      before the change
#        record_outputs.py compare RECORD.json [options]   after it; exit code 1 for differences
#
# Each tool runs in the paper's setting, with its defaults, and with as many options as go
# together, on the sample scan, on the scans of a folder, and on small ones that are made here:
# one for each format, and degenerate ones, whose error messages are outputs, too. With a dozen
# scans of 100,000 to 400,000 points this takes about five minutes on two free cores.
#
# Times, peak memory and the version are left out: these may differ. The tools run in a new
# temporary folder each time, so an output that depended on where it is written would show up
# as a difference.

import argparse
import json
import shutil
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from itertools import zip_longest
from pathlib import Path

from recorded_runs import TOOLS, runs_of_command_lines, runs_on_scan
from recorded_scans import PROJECT, scans_to_run

# How many differences of one file are listed.
LISTED = 5


# Making the record


class Recording:
    """Runs everything on all scans, some of them at a time."""

    def __init__(self, options, folder):
        self._programs = options.bin.resolve()
        self._folder = folder
        small_folder = folder / "small scans"
        small_folder.mkdir()
        self._scans = scans_to_run(options.scans, small_folder, options.only)
        self._jobs = options.jobs
        self._keep = options.keep is not None
        self._with_command_lines = options.only in "command lines"

    def make(self):
        with ThreadPoolExecutor(self._jobs) as pool:
            record = dict(zip((scan.name for scan in self._scans),
                              pool.map(self._record_scan, self._scans)))
        if self._with_command_lines:
            record["command lines"] = runs_of_command_lines(
                self._programs, self._folder_for("command lines"))
        return record

    def _folder_for(self, name):
        folder = self._folder / name
        folder.mkdir()
        return folder

    def _record_scan(self, scan):
        begun = time.monotonic()
        folder = self._folder_for(scan.name)
        records = runs_on_scan(scan, self._programs, folder)
        if not self._keep:
            shutil.rmtree(folder)
        print(f"{scan.name}: {len(records)} runs, {time.monotonic() - begun:.0f} s",
              file=sys.stderr)
        return records


def make_record(options):
    if options.keep is not None:
        if options.keep.exists():
            sys.exit(f"{options.keep} is there already: give --keep a new folder")
        options.keep.mkdir(parents=True)
        return Recording(options, options.keep.resolve()).make()
    with tempfile.TemporaryDirectory() as folder:
        return Recording(options, Path(folder)).make()


def print_summary(record):
    runs = [run for of_scan in record.values() for run in of_scan.values()]
    failed = [run for run in runs if run["exit code"] != 0]
    files = sum(len(run["files"]) for run in runs)
    print(f"Inputs: {len(record)}, runs: {len(runs)}, output files: {files}; "
          f"runs that ended with an error, which is recorded, too: {len(failed)}")


# Comparing


def differing_values(was, now, place=""):
    """Where two JSON values differ, and how."""
    if isinstance(was, dict) and isinstance(now, dict):
        for key in was | now:
            inner = f"{place}.{key}" if place else key
            if key not in now:
                yield f"{inner} is gone"
            elif key not in was:
                yield f"{inner} is new"
            else:
                yield from differing_values(was[key], now[key], inner)
    elif isinstance(was, list) and isinstance(now, list):
        if len(was) != len(now):
            yield f"{place} had {len(was)} elements, has {len(now)}"
        for i, (old, new) in enumerate(zip(was, now)):
            yield from differing_values(old, new, f"{place}[{i}]")
    elif was != now:
        yield f"{place} was {json.dumps(was)}, is {json.dumps(now)}"


def differences_of_file(was, now):
    if was["sha256"] == now["sha256"]:
        return []
    if "values" not in was or "values" not in now:
        return [f"SHA-256 was {was['sha256'][:12]}, is {now['sha256'][:12]}"]
    return (list(differing_values(was["values"], now["values"]))
            or ["the values are equal, but their order or how they are printed is not"])


def differences_of_lines(was, now):
    """Where two lists of lines differ; None stands for a missing line."""
    return [f"line {number} was {old!r}, is {new!r}"
            for number, (old, new) in enumerate(zip_longest(was, now), start=1) if old != new]


def differences_by_key(was, now, differences):
    """For each key whose values differ: the key, and what `differences` says of them."""
    for key in was | now:
        if key not in now:
            yield key, ["is gone"]
        elif key not in was:
            yield key, ["is new"]
        elif found := differences(was[key], now[key]):
            yield key, found


def differences_of_run(was, now):
    """Lines of text, each with its place in the run."""
    places = [(key, [f"was {was[key]}, is {now[key]}"])
              for key in ["command", "exit code"] if was[key] != now[key]]
    places += [(key, differences_of_lines(was[key], now[key]))
               for key in ["standard output", "standard error"]]
    places += differences_by_key(was["files"], now["files"], differences_of_file)
    lines = []
    for place, found in places:
        lines += [f"{place}: {text}" for text in found[:LISTED]]
        if len(found) > LISTED:
            lines.append(f"{place}: and {len(found) - LISTED} more differences")
    return lines


def differences_of_scan(was, now):
    return [f"{run}: {text}"
            for run, found in differences_by_key(was, now, differences_of_run)
            for text in found]


def print_differences(was, now):
    """Print the differences; return whether there are any."""
    found = [f"{scan}: {text}"
             for scan, texts in differences_by_key(was, now, differences_of_scan)
             for text in texts]
    print("\n".join(found) if found else "All outputs are equal.")
    return bool(found)


# Command line


def parse_arguments():
    parser = argparse.ArgumentParser(
        description="Record all that the tools put out, or compare it with such a record.")
    parser.add_argument("action", choices=["make", "compare"])
    parser.add_argument("record", type=Path, metavar="RECORD.json")
    parser.add_argument("--bin", type=Path, default=PROJECT / "build" / "release" / "bin",
                        help="folder of the tools; default build/release/bin")
    parser.add_argument("--scans", type=Path, default=PROJECT.parent / "shared" / "data",
                        help="folder of PCD files; default ../shared/data")
    parser.add_argument("--only", default="", metavar="TEXT",
                        help="only inputs whose name contains this")
    parser.add_argument("--keep", type=Path, metavar="DIR",
                        help="new folder in which all outputs stay")
    parser.add_argument("--jobs", type=int, default=2, metavar="N",
                        help="scans that are worked on at a time; default 2")
    return parser.parse_args()


def require_tools(folder):
    missing = [tool for tool in TOOLS if not (folder / tool).is_file()]
    if missing:
        sys.exit(f"{folder} lacks {', '.join(missing)}: build them, or give --bin")


def main():
    options = parse_arguments()
    require_tools(options.bin)
    if options.action == "make":
        record = make_record(options)
        options.record.write_text(json.dumps(record) + "\n")
        print_summary(record)
        return
    before = json.loads(options.record.read_text())
    before = {name: runs for name, runs in before.items() if options.only in name}
    now = make_record(options)
    print_summary(now)
    sys.exit(1 if print_differences(before, now) else 0)


if __name__ == "__main__":
    main()
