# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Bad input is a sentence that says which value, and what is allowed.

import numpy as np
import pytest

import pcl_cid
from conftest import box_points

POINTS = box_points(200)


@pytest.mark.parametrize("points, sentence", [
    ([1, 2, 3], r"has the shape \(3,\); it must be an array of shape \(N, 3\)"),
    (np.zeros((4, 2)), r"has the shape \(4, 2\)"),
    (np.zeros((2, 3, 3)), r"has the shape \(2, 3, 3\)"),
    (np.zeros((0, 3)), "at least 1 point is needed"),
    ([], r"has the shape \(0,\)"),
    (np.full((5, 3), np.nan), "none of the 5 points is finite; at least 1 must be"),
    (np.ones((4, 3), bool), "has the dtype bool"),
    (np.ones((4, 3), complex), "has the dtype complex128"),
    ("points", "has the shape"),
    ([["a", "b", "c"]], "has the dtype <U1"),
    ([[1, 2, 3], [4, 5]], "what is given as points is"),
    (None, "what is given as points is None; it must be an array"),
    (object(), "what is given as points is <object"),
    (np.full((3, 3), 1e16), "coordinates go to 1e15"),
])
def test_points(points, sentence):
    with pytest.raises(ValueError, match=sentence):
        pcl_cid.Scan(points)


@pytest.mark.parametrize("settings, sentence", [
    ({"samples": 1}, "the number of samples on a segment is 1; it must be a whole number, 2 to"),
    ({"samples": 2.5}, "is 2.5; it must be a whole number"),
    ({"samples": True}, "is True; it must be a whole number"),
    ({"samples": 10**30}, "is 1000000000000000000000000000000; it must be"),
    ({"random_seed": -1}, "the random seed is -1; it must be"),
    ({"normals": np.nan}, "the normal weight is nan; it must be"),
    ({"normals": "much"}, "the normal weight is 'much'; it must be"),
    ({"normals": -1}, "the normal weight is -1"),
    ({"density": "maybe"}, "density is 'maybe'; it must be 'auto', 'off' or 'on'"),
    ({"density": True}, "density is True"),
    ({"connected": "yes"}, "connected is 'yes'; it must be 'on' or 'off'"),
    ({"start_index": 200}, "200"),
    ({"threads": 5000}, "the number of threads is 5000"),
    ({"color": 0.1}, "the color weight is 0.1, but there are no colors"),
    ({"color": 0.1, "colors": np.zeros((3, 3))}, "there are 3 colors"),
    ({"colors": np.full((200, 3), 2.0)}, "the color of point 0 has the value 2"),
    ({"colors": np.full((200, 3), 300)}, "the color of point 0 has the value 300"),
    ({"sensor": [1, 2]}, r"the sensor is \[1, 2\]; it must be x, y, z"),
    ({"sensor": [1, 2, np.nan]}, "must be finite"),
    ({"sensor": "here"}, "the sensor is 'here'"),
    ({"paper": 1}, "paper is 1; it must be True or False"),
    ({"keep_zeros": None}, "keep_zeros is None"),
])
def test_settings(settings, sentence):
    with pytest.raises(ValueError, match=sentence):
        pcl_cid.Scan(POINTS, **settings)


def test_unknown_settings():
    with pytest.raises(TypeError, match="Scan.. has no setting 'sample'; there are samples, "):
        pcl_cid.Scan(POINTS, sample=3)
    with pytest.raises(TypeError, match="parts.. has no setting 'colour'; there are groups, "):
        pcl_cid.Scan(POINTS).parts(count=1, colour=3)


@pytest.mark.parametrize("seeds, labels, sentence", [
    ([-1], None, r"the array of seeds holds -1; it must be 0 to 200 - 1"),
    ([200], None, "holds 200"),
    ([2**40], None, "holds 1099511627776"),
    (np.array([2**64 - 1], np.uint64), None, "holds 18446744073709551615"),
    ([True], None, "has the dtype bool; it must be of whole numbers"),
    ([1.0], None, "has the dtype float64"),
    ([[1], [2]], None, r"has the shape \(2, 1\)"),
    (None, None, "what is given as seeds is None"),
    ([3], None, "point 3 is a seed already"),
    ([7, 7], None, "point 7 is a seed already"),
    ([7, 8], [1], "there are 1 labels; there must be one for each of the 2 seeds"),
    ([7], [-1], "the array of labels holds -1; a label must be a whole number"),
    ([7], [2**32], "holds 4294967296"),
    ([7], ["a"], "has the dtype"),
])
def test_add_seeds(seeds, labels, sentence):
    scan = pcl_cid.Scan(POINTS)
    scan.add_seeds([3])
    with pytest.raises(ValueError, match=sentence):
        scan.add_seeds(seeds, labels=labels)
    assert scan.seeds.tolist() == [3] and scan.seed_labels.tolist() == [1]


def test_remove_and_label_seeds():
    scan = pcl_cid.Scan(POINTS)
    scan.add_seeds([3, 4, 5], labels=[7, 2**32 - 1, 0])
    for change in (scan.remove_seeds, lambda seeds: scan.label_seeds(seeds, seeds)):
        with pytest.raises(ValueError, match="point 9 is none of the 3 seeds; it must be one"):
            change([3, 9])
        with pytest.raises(ValueError, match="seed 4 is given twice"):
            change([4, 4])
    with pytest.raises(ValueError, match="the largest label of a seed is 4294967295"):
        scan.add_seeds([6])
    scan.remove_seeds([4])
    scan.add_seeds([6])
    assert scan.seed_labels.tolist() == [7, 0, 8]
    scan.remove_seeds(scan.seeds)
    assert (scan.groups == -1).all() and not scan.labels().any()


def test_parts():
    scan = pcl_cid.Scan(POINTS)
    with pytest.raises(pcl_cid.CIDError, match="seed"):
        scan.parts(threshold=0.1)
    with pytest.raises(pcl_cid.CIDError, match="seed"):
        scan.merge_tree()
    scan.propose(5)
    for settings, sentence in [
        ({"count": 0}, "the number of parts is 0"),
        ({"count": 3, "threshold": 1.0}, "only one of them may be given"),
        ({"error": 0}, "the bound on the error of hulls is 0"),
        ({"error": 0.1, "threshold": 1.0}, "need merging by hull"),
        ({"merging": "hull"}, "needs a count or an error"),
        ({"merging": "hull", "count": 3, "group_samples": 4}, "are about groups"),
        ({"merging": "hull", "count": 3, "groups": "patches"}, "are about groups"),
        ({"groups": "planes"}, "groups is 'planes'; it must be 'cid' or 'patches'"),
        ({"threshold": 1.0, "seeds": 7}, "needs groups='patches'"),
        ({"groups": "patches", "seeds": 0}, "the number of seeds is 0"),
        ({"merging": "best"}, "merging is 'best'; it must be 'cid' or 'hull'"),
        ({"count": 3, "max_vertices": 3}, "the largest number of vertices is 3"),
        ({"count": 3, "max_vertices": "few"}, "is 'few'"),
        ({"count": 3, "viewpoints": [[0, 0, np.inf]]}, "row 0 of the array of viewpoints"),
    ]:
        with pytest.raises(ValueError, match=sentence):
            scan.parts(**settings)
    with pytest.raises(ValueError, match="needs groups='patches'"):
        scan.merge_tree(seeds=7)
    with pytest.raises(pcl_cid.CIDError, match="fewer than 500 points"):
        scan.parts(threshold=0.1, min_points=500)


def test_cuts():
    scan = pcl_cid.Scan(POINTS)
    scan.propose(5)
    tree = scan.merge_tree()
    for cut, sentence in [({"count": 0}, "the number of parts is 0"),
                          ({"threshold": -1}, "the merge threshold is -1"),
                          ({"merges": "all"}, "the number of merges is 'all'"),
                          ({"count": 1, "merges": 1}, "only one of them may be given")]:
        with pytest.raises(ValueError, match=sentence):
            tree.cut(**cut)


def test_cids():
    with pytest.raises(ValueError, match="must have as many"):
        pcl_cid.point_cid(POINTS, POINTS[:3], POINTS[:4])
    with pytest.raises(ValueError, match="row 0 of the array of positions p is not finite"):
        pcl_cid.point_cid(POINTS, [0, 0, np.nan], [0, 0, 0])
    with pytest.raises(ValueError, match="the tolerance is 0; it must be a number of metres"):
        pcl_cid.point_cid(POINTS, [0, 0, 0], [1, 1, 1], tolerance=0)
    with pytest.raises(ValueError, match="at least 1 point in each"):
        pcl_cid.group_cid(POINTS, POINTS[:0].reshape(0, 3), POINTS[:1])
    with pytest.raises(ValueError, match="it must be the index of one point"):
        pcl_cid.Scan(POINTS).cid_from([1, 2])


def test_evaluate():
    with pytest.raises(ValueError, match="prediction has 3 points and the truth 2"):
        pcl_cid.evaluate([1, 2, 3], [1, 2])
    with pytest.raises(ValueError, match="protocol is 'best'; it must be 'paper', 'scannet' or"):
        pcl_cid.evaluate([1], [1], protocol="best")
    with pytest.raises(ValueError, match="5"):
        pcl_cid.evaluate([5], [1], protocol="paper")
    with pytest.raises(ValueError, match="of 1 scans and the truth of 2"):
        pcl_cid.evaluate([[1]], [[1], [2]])


def test_files(tmp_path):
    with pytest.raises(pcl_cid.CIDError, match="there is no such file"):
        pcl_cid.read(tmp_path / "none.pcd")
    with pytest.raises(TypeError):
        pcl_cid.read(3)
    (tmp_path / "bad.pcd").write_text("no cloud")
    with pytest.raises(pcl_cid.CIDError, match="bad.pcd"):
        pcl_cid.read(tmp_path / "bad.pcd")
    with pytest.raises(pcl_cid.CIDError, match="xyz"):
        pcl_cid.write(tmp_path / "cloud.xyz", POINTS)
    with pytest.raises(ValueError, match="there are 3 values of the field 'label'"):
        pcl_cid.write(tmp_path / "cloud.pcd", POINTS, label=[1, 2, 3])
    with pytest.raises(ValueError, match="the encoding is 'zip'; for .* there are 'ascii'"):
        pcl_cid.write(tmp_path / "cloud.pcd", POINTS, encoding="zip")
    with pytest.raises(ValueError, match="obj"):
        pcl_cid.save(tmp_path / "hulls.glb", [])
    with pytest.raises(ValueError, match="the name 'a b' .* letters"):
        pcl_cid.save(tmp_path / "hulls.obj", [], name="a b")
    with pytest.raises(TypeError, match="part 0 is 3; it must be a ConvexPart"):
        pcl_cid.save(tmp_path / "hulls.obj", [3])
    with pytest.raises(TypeError, match="parts is 3; it must be a sequence of ConvexPart"):
        pcl_cid.save(tmp_path / "hulls.obj", 3)
    assert [file.name for file in tmp_path.iterdir()] == ["bad.pcd"]
