#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The three protocols a second time, from their definitions: a mask for each instance,
# IoUs as fractions. Random clouds are scored by both; the reports must agree.
#
#   second_opinion.py PCL_CID_EVALUATE

import csv
import json
import math
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

import numpy as np

SCANNET_CLASSES = [3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 16, 24, 28, 33, 34, 36, 39]
NAN = math.nan


def mode(values):
    """The most frequent value, the lowest of equals."""
    numbers, counts = np.unique(values, return_counts=True)
    return int(numbers[np.argmax(counts)])


class Instance:
    def __init__(self, label, mask, semantic):
        self.label = label
        self.mask = mask
        self.semantic = semantic
        self.size = int(np.count_nonzero(mask))


def instances(labels, semantic):
    found = []
    for label in np.unique(labels[labels != 0]):
        mask = labels == label
        found.append(Instance(int(label), mask, mode(semantic[mask])))
    return found


def common(a, b):
    return int(np.count_nonzero(a.mask & b.mask))


def iou(a, b):
    return Fraction(common(a, b), int(np.count_nonzero(a.mask | b.mask)))


class Scan:
    """A pair of labellings; `own` are classes of the prediction, or None."""

    def __init__(self, truth, semantic, prediction, own):
        self.truth = truth
        self.semantic = semantic
        self.prediction = prediction
        self.own = own
        self.truths = instances(truth, semantic)
        self.predictions = instances(prediction, semantic if own is None else own)


def single_confidence(right, wrong, missed):
    """AP, precision and recall when every prediction is as sure as the others."""
    if right + missed == 0:
        return NAN, NAN, NAN
    recall = right / (right + missed)
    precision = right / (right + wrong) if right + wrong else 0.0
    return recall * (1 + precision) / 2, precision, recall


def paper_counts(scans, semantic, threshold):
    right = wrong = missed = 0
    for scan in scans:
        predicted = {each.label: each for each in scan.predictions}
        for truth in scan.truths:
            if truth.semantic != semantic:
                continue
            prediction = predicted.get(truth.label)
            hit = prediction is not None and iou(truth, prediction) > threshold
            right += hit
            wrong += prediction is not None and not hit
            missed += not hit
    return right, wrong, missed


def benchmark_counts(scans, semantic, threshold, classes, min_points, void_passes):
    """As ScanNet's benchmark counts, with equal confidences."""
    right = wrong = missed = 0
    for scan in scans:
        truths = [t for t in scan.truths if t.semantic == semantic]
        predictions = [
            p
            for p in scan.predictions
            if p.semantic == semantic and p.size >= min_points
        ]
        used = set()
        for truth in truths:
            if truth.size < min_points:
                continue
            hits = [
                p
                for p in predictions
                if p.label not in used and iou(truth, p) > threshold
            ]
            if not hits:
                missed += 1
                continue
            right += 1
            used.add(hits[0].label)
            wrong += len(hits) - 1
        evidence = np.zeros(scan.truth.size, bool)  # points that speak against
        for truth in scan.truths:
            small = truth.semantic == semantic and truth.size < min_points
            if truth.semantic in classes and not small:
                evidence |= truth.mask
        for prediction in predictions:
            if any(iou(truth, prediction) > threshold for truth in truths):
                continue
            void = Fraction(
                int(np.count_nonzero(prediction.mask & ~evidence)), prediction.size
            )
            wrong += not (void_passes and void > threshold)
    return right, wrong, missed


def asis(scans, semantic):
    """mCov, mWCov, precision and recall of one class."""
    means, weighted_means = [], []
    hits = predicted = existing = 0
    for scan in scans:
        truths = [t for t in scan.truths if t.semantic == semantic]
        predictions = [p for p in scan.predictions if p.semantic == semantic]
        best = [max([0, *(float(iou(t, p)) for p in predictions)]) for t in truths]
        if truths:
            means.append(np.mean(best))
            weighted_means.append(np.average(best, weights=[t.size for t in truths]))
        hits += sum(
            any(iou(t, p) >= Fraction(1, 2) for t in truths) for p in predictions
        )
        predicted += len(predictions)
        existing += len(truths)
    if existing == 0:
        return {name: NAN for name in ASIS_FIGURES}
    precision = hits / predicted if predicted else 0.0
    values = np.mean(means), np.mean(weighted_means), precision, hits / existing
    return dict(zip(ASIS_FIGURES, values))


ASIS_FIGURES = ["coverage", "weighted_coverage", "precision", "recall"]


def class_figures(scans, protocol, semantic, classes):
    def counts(threshold):
        if protocol == "paper":
            return paper_counts(scans, semantic, threshold)
        rules = (100, True) if protocol == "scannet" else (0, False)
        return benchmark_counts(scans, semantic, threshold, classes, *rules)

    figures = {}
    for percent in (25, 50, 75):
        values = single_confidence(*counts(Fraction(percent, 100)))
        for name, value in zip(("ap", "precision", "recall"), values):
            figures[f"{name}{percent}"] = value
    if protocol == "scannet":
        figures["ap"] = np.mean(
            [single_confidence(*counts(Fraction(k, 20)))[0] for k in range(10, 19)]
        )
    if protocol == "s3dis":
        figures.update(asis(scans, semantic))
    return figures


def mean_figures(by_class):
    """Over the classes with a truth: those of the others are all NaN."""
    names = next(iter(by_class.values())).keys()
    real = [f for f in by_class.values() if not math.isnan(f["recall50"])]
    means = {name: np.mean([f[name] for f in real]) if real else NAN for name in names}
    return {"classes": len(real), **means}


def group_figures(scans):
    pure = labelled = 0
    best = []
    for scan in scans:
        for group in scan.predictions:
            on_truth = scan.truth[group.mask & (scan.truth != 0)]
            if on_truth.size:
                pure += int(np.unique(on_truth, return_counts=True)[1].max())
        labelled += int(np.count_nonzero(scan.truth))
        best += [
            max([0, *(float(iou(t, p)) for p in scan.predictions)]) for t in scan.truths
        ]
    groups = sum(len(scan.predictions) for scan in scans)
    return {
        "points": sum(scan.truth.size for scan in scans),
        "labelled_points": labelled,
        "truth_instances": len(best),
        "groups": groups,
        "purity": pure / labelled if labelled else NAN,
        "compactness": len(best) / groups if groups else NAN,
        "mean_iou": np.mean(best) if best else NAN,
    }


def score(scans, protocol, classes):
    by_class = {c: class_figures(scans, protocol, c, classes) for c in classes}
    return by_class, mean_figures(by_class), group_figures(scans)


def runs(values, ends):
    """Each value up to its end."""
    return np.repeat(values, np.diff(np.append(0, ends)))


def random_truth(random, classes):
    """Instances in a row, of about 100 points; some without label or class."""
    count = int(random.integers(6, 16))
    labels = random.choice(np.arange(1, 60), count, replace=False)
    labels[random.random(count) < 0.1] = 0
    ends = np.cumsum(2 * random.integers(20, 90, count))
    kinds = random.choice(classes, count)
    kinds[random.random(count) < 0.1] = 0
    truth, semantic = runs(labels, ends), runs(kinds, ends)
    odd = random.random(truth.size) < 0.1
    semantic[odd] = random.choice(classes, np.count_nonzero(odd))
    return truth, semantic, ends


def random_segments(random, ends):
    """Where predictions end: some truths split in halves, some merged, others moved."""
    middles = (ends + np.append(0, ends[:-1])) // 2
    kept, halved = random.random(ends.size) < 0.8, random.random(ends.size) < 0.2
    cuts = np.append(ends[kept], middles[halved])
    moved = random.random(cuts.size) < 0.5
    cuts[moved] += random.integers(-40, 40, np.count_nonzero(moved))
    return np.unique(np.append(cuts[(cuts > 0) & (cuts < ends[-1])], ends[-1]))


def random_scan(random, protocol, classes, with_own_classes):
    truth, semantic, ends = random_truth(random, classes)
    segments = random_segments(random, ends)
    if protocol == "paper":
        values = truth[random.integers(np.append(0, segments[:-1]), segments)]
    else:
        values = random.choice(np.arange(60), segments.size)  # labels mean nothing
    prediction = runs(values, segments)
    noisy = random.random(truth.size) < random.choice([0, 0.02, 0.2])
    prediction[noisy] = random.choice(np.append(values, 0), np.count_nonzero(noisy))
    order = random.permutation(truth.size)
    truth, semantic, prediction = truth[order], semantic[order], prediction[order]
    own = None
    if protocol == "paper":
        by_label = {each.label: each.semantic for each in instances(truth, semantic)}
        own = np.array([by_label.get(int(label), 0) for label in prediction])
    elif with_own_classes:
        own = semantic.copy()
        for label in np.unique(prediction)[::3]:
            own[prediction == label] = random.choice(classes)
    return Scan(truth, semantic, prediction, own)


def write_pcd(path, points, digits, **fields):
    rows = [
        " ".join([*(f"{x:.{digits}g}" for x in point), *(str(int(v)) for v in values)])
        for point, *values in zip(points, *fields.values())
    ]
    count = len(fields)
    header = [
        "VERSION 0.7",
        "FIELDS x y z " + " ".join(fields),
        "SIZE 4 4 4" + " 4" * count,
        "TYPE F F F" + " U" * count,
        "COUNT 1 1 1" + " 1" * count,
        f"WIDTH {len(rows)}",
        "HEIGHT 1",
        f"POINTS {len(rows)}",
        "DATA ascii",
    ]
    path.write_text("\n".join(header + rows) + "\n")


def write_scan(folder, name, scan, protocol, random):
    points = random.uniform(-50, 50, (scan.truth.size, 3)).astype(np.float32)
    write_pcd(
        folder / "truth" / f"{name}.pcd",
        points,
        9,
        label=scan.truth,
        semantic=scan.semantic,
    )
    fields = {"label": scan.prediction}
    if scan.own is not None and protocol != "paper":
        fields["semantic"] = scan.own
    write_pcd(folder / "prediction" / f"{name}.pcd", points, 6, **fields)


def require(condition, *what):
    if not condition:
        raise SystemExit("second_opinion.py: " + " ".join(map(str, what)))


def compare(place, reported, expected):
    """Every expected figure must be in the report; NaN is null there, or empty."""
    for name, value in expected.items():
        got = reported[name]
        if math.isnan(value):
            require(got in (None, ""), place, name, "is", got, "and not NaN")
        else:
            same = got not in (None, "") and abs(float(got) - value) < 1e-12
            require(same, place, name, "is", got, "and not", value)


def check_report(report, scans, protocol, classes):
    by_class, mean, groups = score(list(scans.values()), protocol, classes)
    compare("all:", report, groups)
    compare("mean:", report["mean"], mean)
    for row in report["classes"]:
        compare(f"class {row['number']}:", row, by_class[row["number"]])
    require([row["number"] for row in report["classes"]] == classes, "classes differ")
    purities = []
    for row in report["scans"]:
        _, mean, groups = score([scans[row["name"]]], protocol, classes)
        compare(f"scan {row['name']}:", row, groups)
        compare(f"scan {row['name']}, mean:", row["mean"], mean)
        purities.append(groups["purity"])
    require(len(purities) == len(scans), "scans are missing")
    compare("all:", report, {"median_purity": np.median(purities)})


def check_table(path, report):
    """The CSV holds the same figures as the report."""

    def figures(row):
        values = {**row, **row.get("mean", {})}
        return {
            name: NAN if value is None else value
            for name, value in values.items()
            if value is None or isinstance(value, (int, float))
        }

    with open(path, newline="") as file:
        table = {(row["kind"], row["name"]): row for row in csv.DictReader(file)}
    rows = {("scan", row["name"]): row for row in report["scans"]}
    rows.update({("class", row["name"]): row for row in report["classes"]})
    rows[("all", "")] = report
    require(table.keys() == rows.keys(), "rows of the table differ")
    for key, row in rows.items():
        columns = table[key].keys()
        compare(
            f"table {key}:",
            table[key],
            {name: value for name, value in figures(row).items() if name in columns},
        )


def run_case(tool, folder, protocol, seed):
    random = np.random.default_rng([seed, len(protocol)])
    known = [1, 2, 3, 5] if protocol == "scannet" else [2, 3, 11]
    classes = SCANNET_CLASSES if protocol == "scannet" else known
    options = []
    if protocol != "scannet":
        (folder / "classes.txt").write_text(
            "".join(f"{number} kind {number}\n" for number in known)
        )
        options = ["--classes", str(folder / "classes.txt")]
    for side in ("prediction", "truth"):
        (folder / side).mkdir()
    scans = {}
    for number in range(3):
        name = f"room_{number}"
        scans[name] = random_scan(random, protocol, known, bool((seed + number) % 2))
        write_scan(folder, name, scans[name], protocol, random)
    sides = [str(folder / "prediction"), str(folder / "truth")]
    outputs = ["--report", str(folder / "r.json"), "--csv", str(folder / "t.csv")]
    subprocess.run(
        [tool, *sides, "--protocol", protocol, *options, *outputs, "--quiet"],
        check=True,
    )
    report = json.loads((folder / "r.json").read_text())
    check_report(report, scans, protocol, classes)
    check_table(folder / "t.csv", report)
    return report["mean"]["ap50"]


def main():
    tool = sys.argv[1]
    for protocol in ("paper", "scannet", "s3dis"):
        ap50 = []
        for seed in range(8):
            with tempfile.TemporaryDirectory() as folder:
                ap50.append(run_case(tool, Path(folder), protocol, seed))
        print(protocol, "AP50:", *(f"{value:.4f}" for value in ap50))
        require(len(set(ap50)) > 1, "the clouds tell nothing apart")


if __name__ == "__main__":
    main()
