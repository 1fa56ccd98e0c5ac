# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# What the runs of peers say beside CID: tables and a picture.

import statistics
from collections import defaultdict
from dataclasses import dataclass

from report import new_figure, save_picture
from scores import mean

AP = ("ap25", "ap50", "ap75", "mean_iou")


@dataclass
class Run:
    """A run of a method on a scan, with the purity of CID at as many parts by groups of the
    merge tree, where that can be compared."""

    scan: str
    method: str
    settings: dict
    instances: int
    figures: dict
    cid: dict

    def setting(self):
        return ", ".join(f"{name} {value}" for name, value in self.settings.items())

    def margin(self, tree):
        """How much purer CID is."""
        return self.cid[tree] - self.figures["purity"]


def mean_curves(done):
    """By scan and groups of the tree: purity by number of parts, a mean over the starts."""
    starts = defaultdict(lambda: defaultdict(list))
    for item, result in done:
        if item.kind == "curve":
            for parts, purity in result["curve"]:
                starts[item.scan.name, item.settings["tree"]][parts].append(purity)
    return {key: {parts: statistics.fmean(values) for parts, values in curve.items()}
            for key, curve in starts.items()}


class Comparison:
    """All runs of all scans."""

    def __init__(self, done, seeds):
        curves = mean_curves(done)
        self.tree = seeds
        self.trees = sorted({tree for _, tree in curves})
        self.runs = [self.run(item, result, figures, curves) for item, result in done
                     if item.kind == "peers" for figures in result["runs"]]

    def run(self, item, result, figures, curves):
        least, most = result["comparable"]
        cid = {}
        if least <= figures.get("parts", 0) <= most:
            cid = {tree: curves[item.scan.name, tree][figures["parts"]] for tree in self.trees}
        return Run(item.scan.name, figures["method"], figures["settings"],
                   result["instances"], figures, cid)

    def scans(self):
        return list(dict.fromkeys(run.scan for run in self.runs))

    def with_seeds(self):
        """Runs by method."""
        return by(lambda run: run.method, (run for run in self.runs if "ap50" in run.figures))

    def without_seeds(self):
        """Runs by method, with those that failed."""
        seeded = self.with_seeds()
        return by(lambda run: run.method,
                  (run for run in self.runs if run.method not in seeded))

    def best_of_scans(self, runs):
        """The best of each scan, picked by the truth: CID is purer by the least."""
        scans = by(lambda run: run.scan, compared(runs))
        return [min(each, key=lambda run: run.margin(self.tree)) for each in scans.values()]

    def best_setting(self, runs):
        """Runs of the setting that is best on average, of those that can be compared on most
        scans."""
        settings = by(Run.setting, compared(runs)).values()
        most = max((len(each) for each in settings), default=0)
        return min((each for each in settings if len(each) == most), default=[],
                   key=lambda each: statistics.fmean(run.margin(self.tree) for run in each))

    def run_rows(self):
        names = ("failure", "cpu_seconds", "peak_bytes", "parts", "labelled", "own_purity", "purity",
                 *AP)
        return [{"scan": run.scan, "method": run.method, "setting": run.setting(),
                 "instances": run.instances,
                 **{name: run.figures.get(name) for name in names},
                 **{self.cid_column(tree): run.cid.get(tree) for tree in self.trees}}
                for run in self.runs]

    def scan_rows(self):
        """The best of each scan, and the mean of the runs with seeds."""
        rows = []
        for method, runs in self.with_seeds().items():
            rows += [{"scan": scan, **self.row(method, "mean of the starts", each)}
                     for scan, each in by(lambda run: run.scan, runs).items()]
        for method, runs in self.without_seeds().items():
            rows += [{"scan": run.scan, **self.row(method, run.setting(), [run])}
                     for run in self.best_of_scans(runs)]
        return rows

    def summary_rows(self):
        """A mean over the scans of each method: with seeds; picked scan by scan; one setting."""
        rows = [self.row(method, "mean of the starts", runs)
                for method, runs in self.with_seeds().items()]
        for method, runs in self.without_seeds().items():
            one = self.best_setting(runs)
            if one:
                rows += [self.row(method, "the best of each scan", self.best_of_scans(runs)),
                         self.row(method, one[0].setting(), one)]
        return rows

    def row(self, method, setting, runs):
        def average(name):
            return mean(run.figures.get(name) for run in runs)
        return {"method": method, "setting": setting,
                "scans": len({run.scan for run in runs}),
                "parts": average("parts"), "labelled": average("labelled"),
                "own purity": average("own_purity"), "purity": average("purity"),
                **{self.cid_column(tree): mean(run.cid.get(tree) for run in runs)
                   for tree in self.trees},
                **{name: average(name) for name in AP},
                "CPU s": average("cpu_seconds"), "peak MB": average("peak_bytes") / 1e6}

    def cid_column(self, tree):
        return "CID" if tree == self.tree else f"CID, tree of {tree}"

    def tally_rows(self):
        """In how many of its settings and scans CID is purer."""
        rows = []
        for method, runs in self.without_seeds().items():
            pairs = compared(runs)
            best = self.best_of_scans(runs)
            row = {"method": method, "runs": len(runs),
                   "failed": sum("failure" in run.figures for run in runs),
                   "compared": len(pairs)}
            for tree in self.trees:
                row[f"{self.cid_column(tree)} purer"] = count(
                    run.margin(tree) > 0 for run in pairs)
            row["CID purer than its own purity"] = count(
                run.cid[self.tree] > run.figures["own_purity"] for run in pairs)
            row["scans where CID is purer than the best"] = (
                f"{count(run.margin(self.tree) > 0 for run in best)} of {len(best)}")
            rows.append(row)
        return rows


def by(key, runs):
    groups = defaultdict(list)
    for run in runs:
        groups[key(run)].append(run)
    return dict(groups)


def compared(runs):
    return [run for run in runs if run.cid]


def count(answers):
    return sum(map(bool, answers))


def selected(rows, names):
    """The named columns of the rows."""
    return [{name: row[name] for name in names} for row in rows]


def sections(comparison, options):
    """Of the summary: methods with seeds, others, and how often each is purer."""
    cid = [comparison.cid_column(tree) for tree in comparison.trees]
    scans = len(comparison.scans())
    rows = comparison.summary_rows()
    seeded = [row for row in rows if row["ap50"] is not None]
    others = [row for row in rows if row["ap50"] is None]
    texts = [(f"{scans} scans, {options.starts} random starts, {options.seeds} seeds; means over "
              "scans and starts."),
             (f"{scans} scans. Two rows for each: the best setting of each scan, picked by the "
              "truth; and the one setting that is best on average, of those that can be compared "
              "on most scans. Means over the scans. CID is at the same number of parts, a mean "
              "over the starts."),
             ("All runs: a setting on a scan. Those that give from half to five times the number "
              "of true instances are compared.")]
    tables = [selected(seeded, ("method", "purity", *AP, "CPU s", "peak MB")),
              selected(others, ("method", "setting", "scans", "parts", "labelled", "own purity",
                                "purity", *cid, "CPU s", "peak MB")),
              comparison.tally_rows()]
    titles = ("Methods with seeds", "Other methods", "How often CID is purer")
    return [section for section in zip(titles, texts, tables) if section[2]]


def picture(comparison, path):
    """How much purer CID is, for every run that can be compared."""
    figure = new_figure(8, 4)
    axes = figure.subplots()
    for method, runs in comparison.without_seeds().items():
        pairs = compared(runs)
        if not pairs:
            continue
        axes.scatter([run.figures["parts"] / run.instances for run in pairs],
                     [run.margin(comparison.tree) for run in pairs],
                     s=8, alpha=0.6, label=method)
    if axes.collections:
        axes.set_xscale("log")
        axes.xaxis.set_major_formatter("{x:g}")
        axes.legend()
    axes.axhline(0, color="k", linewidth=1)
    axes.set(xlabel="parts / true instances", ylabel="purity of CID minus that of the method")
    axes.grid(alpha=0.25)
    save_picture(path, figure)
