# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The command line of the experiments of the paper; scripts/experiments.sh starts this.

import argparse
import os
import sys

from experiments_plan import EXPERIMENTS, ExperimentsPlan
from launch import add_folders, at_least_one, launch, parser_for, read_options
from peers import METHODS
from plan import listed_scans


def methods(text):
    chosen = text.split(",")
    if not set(chosen) <= set(METHODS):
        raise argparse.ArgumentTypeError(f"'{text}'; it must be some of {','.join(METHODS)}")
    return chosen


def read_command_line(arguments):
    parser = parser_for(
        "experiments.sh", "Run an experiment of the paper on all scans of a dataset, by "
        "Snakemake. What is done is kept in OUT_FOLDER and not done again.")
    parser.add_argument("experiment", metavar="EXPERIMENT", choices=[*EXPERIMENTS, "all"],
                        help=", ".join([*EXPERIMENTS, "all"]))
    add_folders(parser)
    parser.add_argument("--starts", metavar="N", type=at_least_one, default=5,
                        help="random starts; default 5")
    parser.add_argument("--seeds", metavar="K", type=at_least_one, default=100,
                        help="seeds of a scan; default 100")
    parser.add_argument("--methods", metavar="LIST", type=methods, default=list(METHODS),
                        help=f"of peers, with commas between; default {','.join(METHODS)}")
    return read_options(parser, arguments)


def main(arguments):
    options, others = read_command_line(arguments)
    config = {
        "dataset": os.path.abspath(options.dataset),
        "programs": os.path.abspath(options.programs),
        "targets": list(EXPERIMENTS) if options.experiment == "all" else [options.experiment],
        "scans": listed_scans(options.dataset, options.out, options.scans),
        **{name: getattr(options, name) for name in ("starts", "seeds", "methods", "threads")}}
    sys.exit(launch(ExperimentsPlan, "experiments.smk", config, options, others))


if __name__ == "__main__":
    main(sys.argv[1:])
