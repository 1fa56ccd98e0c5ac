# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Scans as other programs write them: NumPy, Open3D, gzip.

import gzip
import warnings

import numpy as np
import pytest

import pcl_cid


def read(path, **options):
    """A cloud, and what was said while it was read."""
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        cloud = pcl_cid.read(path, **options)
    return cloud, " ".join(str(each.message) for each in said)


def coordinates(cloud):
    return np.column_stack([cloud[axis] for axis in "xyz"])


@pytest.mark.parametrize("dtype", ["<f4", ">f4", "<f8", ">f8"])
@pytest.mark.parametrize("order", ["C", "F"])
def test_arrays_of_numpy(points, tmp_path, dtype, order):
    file = tmp_path / "points.npy"
    np.save(file, np.asarray(points, dtype=dtype, order=order))
    cloud, _ = read(file)
    assert np.array_equal(coordinates(cloud), points.astype(np.float32))


def test_images_and_records_of_numpy(points, tmp_path):
    image = points[:60].reshape(6, 10, 3)
    np.save(tmp_path / "image.npy", image)
    cloud, _ = read(tmp_path / "image.npy")
    assert np.array_equal(coordinates(cloud), points[:60].astype(np.float32))

    records = np.zeros(len(points), [("xyz", "f4", 3), ("rgb", "u1", 3), ("label", "i8")])
    records["xyz"] = points
    records["rgb"] = np.arange(3 * len(points)).reshape(-1, 3) % 256
    records["label"] = np.arange(len(points)) * 1000
    np.save(tmp_path / "records.npy", records)
    cloud, _ = read(tmp_path / "records.npy")
    assert np.array_equal(coordinates(cloud), records["xyz"])
    assert np.array_equal(cloud["label"], records["label"])
    assert "rgb" in cloud


@pytest.mark.parametrize("delimiter, header, comments", [
    (" ", "", "# "), (",", "x,y,z", ""), (";", "x;y;z", ""), ("\t", "x y z", "//"), (",", "x,y,z", "# ")])
def test_text_of_numpy(points, tmp_path, delimiter, header, comments):
    file = tmp_path / "points.txt"
    np.savetxt(file, points, delimiter=delimiter, header=header, comments=comments)
    cloud, said = read(file)
    assert np.array_equal(coordinates(cloud), points.astype(np.float32))
    assert ("by their order" in said) == (header == "")


def test_bytes_of_numpy(points, tmp_path):
    kitti = np.column_stack([points, np.linspace(0, 1, len(points))]).astype(np.float32)
    kitti.tofile(tmp_path / "000000.bin")
    cloud, said = read(tmp_path / "000000.bin")
    assert np.array_equal(coordinates(cloud), kitti[:, :3])
    assert np.array_equal(cloud["intensity"], kitti[:, 3])
    assert "KITTI" in said
    nuscenes = np.column_stack([kitti, np.arange(len(points)) % 32]).astype(np.float32)
    nuscenes.tofile(tmp_path / "scan.pcd.bin")
    cloud, said = read(tmp_path / "scan.pcd.bin")
    assert np.array_equal(cloud["ring"], nuscenes[:, 4])
    assert "nuScenes" in said


@pytest.mark.parametrize("extension", ["xyz", "pts", "xyzn", "xyzrgb", "ply", "pcd"])
def test_clouds_of_open3d(points, tmp_path, extension):
    open3d = pytest.importorskip("open3d")
    given = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points.astype(float)))
    if extension in ("pts", "xyzrgb"):
        given.colors = open3d.utility.Vector3dVector(np.full(points.shape, 0.5))
    if extension == "xyzn":
        given.normals = open3d.utility.Vector3dVector(np.tile([0.0, 0.6, 0.8], (len(points), 1)))
    file = tmp_path / f"cloud.{extension}"
    assert open3d.io.write_point_cloud(str(file), given)
    cloud, _ = read(file)
    assert coordinates(cloud) == pytest.approx(points, abs=1e-6)
    if extension in ("pts", "xyzrgb"):
        assert np.all(np.abs(cloud.colors.astype(int) - 127) <= 1)
    if extension == "xyzn":
        assert cloud["normal_z"] == pytest.approx(0.8)
    packed = tmp_path / f"cloud.{extension}.gz"
    packed.write_bytes(gzip.compress(file.read_bytes()))
    assert np.array_equal(coordinates(read(packed)[0]), coordinates(cloud))


@pytest.mark.parametrize("extension", ["obj", "stl", "off", "ply"])
def test_meshes_of_open3d(tmp_path, extension):
    open3d = pytest.importorskip("open3d")
    mesh = open3d.geometry.TriangleMesh.create_torus(1.0, 0.3)
    mesh.compute_triangle_normals()
    file = tmp_path / f"torus.{extension}"
    assert open3d.io.write_triangle_mesh(str(file), mesh)
    cloud, said = read(file, mesh_spacing=0.05)
    assert f"{len(mesh.triangles)} triangles" in said
    on_surface = coordinates(cloud).astype(np.float32)
    scene = open3d.t.geometry.RaycastingScene()
    scene.add_triangles(open3d.t.geometry.TriangleMesh.from_legacy(mesh))
    assert scene.compute_distance(open3d.core.Tensor(on_surface)).numpy().max() < 1e-5
    dense = np.asarray(mesh.sample_points_uniformly(20000).points)
    gaps = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(dense)).compute_point_cloud_distance(
        open3d.geometry.PointCloud(open3d.utility.Vector3dVector(on_surface.astype(float))))
    assert np.max(gaps) <= 1.5 * 0.05


def test_scale(points, tmp_path):
    np.savetxt(tmp_path / "mm.xyz", 1000.0 * points)
    cloud, _ = read(tmp_path / "mm.xyz", scale=0.001)
    assert coordinates(cloud) == pytest.approx(1000.0 * points, rel=1e-6)
    assert cloud.points == pytest.approx(points, abs=1e-6)
    volume = pcl_cid.Scan(points).parts(count=1)[0].volume
    assert pcl_cid.Scan(cloud).parts(count=1)[0].volume == pytest.approx(volume, rel=1e-3)
