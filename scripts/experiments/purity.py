# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Purity against compactness (section V.B): the groups of K seeds, or as many patches, merged one
# pair after the other. One run gives all of the merges; each of them gives a point of the curve.

import statistics

import numpy as np

import paper
from clouds import labelled, read_cloud
from programs import perturbed, raw_scan_options, read_json
from propagation import COLUMNS, with_setting
from report import new_figure, save_picture, write_csv, write_markdown
from work import Item

# Where box plots are drawn. The paper's own T_b, the compactness of WCSeg, is not published.
COMPACTNESS = (0.5, 1.0, 2.0)

# What each column is; the groups are those of seeds where it does not name others.
MERGED = COLUMNS | {"patches": COLUMNS["defaults"] | {"groups": "patches"}}


def column_of(item):
    return next(name for name, column in MERGED.items() if with_setting([(item, None)], **column))


def contingency(groups, truth):
    """Points by group (rows; labels from 1) and truth instance."""
    _, instance = np.unique(truth, return_inverse=True)
    table = np.zeros((groups.max(), instance.max() + 1), dtype=np.int64)
    np.add.at(table, (groups - 1, instance), 1)
    return table


def purities(table, steps):
    """By number of parts: first without merges, then after each of them."""
    table = table.copy()
    points = table.sum()
    pure = [table.max(axis=1).sum() / points]
    for step in steps:
        table[step["first"]] += table[step["second"]]
        table[step["second"]] = 0
        pure.append(table.max(axis=1).sum() / points)
    return [float(value) for value in pure]


def merge_curve(item, programs, folder):
    """All cuts of the merge tree of a scan, compared with its true instances."""
    settings = item.settings
    copy = perturbed(item.scan, settings, programs, folder)
    programs.abstract(copy, folder / "hulls.ply", "--seeds", settings["seeds"],
                      "--parts", settings["seeds"], "--subsample", settings["subsample"],
                      "--random-seed", settings["start"], *raw_scan_options(settings),
                      "--groups", settings.get("groups", "cid"),
                      "--labels", folder / "groups.pcd", "--tree", folder / "tree.json")
    truth = read_cloud(copy)
    groups = read_cloud(folder / "groups.pcd")["label"]
    compared = labelled(truth)
    table = contingency(groups[compared], truth["label"][compared])
    tree = read_json(folder / "tree.json")
    return {"truth_instances": table.shape[1], "parts": len(tree["group_sizes"]),
            "purity": purities(table, tree["steps"])}


def purity_at(result, compactness):
    """Where the curve first is at least so compact; None when it starts beyond."""
    parts = int(result["truth_instances"] / compactness)
    if not 1 <= parts <= result["parts"]:
        return None
    return result["purity"][result["parts"] - parts]


class Purity:
    """Box plot and curve."""

    name = "purity"
    more_files = ("purity.png",)

    def items(self, scan, options):
        return [Item(scan, "merge", {"seeds": options.seeds, "start": start, **column})
                for column in MERGED.values() for start in range(options.starts)]

    def summarize(self, done, options, folder):
        write_csv(folder / "purity_scans.csv", [
            {"scan": item.scan.name, "setting": column_of(item), **paper.RAW_SCANS,
             "groups": "cid", **item.settings, "parts": result["parts"] - merges,
             "compactness": result["truth_instances"] / (result["parts"] - merges),
             "purity": purity}
            for item, result in done for merges, purity in enumerate(result["purity"])])
        boxes = {(setting, compactness): self.box(with_setting(done, **column), compactness)
                 for setting, column in MERGED.items() for compactness in COMPACTNESS}
        rows = [self.row(setting, boxes) for setting in MERGED]
        write_csv(folder / "purity.csv", rows)
        theirs = ", ".join(f"{name} {value}" for name, value in paper.MEDIAN_PURITY.items())
        scans = len({item.scan.name for item, _ in done})
        text = (f"{scans} scans, {options.starts} random starts each, {options.seeds} seeds; "
                "median (lower and upper quartile) over the scans of the mean over the starts. "
                f"Medians of the paper, on S3DIS at the compactness of WCSeg: {theirs}.")
        write_markdown(folder / "purity.md", [("Purity", text, rows)])
        self.draw(done, boxes, folder / "purity.png")

    @staticmethod
    def box(done, compactness):
        """The purity of each scan, a mean over the starts, where it is defined."""
        of_scan = {}
        for item, result in done:
            purity = purity_at(result, compactness)
            if purity is not None:
                of_scan.setdefault(item.scan.name, []).append(purity)
        return [statistics.fmean(values) for values in of_scan.values()]

    @staticmethod
    def row(setting, boxes):
        row = {"setting": setting}
        for compactness in COMPACTNESS:
            box = boxes[setting, compactness]
            low, middle, high = np.quantile(box, (0.25, 0.5, 0.75)) if box else 3 * (None,)
            row[f"compactness {compactness}"] = (
                f"{middle:.3f} ({low:.3f}, {high:.3f}), {len(box)} scans" if box else None)
        return row

    def draw(self, done, boxes, path):
        figure = new_figure(10, 4)
        plots, curve = figure.subplots(1, 2, sharey=True)
        known = [key for key, box in boxes.items() if box]
        # Few seeds may be too few groups for every compactness.
        if known:
            plots.boxplot([boxes[key] for key in known], whis=(0, 100),
                          labels=[f"{compactness:g}\n" + setting.replace(" ", "\n")
                                  for setting, compactness in known])
        plots.set(xlabel="compactness, setting", ylabel="purity of a scan", ylim=(0, 1.02))
        plots.tick_params(axis="x", labelsize="small")
        for i, (setting, column) in enumerate(MERGED.items()):
            results = [result for _, result in with_setting(done, **column)]
            self.draw_curves(curve, results, f"C{i}", setting)
        for axes in (plots, curve):
            for style, (name, value) in zip(("k--", "k:"), paper.MEDIAN_PURITY.items()):
                axes.axhline(value, color="k", linestyle=style[1:], linewidth=1,
                             label=f"paper's median, {name} on S3DIS")
            axes.grid(alpha=0.25)
        curve.set(xlabel="compactness: instances / groups", xscale="log")
        curve.xaxis.set_major_formatter("{x:g}")
        curve.legend(fontsize="small", loc="lower left")
        save_picture(path, figure)

    @staticmethod
    def draw_curves(axes, results, color, label):
        """A thin line for each run, and the median of all."""
        grid = np.geomspace(0.2, 10, 80)
        on_grid = []
        for result in results:
            parts = np.arange(result["parts"], result["parts"] - len(result["purity"]), -1)
            compactness = result["truth_instances"] / parts
            axes.plot(compactness, result["purity"], color=color, alpha=0.15, linewidth=0.8)
            on_grid.append(np.interp(grid, compactness, result["purity"], left=np.nan,
                                     right=np.nan))
        middle = np.median(np.array(on_grid), axis=0)
        axes.plot(grid, middle, color=color, linewidth=2.5, label=f"median, {label}")
