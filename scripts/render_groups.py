#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Pictures of what settings make of the same scan: groups (PLY, label) and seeds (CSV) of each; or of
# scans in their own colors.

import argparse
import csv
import io

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from PIL import Image

from render_pictures import palette, read_ply_vertices


# Colors of a picture: few make a small file.
COLORS = 64


def read_seeds(path):
    """The seeds' coordinates, a row for each."""
    with open(path, encoding="utf-8", newline="") as file:
        return np.array([[float(row[axis]) for axis in "xyz"] for row in csv.DictReader(file)])


def as_camera(places):
    """Right, up and depth, as seen by a sensor at the origin that looks along z, y down."""
    return places[:, 0] / places[:, 2], -places[:, 1] / places[:, 2], places[:, 2]


def from_above(places, elevation, azimuth):
    """Right, up and depth without perspective; z is up."""
    up, around = np.radians([elevation, azimuth])
    right = np.array([-np.sin(around), np.cos(around), 0])
    toward = np.array([np.cos(up) * np.cos(around), np.cos(up) * np.sin(around), np.sin(up)])
    return places @ right, places @ np.cross(toward, right), -(places @ toward)


def colors_of(cloud, are_own):
    """A color for each point: its own, or that of its group."""
    if are_own:
        return np.stack([cloud[name] for name in ("red", "green", "blue")], axis=1) / 255
    return palette(int(cloud["label"].max()) + 1)[cloud["label"]]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", help="PNG to write")
    parser.add_argument("--panel", nargs=3, action="append", required=True,
                        metavar=("TITLE", "GROUPS", "SEEDS"),
                        help="binary PLY with a label, and the table of its seeds; once for each")
    parser.add_argument("--own-colors", action="store_true",
                        help="as the fields red, green and blue say, and without the seeds")
    parser.add_argument("--camera", action="store_true", help="as a depth sensor saw it")
    parser.add_argument("--cut-above", type=float, default=np.inf,
                        help="height above which nothing is shown (removes a ceiling)")
    parser.add_argument("--within", type=float, default=np.inf,
                        help="distance from the origin beyond which nothing is shown")
    parser.add_argument("--elevation", type=float, default=55)
    parser.add_argument("--azimuth", type=float, default=-60)
    parser.add_argument("--width", type=float, default=5.2, help="of a panel, inches")
    parser.add_argument("--height", type=float, default=4.2)
    parser.add_argument("--points", type=int, default=400000)
    args = parser.parse_args()

    def is_shown(places):
        return ((np.linalg.norm(places, axis=1) <= args.within)
                & (places[:, 2] <= args.cut_above))

    def project(places):
        if args.camera:
            return as_camera(places)
        return from_above(places, args.elevation, args.azimuth)

    figure, panels = plt.subplots(1, len(args.panel), squeeze=False, layout="constrained",
                                  figsize=(args.width * len(args.panel), args.height))
    for axes, (title, groups, seeds) in zip(panels[0], args.panel):
        cloud = read_ply_vertices(groups)
        places = np.stack([cloud[axis] for axis in "xyz"], axis=1).astype(float)
        shown = np.flatnonzero(np.isfinite(places).all(axis=1) & is_shown(places))
        shown = shown[::max(1, len(shown) // args.points)]
        colors = colors_of(cloud, args.own_colors)[shown]
        right, up, off = project(places[shown])
        order = np.argsort(-off)
        axes.scatter(right[order], up[order], c=colors[order], s=1.5, linewidths=0)
        if not args.own_colors:
            chosen = read_seeds(seeds)
            right, up, _ = project(chosen[is_shown(chosen)])
            axes.scatter(right, up, s=14, color="white", edgecolor="black", linewidths=0.9)
        axes.set_title(title, fontsize="medium")
        axes.set_aspect("equal")
        axes.set_axis_off()
    drawn = io.BytesIO()
    figure.savefig(drawn, dpi=80)
    Image.open(drawn).convert("RGB").quantize(COLORS).save(args.picture, optimize=True)


if __name__ == "__main__":
    main()
