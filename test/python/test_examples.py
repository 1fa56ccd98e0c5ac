# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The examples of doc/examples/python run, on a part of the sample scan, and draw.

import ctypes.util
import os
import subprocess
import sys
from pathlib import Path

import pytest

import pcl_cid
from conftest import PROJECT

pytest.importorskip("matplotlib")
EXAMPLES = sorted((PROJECT / "doc" / "examples" / "python").glob("*_*.py"))


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_example(example, room, tmp_path):
    pcl_cid.write(tmp_path / "part.pcd", room.points[::9], label=room["label"][::9])
    arguments = [tmp_path / "part.pcd", tmp_path]
    if example.stem == "collision_scene":
        if not os.environ.get("PCL_CID_TOOL_DIR"):
            pytest.skip("PCL_CID_TOOL_DIR does not say where the tools are")
        arguments.append(Path(os.environ["PCL_CID_TOOL_DIR"]).resolve() / "pcl_cid_abstract")
    printed = subprocess.run([sys.executable, example, *arguments], check=True, text=True,
                             stdout=subprocess.PIPE).stdout
    pictures = list(tmp_path.glob("*.png"))
    assert pictures and all(picture.stat().st_size > 10000 for picture in pictures)
    if example.stem == "collision_scene":
        assert (tmp_path / "scene.obj").read_bytes().split(b"\n", 9)[9] == \
            (tmp_path / "hulls.obj").read_bytes().split(b"\n", 9)[9]
        assert (tmp_path / "scene.urdf").exists()
        if ctypes.util.find_library("mujoco"):
            assert f"MuJoCo has loaded {tmp_path / 'scene.xml'}" in printed
