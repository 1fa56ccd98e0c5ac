# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# A thousand small scans leave nothing behind.

import gc
import sys

import numpy as np

import pcl_cid
from conftest import box_points


def resident_bytes():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * 4096


def use_once(points, colors, progress):
    scan = pcl_cid.Scan(points, colors=colors, color=0.01, progress=progress)
    scan.propose(4, progress=progress)
    scan.add_seeds([7], labels=[3])
    groups, tree = scan.groups, scan.merge_tree()
    parts = scan.parts(count=2, merging="cid")
    views = [parts[0].vertices, parts[0].faces, tree.merges, scan.labels()]
    try:
        scan.propose(10, progress=lambda fraction: False)
    except pcl_cid.CIDCancelled:
        pass
    try:
        scan.add_seeds([-1])
    except ValueError:
        pass
    return groups, views


def test_a_thousand_scans():
    points, colors = box_points(300), np.zeros((300, 3), np.uint8)

    def progress(fraction):
        return None

    watched = (points, colors, progress, None, pcl_cid.Scan, np.dtype("f4"))
    for _ in range(100):
        use_once(points, colors, progress)
    gc.collect()
    references, memory = [sys.getrefcount(each) for each in watched], resident_bytes()
    for _ in range(1000):
        use_once(points, colors, progress)
    gc.collect()
    for each, before in zip(watched, references):
        assert abs(sys.getrefcount(each) - before) < 20
    grown = resident_bytes() - memory
    print(f"grown by {grown / 1e6:.2f} MB")
    assert grown < 4e6
