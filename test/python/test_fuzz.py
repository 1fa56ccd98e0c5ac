# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Whatever is given: an answer, or an error of Python that says something; never a crash.

import copy

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import pcl_cid
from conftest import box_points

POINTS = box_points(60)
ERRORS = (ValueError, TypeError, pcl_cid.CIDError, KeyError, OverflowError, IndexError)

scalars = st.one_of(st.none(), st.booleans(), st.integers(), st.floats(), st.text(max_size=8),
                    st.binary(max_size=8), st.complex_numbers(),
                    st.sampled_from([object(), np.float32(2), np.int8(-3), np.bool_(True),
                                     np.datetime64("now"), print, int, Ellipsis]))
arrays = hnp.arrays(st.one_of(hnp.scalar_dtypes(), hnp.unicode_string_dtypes()),
                    hnp.array_shapes(min_dims=0, max_dims=3, min_side=0, max_side=5))
small = hnp.arrays(st.sampled_from(["f4", "f8", "i4", "u8", ">f4", "f2"]),
                   st.tuples(st.integers(0, 12), st.just(3)))
anything = st.one_of(scalars, arrays, small, st.lists(scalars, max_size=4),
                     st.dictionaries(st.text(max_size=3), scalars, max_size=2),
                     st.lists(st.integers(-2, 62), max_size=5))

many = settings(max_examples=80, deadline=None, database=None,
                suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much])


def call(function, *arguments, **keywords):
    try:
        return function(*arguments, **keywords)
    except ERRORS as error:
        assert str(error)


def fresh():
    scan = pcl_cid.Scan(POINTS, threads=1)
    scan.add_seeds([3, 40])
    return scan


SCAN = fresh()


@many
@given(anything, anything, anything)
def test_scan(points, colors, sensor):
    call(pcl_cid.Scan, points)
    call(pcl_cid.Scan, POINTS, colors, sensor)


@many
@given(st.sampled_from(sorted(pcl_cid.Scan._settings)), anything)
def test_settings_of_a_scan(name, value):
    call(pcl_cid.Scan, POINTS, **{name: value})


@many
@given(st.sampled_from(["propose", "add_seeds", "remove_seeds", "label_seeds", "labels", "cids",
                        "cid_from", "merge_tree", "parts"]),
       st.lists(anything, max_size=3))
def test_verbs(name, arguments):
    scan = fresh()
    call(getattr(scan, name), *arguments)
    assert len(scan.labels()) == len(POINTS)


@many
@given(st.sampled_from([*pcl_cid.Scan._part_settings, "count", "error", "merging", "viewpoints"]),
       anything)
def test_settings_of_parts(name, value):
    call(SCAN.parts, **{"count": 2, name: value})


@many
@given(anything, anything, anything, anything)
def test_functions(a, b, c, d):
    call(pcl_cid.point_cid, a, b, c)
    call(pcl_cid.point_cid, SCAN, a, b, c, d)
    call(pcl_cid.group_cid, SCAN, a, b, c)
    call(pcl_cid.evaluate, a, b, "s3dis", c, d)
    call(SCAN.merge_tree().cut, a, b, c)


@many
@given(anything, anything, st.text(max_size=5))
def test_clouds(points, column, name):
    call(pcl_cid.Cloud, points)
    cloud = pcl_cid.Cloud(POINTS)
    call(cloud.__setitem__, name, column)
    call(cloud.__getitem__, name)
    call(cloud.__getitem__, column)
    assert np.array_equal(cloud.points, POINTS)


@many
@given(anything, anything)
def test_files(tmp_path_factory, path, content):
    if not isinstance(path, (str, bytes, int, bool)):  # int: os.fsencode refuses it as well
        call(pcl_cid.read, path)
        call(pcl_cid.save, path, content)
        call(pcl_cid.write, path, content)
    call(pcl_cid.write, tmp_path_factory.getbasetemp() / "cloud.ply", content)
    call(pcl_cid.save, tmp_path_factory.getbasetemp() / "hulls.ply", content)


@pytest.mark.parametrize("cls", [pcl_cid.MergeTree, pcl_cid.ConvexPart])
def test_what_has_no_constructor(cls):
    with pytest.raises(TypeError, match="is made by a Scan alone"):
        cls()
    with pytest.raises(TypeError):
        cls.__new__(cls)


def test_what_has_no_copy():
    for each in (SCAN, SCAN.merge_tree(), SCAN.parts(count=1)[0], pcl_cid.Cloud(POINTS)):
        with pytest.raises(TypeError):
            copy.copy(each)
