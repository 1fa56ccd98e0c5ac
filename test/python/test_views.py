# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Arrays are views where the memory allows it: read-only, and alive as long as they are used.

import gc

import numpy as np
import pytest

import pcl_cid
from conftest import box_points


def address(array):
    return array.__array_interface__["data"][0]


@pytest.mark.parametrize("name", ["vertices", "faces", "indices"])
def test_views_of_a_part(scan, name):
    part = scan.parts(count=2, merging="cid")[0]
    view = getattr(part, name)
    assert address(view) == address(getattr(part, name))
    assert view.base is part
    copy = view.copy()
    del part
    gc.collect()
    assert np.array_equal(view, copy)


def test_columns_of_a_tree(scan):
    tree = scan.merge_tree()
    merges, heights = tree.merges, tree.heights
    assert merges.base is tree and merges.shape == (7, 2) and heights.shape == (7,)
    copies = merges.copy(), heights.copy()
    del tree, scan
    gc.collect()
    assert np.array_equal(merges, copies[0]) and np.array_equal(heights, copies[1])


def test_groups_are_made_once_and_outlive_the_scan():
    scan = pcl_cid.Scan(box_points())
    scan.propose(5)
    groups = scan.groups
    assert address(groups) == address(scan.groups)
    scan.propose(8)
    assert groups.max() == 4 and scan.groups.max() == 7
    del scan
    gc.collect()
    assert groups.max() == 4


def test_columns_keep_their_values(room):
    cloud = pcl_cid.Cloud(room.points)
    x = cloud["x"]
    assert address(x) == address(cloud["x"]) == address(cloud.points)
    cloud["label"] = np.arange(len(cloud))
    label = cloud["label"]
    cloud["label"] = np.zeros(len(cloud), int)
    assert label.any() and not cloud["label"].any()
    assert list(cloud) == ["x", "y", "z", "label"]
    del cloud
    gc.collect()
    assert np.array_equal(x, room["x"])


def test_everything_is_read_only(scan, room):
    part = scan.parts(count=2)[0]
    tree = scan.merge_tree()
    for array in (scan.seeds, scan.groups, scan.labels(), scan.seed_labels, scan.cids(),
                  scan.cid_from(0), part.vertices, part.faces, part.indices,
                  tree.merges, tree.heights, tree.sizes, tree.cut(), room["x"], room.points):
        assert not array.flags.writeable
        with pytest.raises(ValueError):
            array.flags.writeable = True


def test_types(scan):
    part = scan.parts(count=2)[0]
    assert scan.groups.dtype == np.int32 and scan.labels().dtype == np.uint32
    assert part.vertices.dtype == np.float64 and part.vertices.shape[1] == 3
    assert part.faces.dtype == np.uint32 and part.faces.max() < len(part.vertices)
