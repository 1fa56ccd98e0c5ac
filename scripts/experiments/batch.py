# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The command line of a tool on every scan of a folder; scripts/batch.sh starts this.

import argparse
import csv
import os
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

from batch_plan import TOOLS, BatchPlan
from launch import add_folders, launch, parser_for, read_options
from plan import listed_scans


def options_file(text):
    """Words by tool. Each line is a tool and its options; # begins a comment."""
    words_of = {}
    try:
        lines = Path(text).read_text(encoding="utf-8").splitlines()
        for number, line in enumerate(lines, 1):
            # --option=value as two words, as --option value is.
            tool, *words = [part for word in shlex.split(line, comments=True)
                            for part in (word.split("=", 1) if word.startswith("--") else [word])
                            ] or [None]
            if tool is None:
                continue
            if tool not in TOOLS or tool in words_of:
                raise ValueError(f"line {number}: '{tool}' is not expected here; a line begins "
                                 f"with {', '.join(TOOLS)}, each once")
            words_of[tool] = words
    except OSError as error:
        raise argparse.ArgumentTypeError(f"{text}: {error.strerror}") from None
    except ValueError as error:
        raise argparse.ArgumentTypeError(f"{text}: {error}") from None
    return words_of


def read_command_line(arguments):
    parser = parser_for(
        "batch.sh", "Run a tool on every scan of a folder, by Snakemake. What is done is kept in "
        "OUT_FOLDER and not done again.")
    parser.add_argument("tool", metavar="TOOL", choices=[*TOOLS, "all"],
                        help=", ".join([*TOOLS, "all"]))
    add_folders(parser)
    parser.add_argument("--options", metavar="FILE", type=options_file, default={},
                        help="options of the tools, a line for each tool: segment --seeds 50")
    return parser, *read_options(parser, arguments)


def scans_in(summary):
    """How many it has rows for, if it is there."""
    if not summary.exists():
        return 0
    with open(summary, newline="", encoding="utf-8") as file:
        return sum(1 for _ in csv.DictReader(file))


def check_options(programs, words_of):
    """Gives what a tool says of its options, which shows on a scan that is not there."""
    with tempfile.TemporaryDirectory() as folder:
        nothing = f"{folder}/nothing.pcd"
        outputs = ["--output-dir", folder, "--summary", f"{folder}/a.csv", "--report", "{}.json",
                   "--threads", "1", "--quiet"]
        calls = {"segment": [nothing, "--cloud-format", "pcd", *outputs],
                 "abstract": [nothing, *outputs],
                 "evaluate": [nothing, nothing, "--csv", f"{folder}/a.csv", "--report",
                              f"{folder}/a.json", "--quiet"]}
        for tool, words in words_of.items():
            done = subprocess.run([programs / f"pcl_cid_{tool}", *calls[tool], *words],
                                  capture_output=True, text=True, errors="replace")
            if done.returncode == 2:
                return done.stderr.strip()
            # It fails on the one scan, and knows of no other.
            if done.returncode == 0 or scans_in(Path(folder, "a.csv")) > 1:
                return f"{tool}: its line must have options of its work on a scan only"
    return None


def main(arguments):
    parser, options, others = read_command_line(arguments)
    wrong = check_options(options.programs, options.options)
    if wrong:
        parser.error(wrong)
    config = {
        "dataset": os.path.abspath(options.dataset),
        "programs": os.path.abspath(options.programs),
        "targets": list(TOOLS) if options.tool == "all" else [options.tool],
        "scans": listed_scans(options.dataset, options.out, options.scans),
        **{name: getattr(options, name) for name in ("options", "threads")}}
    wrong = BatchPlan(config, options.out).same_names()
    if wrong:
        sys.exit(wrong)
    sys.exit(launch(BatchPlan, "batch.smk", config, options, others))


if __name__ == "__main__":
    main(sys.argv[1:])
