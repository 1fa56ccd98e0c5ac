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
import csv
import hashlib
import json
import os
import random
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from itertools import zip_longest
from pathlib import Path

PROJECT = Path(__file__).resolve().parent.parent
TOOLS = ["pcl_cid_segment", "pcl_cid_abstract", "pcl_cid_evaluate"]
# Two scans are worked on at a time, so most runs have one thread; the defaults have all.
PAPER = "--threads 1 --density off --isolated-neighbors 0 --blind-spot off --subsample 20000"

# JSON up to this size is kept whole, so that a comparison can name the values that differ.
LARGEST_KEPT_JSON = 200_000  # bytes
# How many differences of one file are listed.
LISTED = 5


# Scans


@dataclass(frozen=True)
class Scan:
    """What the tools run on."""

    name: str  # in the record
    path: Path  # a file, or a folder of S3DIS or ScanNet
    link: str  # what it is called where the tools run
    fields: frozenset
    is_small: bool = False

    @property
    def has_label(self):
        return "label" in self.fields

    @property
    def has_semantic(self):
        return "semantic" in self.fields

    @property
    def has_color(self):
        return bool(self.fields & {"rgb", "rgba", "red"})

    @property
    def is_quick(self):
        return self.is_small or self.name == "room.pcd"

    @property
    def is_scannet(self):
        return any(self.path.glob("*_vh_clean_2.ply"))

    @property
    def class_table(self):
        """The option that says where it is, for a scan that needs one."""
        return f"--class-table {self.link}/{CLASS_TABLE}" if self.is_scannet else ""


def fields_of(path):
    """The names that the header of a PCD or PLY file gives."""
    header = path.read_bytes()[:4096].decode("latin-1")
    if path.suffix == ".ply":
        return frozenset(re.findall(r"^property \w+ (\w+)$", header, re.MULTILINE))
    names = re.search(r"^FIELDS (.*)$", header, re.MULTILINE)
    return frozenset(names.group(1).split() if names else [])


def scan_file(path, is_small=False):
    return Scan(path.name, path, "scan" + path.suffix, fields_of(path), is_small)


def scan_folder(path):
    """A small one of S3DIS or ScanNet; its name is part of its format."""
    return Scan(path.name, path, path.name, frozenset({"rgb", "label", "semantic"}), True)


def scans_to_run(given_folder, small_folder, name_part):
    """All scans whose name contains a text, those with the most work first."""
    files = [PROJECT / "data" / "room.pcd"]
    if given_folder.is_dir():
        files += sorted(given_folder.glob("*.pcd"))
    else:
        print(f"There is no folder {given_folder}: the scans in it are left out.", file=sys.stderr)
    scans = [scan_file(path) for path in files]
    scans.sort(key=lambda scan: scan.path.stat().st_size, reverse=True)
    scans += small_scans(small_folder)
    return [scan for scan in scans if name_part in scan.name]


# Small scans


# What PCD, PLY and Python's struct call a type.
PCD_TYPES = {"f": ("F", 4), "d": ("F", 8), "I": ("U", 4)}
PLY_TYPES = {"f": "float", "d": "double", "I": "uint", "B": "uchar"}

XYZ = {"x": "f", "y": "f", "z": "f"}
XYZ_DOUBLE = {"x": "d", "y": "d", "z": "d"}
LABELS = {"label": "I", "semantic": "I"}
COLORS = {"red": "B", "green": "B", "blue": "B"}

# Classes of S3DIS and labels of ScanNet for the things in the furnished corner.
FLOOR, WALL, TABLE = (1, 2), (2, 3), (3, 8)
S3DIS_NAMES = {1: "floor_1", 2: "wall_1", 3: "table_1"}
SCANNET_NAMES = {1: "floor", 2: "wall", 3: "coffee table"}
CLASS_TABLE = "scannetv2-labels.combined.tsv"
SCANNET_CLASSES = "raw_category\tnyu40id\nwall\t1\nfloor\t2\ncoffee table\t7\n"


def furnished_corner():
    """Floor, wall and table of a room: points with x, y, z, label and semantic."""
    draw = random.Random(1)

    def grid(columns, rows, place, thing):
        def noisy(value):
            return round(value + draw.uniform(-0.01, 0.01), 4)

        return [
            (*map(noisy, place(0.1 * i, 0.1 * j)), *thing)
            for i in range(columns)
            for j in range(rows)
        ]

    return (
        grid(20, 18, lambda a, b: (a, b, 0.0), FLOOR)
        + grid(18, 12, lambda a, b: (0.0, a, b), WALL)
        + grid(9, 7, lambda a, b: (1.0 + a, 0.9 + b, 0.7), TABLE)
        + grid(9, 7, lambda a, b: (1.0 + a, 0.9, b), TABLE)
    )


def hollow_floor():
    """What a scanner sees of a floor that goes on under it: nothing near its own foot."""
    places = [(0.15 * i, 0.15 * j) for i in range(-20, 21) for j in range(-20, 21)]
    return [(x, y, 0.0) for x, y in places if x * x + y * y > 1.5]


def colors_of(label):
    return (40 * label, 80 * label, 255 - 60 * label)


def packed(byte_order, fields, rows):
    row_format = struct.Struct(byte_order + "".join(fields.values()))
    return b"".join(row_format.pack(*row) for row in rows)


def text_lines(rows):
    return "".join(" ".join(map(str, row)) + "\n" for row in rows).encode()


def write_pcd(path, fields, rows, data="ascii", height=1, viewpoint="0 0 0 1 0 0 0"):
    types = [PCD_TYPES[letter] for letter in fields.values()]
    header = f"""VERSION 0.7
FIELDS {" ".join(fields)}
SIZE {" ".join(str(size) for _, size in types)}
TYPE {" ".join(letter for letter, _ in types)}
COUNT {" ".join("1" for _ in types)}
WIDTH {len(rows) // height}
HEIGHT {height}
VIEWPOINT {viewpoint}
POINTS {len(rows)}
DATA {data}
"""
    body = text_lines(rows) if data == "ascii" else packed("<", fields, rows)
    path.write_bytes(header.encode() + body)


def write_ply(path, fields, rows, data="ascii"):
    properties = "".join(f"property {PLY_TYPES[t]} {name}\n" for name, t in fields.items())
    header = f"ply\nformat {data} 1.0\nelement vertex {len(rows)}\n{properties}end_header\n"
    orders = {"binary_little_endian": "<", "binary_big_endian": ">"}
    body = text_lines(rows) if data == "ascii" else packed(orders[data], fields, rows)
    path.write_bytes(header.encode() + body)


def write_degenerate_scans(folder):
    nan = float("nan")
    corner = [row[:3] for row in furnished_corner()]
    grid = [(0.05 * i, 0.05 * j, 1.0) for i in range(30) for j in range(30)]
    holed = [(nan, nan, nan) if i % 3 == 0 else row for i, row in enumerate(grid)]
    write_pcd(folder / "one_point.pcd", XYZ, [(1, 2, 3)])
    write_pcd(folder / "three_points.pcd", XYZ, [(0, 0, 0), (1, 0, 0), (0, 1, 0)])
    write_pcd(folder / "equal_points.pcd", XYZ, [(1, 2, 3)] * 50)
    write_pcd(folder / "points_on_a_line.pcd", XYZ, [(0.1 * i, 0, 0) for i in range(60)])
    write_pcd(folder / "flat_grid.pcd", XYZ, grid, "binary")
    write_pcd(folder / "nan_among_points.pcd", XYZ, holed, height=30)
    write_pcd(folder / "no_finite_point.pcd", XYZ, [(nan, nan, nan)] * 9)
    write_pcd(folder / "no_point.pcd", XYZ, [])
    write_pcd(folder / "far_from_origin.pcd", XYZ_DOUBLE,
              [(x + 524288.25, y + 4194304.5, z + 102.125) for x, y, z in corner], "binary")
    write_pcd(folder / "blind_spot.pcd", XYZ, hollow_floor(), viewpoint="0 0 1.5 1 0 0 0")
    whole = (folder / "flat_grid.pcd").read_bytes()
    (folder / "cut_off.pcd").write_bytes(whole[: len(whole) // 2])


def write_scans_of_each_format(folder):
    corner = furnished_corner()
    colored = [row[:3] + colors_of(row[3]) + row[3:] for row in corner]
    write_pcd(folder / "text.pcd", XYZ | LABELS, corner)
    write_ply(folder / "text.ply", XYZ | COLORS | LABELS, colored)
    write_ply(folder / "little_endian.ply", XYZ | COLORS | LABELS, colored,
              "binary_little_endian")
    write_ply(folder / "big_endian.ply", XYZ_DOUBLE, [row[:3] for row in corner],
              "binary_big_endian")


def write_s3dis_room(folder):
    (folder / "Annotations").mkdir(parents=True)
    corner = furnished_corner()
    for label, name in S3DIS_NAMES.items():
        rows = [row[:3] + colors_of(label) for row in corner if row[3] == label]
        (folder / "Annotations" / f"{name}.txt").write_bytes(text_lines(rows))
    everything = [row[:3] + colors_of(row[3]) for row in corner]
    (folder / f"{folder.name}.txt").write_bytes(text_lines(everything))


def write_scannet_scan(folder):
    folder.mkdir()
    corner = furnished_corner()
    colored = [row[:3] + colors_of(row[3]) for row in corner]
    segments = {"segIndices": [10 * row[3] for row in corner]}
    groups = [{"objectId": label - 1, "label": name, "segments": [10 * label]}
              for label, name in SCANNET_NAMES.items()]
    beginning = str(folder / folder.name)
    write_ply(Path(beginning + "_vh_clean_2.ply"), XYZ | COLORS, colored,
              "binary_little_endian")
    Path(beginning + "_vh_clean_2.0.010000.segs.json").write_text(json.dumps(segments))
    Path(beginning + ".aggregation.json").write_text(json.dumps({"segGroups": groups}))
    (folder / CLASS_TABLE).write_text(SCANNET_CLASSES)


def small_scans(folder):
    write_degenerate_scans(folder)
    write_scans_of_each_format(folder)
    files = [scan_file(path, is_small=True) for path in sorted(folder.iterdir())]
    room, scene = folder / "room_1", folder / "scene0000_00"
    write_s3dis_room(room)
    write_scannet_scan(scene)
    return files + [scan_folder(room), scan_folder(scene)]


# What a run puts out


def without_times(text):
    """What a tool prints, without what may differ from run to run."""
    text = re.sub(r"\[done, \d+ ms :", "[done :", text)
    return re.sub(r"^(pcl_cid_\w+) \d+\.\d+\.\d+$", r"\1 VERSION", text, flags=re.MULTILINE)


def report_without_times(text):
    """A report without what may differ; the names of its steps stay."""
    def without_numbers(block):
        return re.sub(r": [-+.\de]+", ": 0", block.group())

    text = re.sub(r'^  "seconds": \{[^}]*\}', without_numbers, text, flags=re.MULTILINE)
    text = re.sub(r'^  "peak_memory_bytes": \d+', '  "peak_memory_bytes": 0', text,
                  flags=re.MULTILINE)
    return re.sub(r'^  "version": "[^"]*"', '  "version": ""', text, flags=re.MULTILINE)


def record_of_file(path):
    content = path.read_bytes()
    values = None
    if path.suffix == ".json" and len(content) <= LARGEST_KEPT_JSON:
        text = report_without_times(content.decode())
        content = text.encode()
        values = json.loads(text)
    record = {"sha256": hashlib.sha256(content).hexdigest()}
    return record if values is None else record | {"values": values}


def output_files(folder):
    """The files that a run has written; its inputs are links."""
    return [path for path in sorted(folder.rglob("*"))
            if path.is_file() and not path.is_symlink()]


def lines_of(output):
    return without_times(output.decode(errors="backslashreplace")).splitlines(keepends=True)


def run_tool(program, arguments, folder):
    """Run a tool in a folder, and record what it puts out."""
    done = subprocess.run([program, *arguments], cwd=folder, stdin=subprocess.DEVNULL,
                          capture_output=True, env=os.environ | {"LC_ALL": "C"})
    return {
        "command": " ".join([program.name, *arguments]),
        "exit code": done.returncode,
        "standard output": lines_of(done.stdout),
        "standard error": lines_of(done.stderr),
        "files": {path.relative_to(folder).as_posix(): record_of_file(path)
                  for path in output_files(folder)},
    }


# The runs


class Runs:
    """The runs on one scan, each in a folder of its own, where inputs are links."""

    def __init__(self, scan, programs, folder):
        self.scan = scan
        self.folder = folder
        self.records = {}
        self._programs = programs

    def segment(self, name, arguments, links=None):
        self._run_on_scan("segment", name, arguments, links)

    def abstract(self, name, arguments):
        self._run_on_scan("abstract", name, arguments, None)

    def evaluate(self, name, arguments, links):
        self._run("evaluate", name, arguments, links)

    def output(self, run, file):
        """What an earlier run has written, if it has."""
        return self.folder / run.replace(" ", "_") / file

    def _run_on_scan(self, tool, name, arguments, links):
        link = self.scan.link
        self._run(tool, name, f"{link} {arguments}", {link: self.scan.path} | (links or {}))

    def _run(self, tool, name, arguments, links):
        run = f"{tool} {name}"
        folder = self.output(run, "")
        for link, target in links.items():
            (folder / link).parent.mkdir(parents=True, exist_ok=True)
            (folder / link).symlink_to(target)
        self.records[run] = run_tool(self._programs / f"pcl_cid_{tool}", arguments.split(),
                                     folder)


def proposed_seeds(runs):
    """Rows of the table that the defaults propose; none when that run has failed."""
    table = runs.output("segment defaults", "seeds.csv")
    if not table.exists():
        return []
    with open(table, newline="") as file:
        return list(csv.DictReader(file))


def a_finite_point(runs):
    """The index of a finite point, where there is any."""
    rows = proposed_seeds(runs)
    return rows[-1]["index"] if rows else "0"


def write_labelled_seeds(rows, path):
    """The proposal as an annotator fills it in: labels, some of them 0, some left empty."""
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, ["index", "x", "y", "z", "label"])
        writer.writeheader()
        for number, row in enumerate(rows):
            label = "" if number % 10 == 9 else number % 7
            writer.writerow(row | {"label": label})
    return path


def segment(runs):
    scan = runs.scan
    labels_from = "--labels-from label" if scan.has_label else ""
    color = "--color 0.01" if scan.has_color else ""
    runs.segment("paper", f"labelled.pcd {PAPER} {labels_from} --report report.json")
    runs.segment("defaults", "groups.pcd --propose seeds.csv --report report.json")
    rows = proposed_seeds(runs)
    a_seed = a_finite_point(runs)
    runs.segment(
        "all options",
        "groups.ply --propose seeds.csv --superpoints superpoints.json --seeds 40 "
        "--coverage 0.02 --samples 24 --subsample 30000 --random-seed 7 "
        f"--start-index {a_seed} --density on --density-power 1.5 --isolated-neighbors 8 "
        f"--seeding soft {color} --blind-spot auto --label-type F4 --threads 2 "
        "--report report.json")
    runs.segment(
        "labelled seeds",
        f"labelled.pcd --labels seeds.csv --subsample 20000 {color} --label-type I4 "
        "--threads 1 --report report.json",
        {"seeds.csv": write_labelled_seeds(rows, runs.folder / "labelled_seeds.csv")})
    runs.segment("heat map", f"heat.ply --cid-from {a_seed} --samples 16 --threads 1 "
                 "--quiet --report report.json")
    if scan.has_label:
        runs.segment("labels from a field",
                     "labelled.pcd --labels-from label --threads 1 --report report.json")
    if scan.is_scannet:
        runs.segment("submission", "labelled.ply --labels-from label --threads 1 "
                     f"--scannet-submission submission {scan.class_table}")


def abstract(runs):
    scan = runs.scan
    color = "--color 0.01" if scan.has_color else ""
    # Hulls of many cuts take long on large scans, and so do the seeds that coverage needs.
    curve = "--curve curve.csv" if scan.is_quick else ""
    seeds = "--coverage 0.2" if scan.is_quick else "--seeds 40"
    runs.abstract("paper", f"hulls.obj {PAPER} --parts 30 --report report.json")
    runs.abstract("defaults", "hulls.obj")
    runs.abstract(
        "all options",
        "hulls.ply --parts 12 --group-samples 20 --min-points 5 --labels labels.ply "
        f"--tree tree.json {curve} --min-thickness 0.01 --max-vertices 24 --padding 0.02 "
        "--trim-distance 0.2 --free-distance 0.1 --verify --parts-dir parts "
        "--parts-format obj --urdf scan.urdf --sdf scan.sdf --mjcf scan.xml "
        "--moveit scan.scene --frame map --seeds 40 --coverage 0.02 --samples 24 "
        f"--subsample 30000 --random-seed 7 --start-index {a_finite_point(runs)} --density on "
        f"--density-power 1.5 --isolated-neighbors 8 --seeding soft {color} --blind-spot auto "
        f"--label-type F4 --threads 2 {scan.class_table} "
        "--report report.json")
    runs.abstract(
        "threshold",
        "hulls.stl --threshold 0.05 --seeds 40 --subsample 20000 --labels labels.pcd "
        "--trim-distance 0 --verify --parts-format stl --urdf scan.urdf --threads 1 "
        "--quiet --report report.json")
    runs.abstract(
        "merges",
        f"hulls.obj --merges 15 {seeds} --subsample 20000 --tree tree.json "
        "--max-vertices 8 --mjcf scan.mjcf --parts-dir . --label-type I4 --threads 1")


def write_classes(path):
    """Any label is a class, so labels can stand for classes."""
    path.write_text("".join(f"{number} class {number}\n" for number in range(1, 1001)))
    return path


def evaluate_pair(runs, prediction, truth, truth_link):
    pair = {"prediction.pcd": prediction, truth_link: truth}
    files = f"prediction.pcd {truth_link}"
    runs.evaluate("defaults", files, pair)
    for protocol in ["paper", "scannet", "s3dis"]:
        runs.evaluate(protocol, f"{files} --protocol {protocol} --report report.json "
                      "--csv scores.csv", pair)
    if runs.scan.is_scannet:
        runs.evaluate("class table", f"{files} {runs.scan.class_table} --classes scannet "
                      "--report report.json --quiet", pair)


def evaluate_folders(runs, prediction, truth, truth_link):
    """Several scans at once, with all options."""
    other = runs.output("segment paper", "labelled.pcd")
    # Scans are paired by name; that of a folder of ScanNet is its id.
    name = Path(truth_link).stem
    runs.evaluate(
        "all options",
        "predictions truths --partial --protocol scannet --classes classes.txt "
        "--prediction-field label --semantic-field label "
        f"--truth-field {'semantic' if runs.scan.has_semantic else 'label'} "
        "--report report.json --csv scores.csv",
        {"classes.txt": write_classes(runs.folder / "classes.txt"),
         f"predictions/{name}.pcd": prediction,
         "predictions/second.pcd": runs.output("segment defaults", "groups.pcd"),
         f"truths/{truth_link}": truth,
         "truths/second.pcd": other,
         "truths/third.pcd": other})


def evaluate(runs):
    """Against the true labels where the scan has them, else against other settings."""
    if runs.scan.has_label:
        compared = (runs.output("segment labels from a field", "labelled.pcd"),
                    runs.scan.path, runs.scan.link)
    else:
        compared = (runs.output("segment defaults", "groups.pcd"),
                    runs.output("segment paper", "labelled.pcd"), "truth.pcd")
    evaluate_pair(runs, *compared)
    evaluate_folders(runs, *compared)


def runs_on_scan(scan, programs, folder):
    runs = Runs(scan, programs, folder)
    segment(runs)
    abstract(runs)
    evaluate(runs)
    return runs.records


WRONG_COMMAND_LINES = {
    "pcl_cid_segment": ["scan.pcd out.txt", "scan.pcd out.pcd --seeds 0",
                        "scan.pcd out.pcd --labels a.csv --seeds 5",
                        "scan.pcd out.pcd --cid-from 0 --propose a.csv",
                        "scan.pcd out.pcd --scannet-submission out"],
    "pcl_cid_abstract": ["scan.pcd out.txt", "scan.pcd out.obj --parts 0",
                         "scan.pcd out.obj --parts 3 --merges 4",
                         "scan.pcd out.obj --frame map",
                         "scan.pcd out.obj --urdf scan.xml"],
    "pcl_cid_evaluate": ["scan.pcd scan.pcd --protocol none",
                         "scan.pcd scan.pcd --classes none.txt"],
}


def runs_of_command_lines(programs, folder):
    """Help, version and usage errors; for none of them a scan is read."""
    records = {}
    for tool in TOOLS:
        general = ["--help", "--version", "", "--no-such-option", "none.pcd none.obj",
                   "none.pcd none.pcd"]
        for arguments in general + WRONG_COMMAND_LINES[tool]:
            name = f"{tool} {arguments}".strip()
            records[name] = run_tool(programs / tool, arguments.split(), folder)
    return records


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
