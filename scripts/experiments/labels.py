# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Pictures of what label propagation gets right and wrong, in both settings, as in the
# paper's figure of qualitative results.

import statistics

import numpy as np

import paper
from clouds import labelled, read_cloud
from heatmap import largest_instance, middle_of
from programs import perturbed, raw_scan_options
from propagation import COLUMNS
from report import new_figure, save_picture, write_csv, write_markdown
from view import View
from work import PICTURE, Item

COLORS = 20


def carry_labels(item, programs, folder):
    """The labels of the seeds at all points, for each setting, and the picture."""
    settings = item.settings
    scan = perturbed(item.scan, settings, programs, folder)
    truth = read_cloud(scan)
    known = labelled(truth)
    labels = {"truth": truth["label"]}
    for name, column in COLUMNS.items():
        file = folder / f"labelled {name}.pcd"
        programs.segment(scan, file, "--labels-from", "label", "--seeds", settings["seeds"],
                         "--subsample", column["subsample"], "--random-seed", settings["start"],
                         *raw_scan_options(column))
        labels[name] = read_cloud(file)["label"]
    draw(truth, known, labels, folder / PICTURE)
    return {name: float((labels[name] == labels["truth"])[known].mean())
            for name in COLUMNS}


def draw(cloud, known, labels, path):
    """True instances; what is wrong in each column."""
    figure = new_figure(16, 3.6)
    room = View(cloud, [middle_of(cloud, largest_instance(cloud, known))])
    panels = figure.subplots(1, len(labels), subplot_kw={"projection": "3d"})
    for panel, (name, values) in zip(panels, labels.items()):
        if name == "truth":
            room.scatter(panel, "true instances", c=values[room.shown] % COLORS, cmap="tab20")
            continue
        right = (values == cloud["label"])[room.shown]
        room.scatter(panel, f"wrong labels, {name}",
                     c=np.where(right, "lightsteelblue", "crimson"))
    save_picture(path, figure)


class Labels:
    """A picture for each scan."""

    name = "labels"

    def items(self, scan, options):
        return [Item(scan, "labels", {"seeds": options.seeds, "start": 0})]

    def summarize(self, done, options, folder):
        rows = [{"scan": item.scan.name, **result} for item, result in done]
        write_csv(folder / "labels_scans.csv", rows)
        table = [{"setting": name, "points with the right label":
                  statistics.fmean(row[name] for row in rows)} for name in COLUMNS]
        write_csv(folder / "labels.csv", table)
        text = (f"{len(rows)} scans, {options.seeds} seeds, 1 random start; share of the points "
                f"with a true label, mean over the scans. The paper works on {paper.SUBSAMPLE:,} "
                "points. The pictures are beside the results of the scans.")
        write_markdown(folder / "labels.md", [("Labels", text, table)])
