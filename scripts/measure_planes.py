#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# How the parts of a scan (PLY, label) cover its largest planes, and how large the parts are.

import argparse

import numpy as np

from render_pictures import read_ply_vertices

DRAWS = 2000
# Points that each drawn plane is scored on.
JUDGES = 10000
# Parts with a smaller share of a plane are not counted.
SMALL_SHARE = 0.05


def distances(places, plane):
    normal, offset = plane
    return np.abs(places @ normal - offset)


def plane_through(places):
    """The plane of least squares."""
    middle = places.mean(axis=0)
    _, vectors = np.linalg.eigh(np.cov((places - middle).T))
    return vectors[:, 0], vectors[:, 0] @ middle


def largest_plane(places, thickness, generator):
    """The plane that most of the points are on, by RANSAC."""
    judges = places[generator.choice(len(places), min(JUDGES, len(places)), replace=False)]
    best, most = None, -1
    for _ in range(DRAWS):
        first, second, third = places[generator.choice(len(places), 3, replace=False)]
        normal = np.cross(second - first, third - first)
        length = np.linalg.norm(normal)
        if length == 0:
            continue
        plane = (normal / length, normal @ first / length)
        on = np.count_nonzero(distances(judges, plane) < thickness)
        if on > most:
            best, most = plane, on
    return plane_through(places[distances(places, best) < thickness])


def row_of(plane, on, labels, near):
    """What the table says of a plane; `near` are all points that may be said to be on it."""
    parts, counts = np.unique(labels[on], return_counts=True)
    first = parts[np.argmax(counts)]
    inside = labels == first
    of_their_own = sum(counts[i] for i, part in enumerate(parts)
                       if near[labels == part].mean() > 0.9)
    normal = " ".join(f"{value:.2f}" for value in plane[0])
    return (f"| {normal} | {plane[1]:.2f} | {on.sum()} | {counts.max() / on.sum():.2f} "
            f"| {(near & inside).sum() / inside.sum():.2f} "
            f"| {np.count_nonzero(counts >= SMALL_SHARE * on.sum())} "
            f"| {of_their_own / on.sum():.2f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("parts", help="labelled cloud, binary PLY")
    parser.add_argument("--planes", type=int, default=6)
    parser.add_argument("--thickness", type=float, default=0.05,
                        help="how far from a plane a point may be, metres")
    parser.add_argument("--beyond", type=float, default=0.5,
                        help="nearer to the origin is the scanner itself, metres")
    parser.add_argument("--small", type=int, default=50, help="points of a small part")
    args = parser.parse_args()

    cloud = read_ply_vertices(args.parts)
    places = np.stack([cloud[axis] for axis in "xyz"], axis=1).astype(float)
    kept = np.isfinite(places).all(axis=1) & (cloud["label"] > 0)
    places, labels = places[kept], cloud["label"][kept]
    sizes = np.unique(labels, return_counts=True)[1]
    print(f"{len(sizes)} parts, {np.count_nonzero(sizes < args.small)} of them under "
          f"{args.small} points\n")
    print("| normal | offset | points | in its largest part | of which on the plane "
          f"| parts with {SMALL_SHARE:.0%} | in parts of the plane alone |\n"
          "|---|---:|---:|---:|---:|---:|---:|")
    left = np.linalg.norm(places, axis=1) > args.beyond
    generator = np.random.default_rng(0)
    for _ in range(args.planes):
        plane = largest_plane(np.unique(places[left], axis=0), args.thickness, generator)
        on = left & (distances(places, plane) < args.thickness)
        print(row_of(plane, on, labels, distances(places, plane) < 2 * args.thickness))
        left &= ~on


if __name__ == "__main__":
    main()
