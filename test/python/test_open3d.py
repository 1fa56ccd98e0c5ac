# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# To and from Open3D, by arrays.

import numpy as np
import pytest

import pcl_cid
from conftest import box_points

open3d = pytest.importorskip("open3d")


def test_point_cloud_there_and_back(points):
    cloud = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points.astype(float)))
    cloud.colors = open3d.utility.Vector3dVector(np.random.default_rng(0).random(points.shape))
    scan = pcl_cid.Scan(np.asarray(cloud.points), colors=np.asarray(cloud.colors), color=0.001)
    scan.propose(6)
    assert np.array_equal(scan.groups >= 0, np.ones(len(points), bool))
    palette = np.random.default_rng(1).random((6, 3))
    cloud.colors = open3d.utility.Vector3dVector(palette[scan.groups])
    assert np.allclose(np.asarray(cloud.colors), palette[scan.groups])


def test_hulls_as_meshes(points):
    scan = pcl_cid.Scan(points)
    for part in scan.parts(count=3):
        mesh = open3d.geometry.TriangleMesh(
            open3d.utility.Vector3dVector(part.vertices.copy()),  # Open3D asks for writable ones
            open3d.utility.Vector3iVector(part.faces.astype(np.int32)))
        assert mesh.is_watertight() and mesh.is_orientable()
        assert mesh.get_volume() == pytest.approx(part.volume, rel=1e-9)
        assert mesh.get_surface_area() == pytest.approx(part.area, rel=1e-9)


def test_scan_of_a_mesh():
    mesh = open3d.geometry.TriangleMesh.create_box()
    cloud = mesh.sample_points_uniformly(2000)
    scan = pcl_cid.Scan(np.asarray(cloud.points))
    scan.propose(6)
    (part,) = scan.parts(count=1)
    assert part.volume == pytest.approx(1.0, abs=0.05)


def test_files_of_each_other(tmp_path, points):
    pcl_cid.write(tmp_path / "cloud.pcd", points, encoding="binary")
    cloud = open3d.io.read_point_cloud(str(tmp_path / "cloud.pcd"))
    assert np.array_equal(np.asarray(cloud.points), points)
    open3d.io.write_point_cloud(str(tmp_path / "back.ply"), cloud)
    assert np.array_equal(pcl_cid.read(tmp_path / "back.ply").points, points)
    pcl_cid.save(tmp_path / "hulls.obj", pcl_cid.Scan(points).parts(count=2))
    assert open3d.io.read_triangle_mesh(str(tmp_path / "hulls.obj")).has_triangles()
