# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# What the tools are run with for record_outputs.py, and what is kept of a run.

import csv
import hashlib
import json
import os
import re
import subprocess
from pathlib import Path

TOOLS = ["pcl_cid_segment", "pcl_cid_abstract", "pcl_cid_evaluate"]
# Two scans are worked on at a time, so most runs have one thread; the defaults have all.
PAPER = "--threads 1 --paper --subsample 20000"

# JSON up to this size is kept whole, so that a comparison can name the values that differ.
LARGEST_KEPT_JSON = 200_000  # bytes

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
    runs.abstract("paper", f"hulls.obj {PAPER} --seeds 100 --parts 30 --report report.json")
    runs.abstract("defaults", "hulls.obj")
    runs.abstract("hull", "hulls.obj --merging hull --parts 20 --viewpoints cloud --report report.json")
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
