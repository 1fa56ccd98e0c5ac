# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Where points are, in which type and how they are laid out changes no result.

import numpy as np
import pytest

import pcl_cid
from conftest import box_points

UTM = np.array([468127.25, 5489213.5, 311.0])


def results(points, **settings):
    scan = pcl_cid.Scan(points, **settings)
    scan.propose(10)
    return scan, scan.seeds, scan.groups, scan.coverage


def assert_same(one, other):
    assert np.array_equal(one[1], other[1]) and np.array_equal(one[2], other[2])
    assert one[3] == other[3]


def test_utm_keeps_its_millimetres():
    # Multiples of 2^-12 m: the same positions to the bit after they are moved.
    near = np.round(box_points().astype(np.float64) * 4096) / 4096
    here, there = results(near), results(near + UTM)
    # The two have their own local origins, so floats may round differently.
    assert np.array_equal(here[1], there[1])
    assert np.mean(here[2] == there[2]) > 0.999
    assert abs(here[3] - there[3]) < 1e-6
    parts = there[0].parts(count=2, merging="cid")
    for part in parts:
        low, high = part.vertices.min(axis=0), part.vertices.max(axis=0)
        inside = (near + UTM)[part.indices]
        assert (inside >= low - 1e-4).all() and (inside <= high + 1e-4).all()
        assert (low >= UTM - 0.02).all() and (high <= UTM + 1.5).all()
    p, q = (near + UTM)[:2]
    assert pcl_cid.point_cid(there[0], p, q) == pytest.approx(
        pcl_cid.point_cid(here[0], near[0], near[1]), abs=1e-6)


@pytest.mark.parametrize("change", [
    lambda p: np.asfortranarray(p),
    lambda p: np.repeat(p, 2, axis=0)[::2],
    lambda p: p[:, ::-1][:, ::-1],
    lambda p: p.astype(">f4"),
    lambda p: p.tolist(),
    lambda p: p.astype(np.float64),
    lambda p: np.lib.stride_tricks.as_strided(p, p.shape, p.strides, writeable=False),
    lambda p: p.astype(np.longdouble),
    lambda p: np.ma.masked_array(p),
])
def test_layout_and_type(points, change):
    assert_same(results(points), results(change(points)))


def test_what_was_given_may_change_afterwards(points):
    given = points.copy()
    scan = pcl_cid.Scan(given)
    given[:] = 0
    scan.propose(10)
    assert np.array_equal(scan.groups, results(points)[2])


def test_points_that_are_not_finite(points):
    points[5], points[700] = np.nan, np.inf
    points[9, 1] = -np.inf
    scan, seeds, groups, _ = results(points)
    assert (groups[[5, 9, 700]] == -1).all() and (np.delete(groups, [5, 9, 700]) >= 0).all()
    assert scan.labels()[5] == 0 and np.isnan(scan.cid_from(0)[5])
    with pytest.raises(ValueError, match="point 5 is not finite"):
        scan.cid_from(5)
    with pytest.raises(ValueError, match="5"):
        scan.add_seeds([5])


def test_one_point():
    scan = pcl_cid.Scan([[1, 2, 3]])
    assert scan.propose(3) == "no_gain"
    assert scan.groups.tolist() == [0] and scan.cid_from(0).tolist() == [0]
    (part,) = scan.parts(count=1)
    assert part.thickened and part.indices.tolist() == [0]


def test_zeros_are_what_did_not_return(points):
    points[:20] = 0
    with pytest.warns(UserWarning, match="20 points lie exactly at"):
        scan = pcl_cid.Scan(points)
    scan.propose(2)
    assert (scan.groups[:20] == -1).all()
    scan = pcl_cid.Scan(points, keep_zeros=True)
    scan.propose(2)
    assert (scan.groups >= 0).all()


def test_colors(points):
    colors = np.zeros((len(points), 3), np.uint8)
    colors[: len(points) // 2, 0] = 255
    by_bytes = results(points, colors=colors, color=0.05)
    assert_same(by_bytes, results(points, colors=colors / 255.0, color=0.05))
    assert not np.array_equal(by_bytes[2], results(points)[2])


def test_sensor(points):
    pcl_cid.Scan(points, sensor=[0.5, 0.5, 1.2])
    pcl_cid.Scan(points, sensor=(0.5, 0.5, 1.2, 1, 0, 0, 0))
    cloud = pcl_cid.Cloud(points, sensor=[0.5, 0.5, 1.25])
    assert cloud.sensor.tolist() == [0.5, 0.5, 1.25, 1, 0, 0, 0]


@pytest.mark.parametrize("encoding", ["ascii", "binary", "compressed"])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_there_and_back(tmp_path, points, encoding, dtype):
    given = points.astype(dtype) + (UTM if dtype == np.float64 else 0)
    given[3] = np.nan
    label = np.arange(len(given))
    pcl_cid.write(tmp_path / "cloud.pcd", given, encoding, label=label, cid=given[:, 0])
    cloud = pcl_cid.read(tmp_path / "cloud.pcd")
    assert cloud.points.dtype == dtype
    assert np.array_equal(cloud.points, given, equal_nan=True)
    assert np.array_equal(cloud["label"], label)
    assert np.array_equal(cloud["cid"], given[:, 0].astype(np.float32), equal_nan=True)
