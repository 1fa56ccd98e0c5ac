#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The table of refused places in doc/hulls.md: hulls by CID and by hull of any scans, for
# many numbers of hulls, measured by cid_refused. A scan is a file, seen from the pose in
# it, or FILE=VIEWPOINTS.

import argparse
import csv
import subprocess
import tempfile
from pathlib import Path

RULES = ["cid", "hull"]


def make_hulls(tools, scan, viewpoints, rule, number, radius, path):
    command = [tools / "pcl_cid_abstract", scan, path, "--parts", number, "--merging", rule,
               "--quiet"]
    if rule == "cid":
        command += ["--seeds", max(100, number)]
    else:
        command += ["--robot-radius", radius, "--viewpoints", viewpoints or "cloud"]
    subprocess.run([str(word) for word in command], check=True)


def measure(tools, scan, viewpoints, hulls, arguments):
    """The rows of cid_refused for some files of hulls."""
    table = hulls[0].with_name("refused.csv")
    command = [tools / "cid_refused", scan, *hulls, "--robot-radius", arguments.robot_radius,
               "--csv", table]
    command += ["--viewpoints", viewpoints] if viewpoints else ["--viewpoint-of-cloud"]
    if viewpoints:
        command += ["--max-elevation-sine", arguments.max_elevation_sine]
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)
    with open(table, encoding="utf-8") as file:
        return list(csv.DictReader(file))


def row_of(tools, argument, arguments):
    scan, _, viewpoints = argument.partition("=")
    cells = []
    with tempfile.TemporaryDirectory() as folder:
        for number in arguments.hulls:
            hulls = [Path(folder) / f"{rule}_{number}.obj" for rule in RULES]
            for rule, path in zip(RULES, hulls):
                make_hulls(tools, scan, viewpoints, rule, number, arguments.robot_radius, path)
            rows = measure(tools, scan, viewpoints, hulls, arguments)
            missed = [name for name in rows[0] if name.startswith("missed")]
            if any(float(row[name]) > 0 for row in rows for name in missed):
                raise SystemExit(f"{scan}: {number} hulls miss points")
            cells.append(" / ".join(f"{float(row['refused_percent']):.1f}" for row in rows))
    return f"| {Path(scan).name} | " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description="Refused places in %, by CID / by hull.")
    parser.add_argument("scans", nargs="+", help="FILE or FILE=VIEWPOINTS")
    parser.add_argument("--tools", type=Path, default=Path("build/release/bin"))
    parser.add_argument("--hulls", type=int, nargs="+", default=[15, 30, 60, 120, 240])
    parser.add_argument("--robot-radius", type=float, default=0.15, help="metres")
    parser.add_argument("--max-elevation-sine", type=float, default=0.5,
                        help="of the scanners in VIEWPOINTS; default 0.5, the generator's")
    arguments = parser.parse_args()
    print("| scan | " + " | ".join(f"{number} hulls" for number in arguments.hulls) + " |")
    print("|---" * (1 + len(arguments.hulls)) + "|")
    for argument in arguments.scans:
        print(row_of(arguments.tools, argument, arguments), flush=True)


if __name__ == "__main__":
    main()
