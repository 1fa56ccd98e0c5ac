# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# What the tests of the Python module share: the sample scan, the tools, a small scan.
#
#   PYTHONPATH=build/dev/python PCL_CID_TOOL_DIR=build/dev/bin pytest test/python

import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

import pcl_cid

PROJECT = Path(__file__).resolve().parents[2]
ROOM = PROJECT / "data" / "room.pcd"


def box_points(count=2000, seed=0):
    """Points on two boxes that touch: a small scan with something concave in it."""
    random = np.random.default_rng(seed)
    points = random.uniform(0.0, 1.0, (count, 3))
    points[np.arange(count), random.integers(0, 3, count)] = random.integers(0, 2, count)
    points[count // 2 :] = 0.4 * points[count // 2 :] + [1.0, 0.3, 0.3]
    return points.astype(np.float32)


@pytest.fixture
def points():
    return box_points()


@pytest.fixture
def scan(points):
    scan = pcl_cid.Scan(points)
    scan.propose(8)
    return scan


@pytest.fixture(scope="session")
def room():
    return pcl_cid.read(ROOM)


@pytest.fixture(scope="session")
def room_scan(room):
    scan = pcl_cid.Scan(room)
    scan.propose(100)
    return scan


@pytest.fixture
def run_tool(tmp_path):
    """Runs a tool in a folder of its own, quietly, and gives that folder."""
    folder = os.environ.get("PCL_CID_TOOL_DIR")
    if not folder:
        pytest.skip("PCL_CID_TOOL_DIR does not say where the tools are")
    outputs = tmp_path / "tool"
    outputs.mkdir()

    def run(tool, *arguments):
        command = [Path(folder).resolve() / tool, *arguments, "--quiet"]
        subprocess.run(list(map(str, command)), check=True, cwd=outputs)
        return outputs

    return run
