# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The block of doc/python.md runs as it is written there.

import re

import pcl_cid
from conftest import PROJECT, ROOM

PAGE = PROJECT / "doc" / "python.md"


def test_block_of_the_page(tmp_path, monkeypatch):
    (tmp_path / "room.pcd").symlink_to(ROOM)
    monkeypatch.chdir(tmp_path)
    block = re.search(r"```python\n(.*?)```", PAGE.read_text(), re.DOTALL)[1]
    names = {}
    exec(compile(block, str(PAGE), "exec"), names)
    assert (tmp_path / "hulls.obj").exists()
    assert isinstance(names["scan"], pcl_cid.Scan)
    assert len(names["parts"]) == 30
