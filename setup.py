# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The Python module as a wheel: CMake builds it, with the library inside.

import os
import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent


def version():
    return re.search(r"VERSION (\d+\.\d+\.\d+)", (ROOT / "CMakeLists.txt").read_text())[1]


class CMakeBuild(build_ext):
    """CMake's target and its installation, in the place of a compiler's call."""

    def build_extension(self, ext):
        folder = Path(self.build_temp).resolve()
        options = {
            "CMAKE_BUILD_TYPE": "Release",
            "CMAKE_UNITY_BUILD": "ON",
            "CMAKE_UNITY_BUILD_BATCH_SIZE": "12",
            "BUILD_SHARED_LIBS": "OFF",
            "PCL_CID_BUILD_TOOLS": "OFF",
            "PCL_CID_FEW_POINT_TYPES": "ON",
            "PCL_CID_PYTHON_DIR": ".",
            "Python_EXECUTABLE": sys.executable,
        }
        jobs = str(self.parallel or os.cpu_count() or 1)
        self.run_cmake("-S", ROOT, "-B", folder, *(f"-D{k}={v}" for k, v in options.items()))
        self.run_cmake("--build", folder, "--target", "pcl_cid_python_package", "-j", jobs)
        self.run_cmake(
            "--install", folder, "--component", "python", "--strip",
            "--prefix", Path(self.get_ext_fullpath(ext.name)).resolve().parents[1],
        )

    def run_cmake(self, *arguments):
        subprocess.run(["cmake", *map(str, arguments)], check=True)


(ROOT / "build").mkdir(exist_ok=True)
setup(
    version=version(),
    packages=[],
    ext_modules=[Extension("pcl_cid._pcl_cid", [])],
    cmdclass={"build_ext": CMakeBuild},
    options={"egg_info": {"egg_base": "build"}},
    zip_safe=False,
)
