# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The stub: as mypy sees it, and as the module is.

import inspect
import subprocess
from pathlib import Path

import pytest

import pcl_cid

GOOD = """
import numpy as np
import pcl_cid
scan = pcl_cid.Scan(np.zeros((4, 3)), samples=10, density="off", connected=True, threads=1)
stop: str = scan.propose(3, progress=lambda fraction: fraction < 1)
groups = scan.groups + 1
parts = scan.parts(count=np.int64(3), max_vertices="auto")
volume: float = sum(part.volume for part in parts)
pcl_cid.save("hulls.obj", parts)
pcl_cid.save("hulls.obj", parts, name="hall")
pcl_cid.write("cloud.pcd", pcl_cid.read("cloud.pcd"), label=groups)
"""
BAD = {
    'pcl_cid.Scan([[0, 0, 0]], sample=10)': "Unexpected keyword",
    'pcl_cid.Scan([[0, 0, 0]], density="maybe")': "incompatible type",
    'pcl_cid.save("hulls.obj", [3])': "incompatible type",
    'pcl_cid.evaluate([1], [1], protocol="best")': "incompatible type",
}


def mypy(folder, text):
    pytest.importorskip("mypy")
    (folder / "checked.py").write_text(text)
    return subprocess.run(
        ["/usr/bin/python3", "-m", "mypy", "--strict", "--cache-dir", folder / "cache", "checked.py"],
        cwd=folder, capture_output=True, text=True,
        env={"MYPYPATH": str(Path(pcl_cid.__file__).parents[1])}).stdout


def test_mypy(tmp_path):
    assert "Success" in mypy(tmp_path, GOOD)
    errors = mypy(tmp_path, "import pcl_cid\n" + "\n".join(BAD) + "\n").splitlines()
    for number, sentence in enumerate(BAD.values(), start=2):
        assert any(f":{number}: error" in line and sentence in line for line in errors)


def test_stub_names_all_that_is_there():
    stub = (Path(pcl_cid.__file__).parent / "__init__.pyi").read_text()
    for name in pcl_cid.__all__:
        assert f"class {name}" in stub or f"def {name}(" in stub
        for member, value in vars(getattr(pcl_cid, name)).items() if "class " + name in stub else ():
            if not member.startswith("_"):
                assert f"def {member}(" in stub, f"{name}.{member}"
    assert (Path(pcl_cid.__file__).parent / "py.typed").exists()


def test_everything_is_told_of():
    for name in pcl_cid.__all__:
        each = getattr(pcl_cid, name)
        assert inspect.getdoc(each), name
        for member, value in vars(each).items() if inspect.isclass(each) else ():
            if not member.startswith("_"):
                assert inspect.getdoc(value), f"{name}.{member}"


def test_keywords_are_rows_of_the_table():
    rows = {row["name"]: row for row in pcl_cid.settings()}
    told = pcl_cid.Scan.__init__.__doc__
    for name, default in pcl_cid.Scan._settings.items():
        assert default == rows[name]["default"] or default is None
        assert f"{name} : {rows[name]['type']}, default {default!r}\n" in told
        assert rows[name]["meaning"] in told and rows[name]["range"] in told
    for name in pcl_cid.Scan._part_settings:
        assert rows[name]["meaning"] in pcl_cid.Scan.parts.__doc__
    scan = pcl_cid.Scan([[0, 0, 0]], paper=True, samples=7)
    for name, value in scan.settings.items():
        assert value == (7 if name == "samples" else None if name == "start_index"
                         else rows[name]["paper"])
