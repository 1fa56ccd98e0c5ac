# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# What Python computes and writes is what the tools do, byte for byte.

import json
import math

import numpy as np
import pytest

import pcl_cid
from conftest import ROOM, box_points


def assert_same_files(folder, other, *names):
    for name in names:
        assert (folder / name).read_bytes() == (other / name).read_bytes(), name


def test_groups(room, room_scan, run_tool, tmp_path):
    tool = run_tool("pcl_cid_segment", ROOM, "groups.pcd", "--propose", "seeds.csv")
    pcl_cid.write(tmp_path / "groups.pcd", room, label=room_scan.groups + 1)
    assert_same_files(tool, tmp_path, "groups.pcd")
    pcl_cid.write(tmp_path / "groups.pcd", room, label=room_scan.labels())
    assert_same_files(tool, tmp_path, "groups.pcd")
    rows = np.genfromtxt(tool / "seeds.csv", delimiter=",", names=True)
    assert np.array_equal(rows["index"], room_scan.seeds)


@pytest.mark.parametrize("clean_up", ["off", "on"])
def test_labels(room, run_tool, tmp_path, clean_up):
    tool = run_tool("pcl_cid_segment", ROOM, "labelled.pcd", "--labels-from", "label",
                    "--seeds", "40", "--clean-up", clean_up)
    scan = pcl_cid.Scan(room.points)
    scan.propose(40)
    scan.label_seeds(scan.seeds, room["label"][scan.seeds])
    pcl_cid.write(tmp_path / "labelled.pcd", room, label=scan.labels(clean_up=clean_up))
    assert_same_files(tool, tmp_path, "labelled.pcd")


def test_labels_of_given_seeds(room, run_tool, tmp_path):
    seeds = np.arange(500, 140000, 9000)
    labels = room["label"][seeds]
    table = "".join(f"{i},{k}\n" for i, k in zip(seeds, labels))
    (tmp_path / "seeds.csv").write_text("index,label\n" + table)
    tool = run_tool("pcl_cid_segment", ROOM, "labelled.ply", "--labels", tmp_path / "seeds.csv")
    scan = pcl_cid.Scan(room)
    scan.add_seeds(seeds[:5], labels=labels[:5])
    scan.add_seeds(seeds[5:], labels=labels[5:])
    pcl_cid.write(tmp_path / "labelled.ply", room, label=scan.labels())
    assert_same_files(tool, tmp_path, "labelled.ply")


def test_settings_of_the_paper(room, run_tool, tmp_path):
    tool = run_tool("pcl_cid_segment", ROOM, "groups.pcd", "--paper", "--subsample", "20000",
                    "--seeds", "30", "--samples", "50", "--random-seed", "7")
    scan = pcl_cid.Scan(room, paper=True, subsample=20000, samples=50, random_seed=7)
    scan.propose(30)
    pcl_cid.write(tmp_path / "groups.pcd", room, label=scan.labels())
    assert_same_files(tool, tmp_path, "groups.pcd")


def test_coverage(room, run_tool, tmp_path):
    tool = run_tool("pcl_cid_segment", ROOM, "groups.pcd", "--coverage", "0.2")
    scan = pcl_cid.Scan(room)
    assert scan.propose(coverage=0.2) == "coverage"
    pcl_cid.write(tmp_path / "groups.pcd", room, label=scan.labels())
    assert_same_files(tool, tmp_path, "groups.pcd")


def test_heat_map(room, room_scan, run_tool, tmp_path):
    tool = run_tool("pcl_cid_segment", ROOM, "heat.pcd", "--cid-from", "1234")
    pcl_cid.write(tmp_path / "heat.pcd", room, cid=room_scan.cid_from(1234))
    assert_same_files(tool, tmp_path, "heat.pcd")


def test_hulls_of_merged_groups(room, room_scan, run_tool, tmp_path):
    tool = run_tool("pcl_cid_abstract", ROOM, "hulls.obj", "--merging", "cid", "--parts", "20",
                    "--max-vertices", "40", "--labels", "parts.pcd", "--tree", "tree.json")
    parts = room_scan.parts(count=20, merging="cid", max_vertices=40)
    pcl_cid.save(tmp_path / "hulls.obj", parts)
    labels = np.zeros(len(room), np.uint32)
    for number, part in enumerate(parts):
        labels[part.indices] = number + 1
    pcl_cid.write(tmp_path / "parts.pcd", room, label=labels)
    assert_same_files(tool, tmp_path, "hulls.obj", "hulls.mtl", "parts.pcd")
    tree = room_scan.merge_tree()
    steps = json.loads((tool / "tree.json").read_text())["steps"]
    assert [[step["first"], step["second"]] for step in steps] == tree.merges.tolist()
    assert [step["height"] for step in steps] == tree.heights.tolist()


def test_hulls_of_patches(room_scan, run_tool, tmp_path):
    tool = run_tool("pcl_cid_abstract", ROOM, "hulls.obj", "--groups", "patches", "--seeds", "40",
                    "--parts", "12", "--tree", "tree.json")
    parts = room_scan.parts(count=12, groups="patches", seeds=40)
    pcl_cid.save(tmp_path / "hulls.obj", parts)
    assert_same_files(tool, tmp_path, "hulls.obj")
    tree = room_scan.merge_tree(groups="patches", seeds=40)
    steps = json.loads((tool / "tree.json").read_text())["steps"]
    assert [step["height"] for step in steps] == tree.heights.tolist()


@pytest.fixture
def boxes(tmp_path):
    """A small scan as a file."""
    pcl_cid.write(tmp_path / "boxes.pcd", box_points())
    return tmp_path / "boxes.pcd"


@pytest.mark.parametrize("extension", ["obj", "ply", "stl"])
@pytest.mark.parametrize("cut", [{}, {"threshold": 0.1}, {"merges": 9}, {"count": 4}])
def test_cuts_of_the_merge_tree(boxes, run_tool, tmp_path, cut, extension):
    name = f"hulls.{extension}"
    options = [word for key, value in cut.items()
               for word in ("--" + key.replace("count", "parts"), value)]
    tool = run_tool("pcl_cid_abstract", boxes, name, *options, "--merging", "cid",
                    "--seeds", "14", "--min-points", "20", "--padding", "0.01")
    scan = pcl_cid.Scan(box_points())
    scan.propose(14)
    parts = scan.parts(**cut, merging="cid", min_points=20, padding=0.01)
    pcl_cid.save(tmp_path / name, parts)
    assert_same_files(tool, tmp_path, name)


def test_names_of_parts(boxes, run_tool, tmp_path):
    tool = run_tool("pcl_cid_abstract", boxes, "my hulls.obj", "--parts", "4", "--name", "hall")
    parts = pcl_cid.Scan(box_points()).parts(count=4)
    pcl_cid.save(tmp_path / "my hulls.obj", parts, name="hall")
    assert_same_files(tool, tmp_path, "my hulls.obj", "my_hulls.mtl")
    assert "o hall_part_000" in (tmp_path / "my hulls.obj").read_text()


def test_fitted_hulls(room, run_tool, tmp_path):
    tool = run_tool("pcl_cid_abstract", ROOM, "hulls.obj", "--parts", "30")
    pcl_cid.save(tmp_path / "hulls.obj", pcl_cid.Scan(room.points).parts(count=30))
    assert_same_files(tool, tmp_path, "hulls.obj")


def test_fitted_hulls_with_a_bound(boxes, run_tool, tmp_path):
    (tmp_path / "eyes.csv").write_text("x,y,z\n-1,0.5,0.5\n3,0.5,0.5\n")
    tool = run_tool("pcl_cid_abstract", boxes, "hulls.obj", "--parts", "12", "--max-error", "0.3",
                    "--robot-radius", "0.1", "--max-vertices", "auto",
                    "--viewpoints", tmp_path / "eyes.csv")
    parts = pcl_cid.Scan(box_points()).parts(
        count=12, error=0.3, robot_radius=0.1, max_vertices="auto",
        viewpoints=[[-1, 0.5, 0.5], [3, 0.5, 0.5]])
    pcl_cid.save(tmp_path / "hulls.obj", parts)
    assert_same_files(tool, tmp_path, "hulls.obj")


@pytest.mark.parametrize("protocol", ["paper", "scannet", "s3dis"])
@pytest.mark.parametrize("has_classes", [True, False])
def test_scores(room, room_scan, run_tool, tmp_path, protocol, has_classes):
    labels = room["label"][room_scan.seeds][room_scan.groups]
    truth = {"label": room["label"], **({"semantic": room["semantic"]} if has_classes else {})}
    pcl_cid.write(tmp_path / "prediction.pcd", room.points, label=labels)
    pcl_cid.write(tmp_path / "truth.pcd", room.points, **truth)
    tool = run_tool("pcl_cid_evaluate", tmp_path / "prediction.pcd", tmp_path / "truth.pcd",
                    "--protocol", protocol, "--report", "scores.json",
                    *(["--classes", "s3dis"] if has_classes else []))
    report = json.loads((tool / "scores.json").read_text())
    scores = pcl_cid.evaluate(labels, room["label"], protocol=protocol,
                              truth_classes=truth.get("semantic"),
                              classes=range(1, 14) if has_classes else None)
    for name in ("labelled_points", "truth_instances", "groups", "purity", "mean_iou"):
        assert scores[name] == report[name]
    assert len(scores["classes"]) == len(report["classes"])
    for ours, theirs in zip([scores["mean"], *scores["classes"]],
                            [report["mean"], *report["classes"]]):
        for name, value in ours.items():
            assert value == theirs[name] or (theirs[name] is None and math.isnan(value))
