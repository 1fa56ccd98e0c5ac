# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The figure that opens the paper: the CID from a point of a table and from a point of a wall
# to every point, beside the Euclidean distance.

import statistics

import numpy as np

from clouds import labelled, positions, read_cloud
from programs import perturbed
from report import new_figure, save_picture, write_csv, write_markdown
from view import View
from work import PICTURE, Item

# Numbers of the classes table and wall in the field `semantic`; see doc/io/class_names.md.
S3DIS_CLASSES = {"table": 8, "wall": 3}
SCANNET_CLASSES = {"table": 7, "wall": 1}


def middle_of(cloud, wanted):
    """The index of the wanted point that is nearest to the median of the wanted ones."""
    indices = np.flatnonzero(wanted)
    places = positions(cloud)[indices]
    offsets = places - np.median(places, axis=0)
    return int(indices[np.argmin((offsets ** 2).sum(axis=1))])


def largest_instance(cloud, among):
    """The instance with most of these points, as a mask."""
    labels, counts = np.unique(cloud["label"][among], return_counts=True)
    return among & (cloud["label"] == labels[np.argmax(counts)])


def sources(cloud, classes):
    """By name, the points to measure from: in the middle of the largest table and of the
    largest wall. What a scan lacks is replaced by the largest instances that are left."""
    free = labelled(cloud)
    found = {}
    for name, number in classes.items():
        of_class = free & (cloud["semantic"] == number) if "semantic" in cloud.dtype.names else free
        is_there = of_class.any()
        if not (is_there or free.any()):
            break
        instance = largest_instance(cloud, of_class if is_there else free)
        found[name if is_there and of_class is not free
              else f"instance {cloud['label'][instance][0]}"] = middle_of(cloud, instance)
        free = free & ~instance
    return found


def separation(distance, same):
    """How well a distance tells one instance from the others: how probable it is that a point
    of the instance is nearer than one of another. 0.5 is chance, 1 is perfect."""
    values, place = np.unique(distance, return_inverse=True)
    own = np.bincount(place, weights=same, minlength=len(values))
    others = np.bincount(place, weights=~same, minlength=len(values))
    farther = others.sum() - np.cumsum(others)
    return float((own * (farther + others / 2)).sum() / (own.sum() * others.sum()))


def distances(cloud, index, scan, programs, folder):
    """CID and Euclidean distance from a point to all points."""
    file = folder / f"from_{index}.pcd"
    programs.segment(scan, file, "--cid-from", index)
    places = positions(cloud)
    return {"CID": read_cloud(file)["cid"].astype(float),
            "Euclidean": np.linalg.norm(places - places[index], axis=1)}


def heat_map(item, programs, folder):
    """Measure from the points of a scan, and draw it."""
    scan = perturbed(item.scan, item.settings, programs, folder)
    cloud = read_cloud(scan)
    classes = SCANNET_CLASSES if item.scan.is_scannet else S3DIS_CLASSES
    known = labelled(cloud)
    rows, maps = [], {}
    for name, index in sources(cloud, classes).items():
        maps[name, index] = distances(cloud, index, scan, programs, folder)
        same = cloud["label"][known] == cloud["label"][index]
        if same.all():
            raise ValueError("all of its points are on one instance: nothing to tell apart")
        rows.append({"from": name, "index": index,
                     **{f"separation by {kind}": separation(values[known], same)
                        for kind, values in maps[name, index].items()}})
    draw(cloud, maps, folder / PICTURE)
    return {"rows": rows}


def draw(cloud, maps, path):
    """A row of panels for each point: CID, Euclidean distance."""
    figure = new_figure(9, 3.4 * len(maps))
    room = View(cloud, [index for _, index in maps])
    axes = figure.subplots(len(maps), 2, squeeze=False, subplot_kw={"projection": "3d"})
    for row, ((name, index), kinds) in zip(axes, maps.items()):
        for panel, (kind, values) in zip(row, kinds.items()):
            points = room.scatter(panel, f"{kind} from the {name}", c=values[room.shown],
                                  cmap="jet", vmin=0, vmax=np.nanmax(values[room.shown]))
            panel.scatter(*room.places[index], color="white", edgecolor="k", s=50, zorder=10,
                          depthshade=False)
            figure.colorbar(points, ax=panel, shrink=0.6, label="metres", pad=0)
    save_picture(path, figure)


class HeatMap:
    """A picture for each scan."""

    name = "heatmap"

    def items(self, scan, options):
        return [Item(scan, "heatmap", {"start": 0})]

    def summarize(self, done, options, folder):
        rows = [{"scan": item.scan.name, **row} for item, result in done
                for row in result["rows"]]
        write_csv(folder / "heatmap_scans.csv", rows)
        kinds = [key for key in rows[0] if key.startswith("separation")]
        names = dict.fromkeys(row["from"] for row in rows)
        table = [{"from": name, "scans": len(of_name),
                  **{kind: statistics.fmean(row[kind] for row in of_name) for kind in kinds}}
                 for name in names for of_name in [[r for r in rows if r["from"] == name]]]
        text = ("Probability that a point of the same instance is nearer than one of another, "
                "mean over the scans. The pictures are beside the results of the scans.")
        write_csv(folder / "heatmap.csv", table)
        write_markdown(folder / "heatmap.md", [("CID from a point", text, table)])
