#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Pictures of a labelled cloud (PLY) beside the hulls of its parts (OBJ) over its points.

import argparse

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

PLY_TYPES = {
    "float": "<f4", "float32": "<f4", "double": "<f8", "float64": "<f8",
    "uint": "<u4", "uint32": "<u4", "int": "<i4", "int32": "<i4",
    "uchar": "u1", "uint8": "u1", "char": "i1", "int8": "i1",
    "ushort": "<u2", "uint16": "<u2", "short": "<i2", "int16": "<i2",
}


def read_ply_vertices(path):
    """The vertices of a binary little-endian PLY as a structured array."""
    with open(path, "rb") as file:
        fields, count, element = [], 0, None
        for line in iter(file.readline, b"end_header\n"):
            words = line.decode("ascii").split()
            if words[0] == "format" and words[1] != "binary_little_endian":
                raise SystemExit(f"{path}: only binary_little_endian PLY is read")
            if words[0] == "element":
                element = words[1]
                count = int(words[2]) if element == "vertex" else count
            if words[0] == "property" and element == "vertex":
                fields.append((words[2], PLY_TYPES[words[1]]))
        return np.fromfile(file, dtype=np.dtype(fields), count=count)


def read_obj(path):
    """Vertices, and for each group its triangles."""
    vertices, groups = [], []
    for line in open(path, encoding="utf-8"):
        words = line.split()
        if not words:
            continue
        if words[0] == "v":
            vertices.append([float(w) for w in words[1:4]])
        elif words[0] == "o":
            groups.append([])
        elif words[0] == "f":
            groups[-1].append([int(w.split("/")[0]) - 1 for w in words[1:4]])
    return np.array(vertices), groups


def palette(count):
    """Colors that differ from their neighbors: steps of the golden angle."""
    hue = (np.arange(count) * 0.61803398875) % 1.0
    value = 0.65 + 0.3 * ((np.arange(count) * 7) % 3) / 2
    return matplotlib.colors.hsv_to_rgb(
        np.stack([hue, np.full(count, 0.75), value], axis=1))


def prepare_axes(axes, low, high, args, title):
    axes.set_title(title, fontsize=11)
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(low[1], high[1])
    axes.set_zlim(low[2], high[2])
    axes.set_box_aspect(high - low, zoom=args.zoom)
    axes.view_init(elev=args.elevation, azim=args.azimuth)
    axes.set_axis_off()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("cloud", help="labelled cloud, binary PLY")
    parser.add_argument("hulls", help="hulls, OBJ with one group a part")
    parser.add_argument("picture", help="PNG to write")
    parser.add_argument("--up", default="z", help="axis that points up, such as z or -y")
    parser.add_argument("--cut-above", type=float, default=1.0,
                        help="share of the height that is shown (removes a ceiling)")
    parser.add_argument("--elevation", type=float, default=50)
    parser.add_argument("--azimuth", type=float, default=-60)
    parser.add_argument("--zoom", type=float, default=1.3)
    parser.add_argument("--points", type=int, default=60000)
    args = parser.parse_args()

    cloud = read_ply_vertices(args.cloud)
    xyz = np.stack([cloud["x"], cloud["y"], cloud["z"]], axis=1).astype(float)
    finite = np.isfinite(xyz).all(axis=1) & (cloud["label"] > 0)
    xyz, label = xyz[finite], cloud["label"][finite]
    vertices, groups = read_obj(args.hulls)
    turn = {"z": np.eye(3), "-y": np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]])}[args.up]
    xyz, vertices = xyz @ turn.T, vertices @ turn.T

    low, high = np.percentile(xyz, 0.2, axis=0), np.percentile(xyz, 99.8, axis=0)
    top = low[2] + args.cut_above * (high[2] - low[2])
    shown = np.flatnonzero((xyz[:, 2] <= top) & (xyz >= low).all(1) & (xyz <= high).all(1))
    shown = shown[:: max(1, len(shown) // args.points)]
    figure = plt.figure(figsize=(14, 6.2))
    axes = figure.add_subplot(1, 2, 1, projection="3d")
    colors = palette(int(label.max()) + 1)
    axes.scatter(*xyz[shown].T, c=colors[label[shown]], s=1.2, linewidths=0)
    prepare_axes(axes, low, high, args, f"{len(np.unique(label))} parts of the scan")

    axes = figure.add_subplot(1, 2, 2, projection="3d")
    axes.scatter(*xyz[shown].T, color="0.25", s=0.6, linewidths=0, alpha=0.35)
    kept = 0
    for part, triangles in enumerate(groups):
        corners = vertices[np.array(triangles)]
        if args.cut_above < 1.0 and corners[:, :, 2].min() > top - 0.1:
            continue
        kept += 1
        axes.add_collection3d(Poly3DCollection(
            corners, facecolor=(*colors[part + 1], 0.35),
            edgecolor=(*(0.6 * colors[part + 1]), 0.35), linewidth=0.25))
    prepare_axes(axes, low, high, args, f"their convex hulls ({kept} shown) over the scan")
    figure.subplots_adjust(left=0, right=1, bottom=0, top=0.94, wspace=0)
    figure.savefig(args.picture, dpi=100)


if __name__ == "__main__":
    main()
