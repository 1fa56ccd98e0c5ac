#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# A collision scene: hulls for the picture, and the same hulls as URDF and MJCF by
# pcl_cid_abstract; MuJoCo loads the scene, where its library is there.
#
#   collision_scene.py room.pcd OUTPUT_FOLDER [pcl_cid_abstract]

import ctypes
import ctypes.util
import os
import subprocess
import sys
from pathlib import Path

from mpl_toolkits.mplot3d.art3d import Poly3DCollection

import pcl_cid
from drawing import HIGHEST, palette, plt, save

COUNT = 30


def draw_hulls(axes, parts):
    colors = palette(len(parts))
    floor = min(part.vertices[:, 2].min() for part in parts)
    for part, color in zip(parts, colors):
        if part.vertices[:, 2].max() < floor + HIGHEST:  # neither walls nor the ceiling
            axes.add_collection3d(Poly3DCollection(part.vertices[part.faces], facecolor=color,
                                                   edgecolor="k", lw=0.1, alpha=0.6))
    low = min(tuple(part.vertices.min(axis=0)) for part in parts)
    axes.auto_scale_xyz(*zip(low, *(part.vertices.max(axis=0) for part in parts)))
    axes.set_axis_off()


def load_in_mujoco(scene):
    """By MuJoCo's own library: Debian has no Python package of it."""
    name = ctypes.util.find_library("mujoco")
    if name is None:
        print("There is no MuJoCo here (Debian: libmujoco-dev); the scene was written all the same.")
        return
    mujoco = ctypes.CDLL(name)
    mujoco.mj_loadXML.restype = ctypes.c_void_p
    complaint = ctypes.create_string_buffer(1000)
    model = mujoco.mj_loadXML(os.fsencode(scene), None, complaint, len(complaint))
    if not model:
        sys.exit(f"{scene}: {complaint.value.decode()}")
    mujoco.mj_deleteModel(ctypes.c_void_p(model))
    print(f"MuJoCo has loaded {scene}")


def main(path, folder, tool="pcl_cid_abstract"):
    parts = pcl_cid.Scan(pcl_cid.read(path)).parts(count=COUNT)
    pcl_cid.save(folder / "hulls.obj", parts)
    figure, axes = plt.subplots(figsize=(7, 6), subplot_kw={"projection": "3d"})
    draw_hulls(axes, parts)
    axes.set_title(f"{len(parts)} hulls, {sum(part.volume for part in parts):.1f} m³")
    save(figure, folder / "collision_scene.png")
    subprocess.run([tool, path, folder / "scene.obj", "--parts", str(COUNT), "--quiet",
                    "--urdf", folder / "scene.urdf", "--mjcf", folder / "scene.xml"], check=True)
    load_in_mujoco(folder / "scene.xml")


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]), *sys.argv[3:])
