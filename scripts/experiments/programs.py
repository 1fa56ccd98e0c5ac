# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Running the programs, and what a scan is put through.

import json
import subprocess

import paper

# The value of an option that is left to the program.
DEFAULT = "default"


class ProgramError(Exception):
    """A program that failed; the text says what it complained about."""


class Programs:
    """The programs in a folder, each with so many threads."""

    def __init__(self, folder, threads):
        self.folder = folder
        self.threads = threads

    def run(self, program, *arguments):
        """Run it to its end; gives what it printed, and what it remarked."""
        command = [str(self.folder / program), *map(str, arguments)]
        done = subprocess.run(command, capture_output=True, text=True, errors="replace")
        if done.returncode != 0:
            complaint = done.stderr.strip() or f"{program}: ended with {done.returncode}"
            raise ProgramError(complaint.splitlines()[-1])
        return done.stdout, done.stderr

    def version(self):
        return self.run("pcl_cid_segment", "--version")[0].strip()

    def segment(self, *arguments):
        self.run("pcl_cid_segment", *arguments, "--threads", self.threads, "--quiet")

    def abstract(self, *arguments):
        self.run("pcl_cid_abstract", *arguments, "--threads", self.threads, "--quiet")


def read_json(path):
    return json.loads(path.read_text(encoding="utf-8"))


def perturbed(scan, settings, programs, folder):
    """A PCD file of a scan, with noise and fewer points where the settings say so."""
    copy = folder / "scan.pcd"
    _, remarks = programs.run("cid_perturb", scan.path, copy, "--noise", settings.get("noise", 0),
                           "--keep", settings.get("keep", 1), "--random-seed", settings["start"])
    report = json.dumps({"remarks": remarks.splitlines()})
    (folder / "perturb.json").write_text(report, encoding="utf-8")
    return copy


def remarks_in(folder):
    """What the reports in a folder say that was repaired, left out or assumed in reading."""
    reports = [read_json(report) for report in sorted(folder.glob("*.json"))]
    scans = [scan for report in reports for scan in (report, *report.get("scans", []))]
    return [remark for scan in scans for remark in scan.get("remarks", [])]


def options_beyond(defaults, settings):
    """Options as some defaults have them, except for what the settings name."""
    values = {name: settings.get(name, value) for name, value in defaults.items()}
    return [word for name, value in values.items() if value != DEFAULT
            for word in (f"--{name}", value)]


def raw_scan_options(settings):
    """The options of the paper, except for what the settings name."""
    return options_beyond(paper.RAW_SCANS, settings)


def propagate(item, programs, folder):
    """Section V.A of the paper: seeds with their true labels, carried to all points; scored."""
    settings = item.settings
    truth = item.scan.path
    if "noise" in settings or "keep" in settings:
        truth = perturbed(item.scan, settings, programs, folder)
    prediction = folder / "prediction.pcd"
    programs.segment(truth, prediction, "--labels-from", "label",
                     "--seeds", settings["seeds"], "--subsample", settings["subsample"],
                     "--random-seed", settings["start"], *raw_scan_options(settings),
                     "--report", folder / "segment.json")
    programs.run("pcl_cid_evaluate", prediction, truth, "--protocol", "paper", "--quiet",
                 *item.scan.class_options(), "--report", folder / "scores.json")
    scores = read_json(folder / "scores.json")
    segment = read_json(folder / "segment.json")
    figures = ("points", "labelled_points", "truth_instances", "groups", "purity", "mean_iou")
    return {
        "seconds": segment["seconds"]["segment"],
        "density": segment["density"],
        "classes_from": scores["classes_from"],
        "classes": {each["name"]: counts(each) for each in scores["classes"]},
        **{name: scores[name] for name in figures},
    }


def counts(scored):
    """Numbers of a class, which, unlike its AP, can be summed over scans. In the paper's
    protocol each prediction is compared with one truth instance, hence either right or wrong."""
    truths = scored["truth_instances"]
    return {
        "truths": truths,
        "predictions": scored["predictions"],
        **{f"right{t}": round((scored[f"recall{t}"] or 0) * truths) for t in (25, 50, 75)},
    }
