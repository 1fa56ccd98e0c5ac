#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Picture of hulls (OBJ) by VTK, which sorts what is in front; what is above a height is
# cut off. Needs python3-vtk9; without a display, xvfb-run -a /usr/bin/python3.

import argparse

import numpy as np
import vtk

from render_pictures import palette, read_obj


def mesh_of(vertices, triangles):
    points, polygons = vtk.vtkPoints(), vtk.vtkCellArray()
    number = {}
    for triangle in triangles:
        polygons.InsertNextCell(3)
        for v in triangle:
            if v not in number:
                number[v] = points.InsertNextPoint(vertices[v])
            polygons.InsertCellPoint(number[v])
    mesh = vtk.vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(polygons)
    return mesh


def below(mesh, height):
    """The part of a closed mesh below a height, closed again."""
    plane = vtk.vtkPlane()
    plane.SetOrigin(0, 0, height)
    plane.SetNormal(0, 0, -1)
    planes = vtk.vtkPlaneCollection()
    planes.AddItem(plane)
    clip = vtk.vtkClipClosedSurface()
    clip.SetInputData(mesh)
    clip.SetClippingPlanes(planes)
    clip.Update()
    return clip.GetOutput()


def actor_of(mesh, color):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(*color)
    look.SetInterpolationToFlat()
    look.EdgeVisibilityOn()
    look.SetEdgeColor(0.25, 0.25, 0.25)
    look.SetLineWidth(0.5)
    return actor


def look_from(renderer, up, azimuth, elevation, zoom):
    camera = renderer.GetActiveCamera()
    bounds = renderer.ComputeVisiblePropBounds()
    middle = np.add(bounds[0::2], bounds[1::2]) / 2
    camera.SetFocalPoint(*middle)
    camera.SetPosition(*(middle + ([1, 0, 0] if up == "z" else [0, 0, -1])))
    camera.SetViewUp(*{"z": (0, 0, 1), "-y": (0, -1, 0)}[up])
    camera.Azimuth(azimuth)
    camera.Elevation(elevation)
    renderer.ResetCamera()
    camera.Zoom(zoom)
    renderer.ResetCameraClippingRange()


def save(renderer, path, size):
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


def main():
    parser = argparse.ArgumentParser(description="Render hulls.")
    parser.add_argument("hulls", help="OBJ, an object for each hull")
    parser.add_argument("picture", help="PNG")
    parser.add_argument("--up", choices=["z", "-y"], default="z")
    parser.add_argument("--azimuth", type=float, default=35, help="degrees")
    parser.add_argument("--elevation", type=float, default=50, help="degrees")
    parser.add_argument("--zoom", type=float, default=1.5)
    parser.add_argument("--cut-above", type=float, help="metres along z")
    parser.add_argument("--size", type=int, nargs=2, default=[800, 580], help="pixels")
    arguments = parser.parse_args()
    vertices, hulls = read_obj(arguments.hulls)
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for triangles, color in zip(hulls, palette(len(hulls))):
        mesh = mesh_of(vertices, triangles)
        if arguments.cut_above is not None:
            mesh = below(mesh, arguments.cut_above)
        renderer.AddActor(actor_of(mesh, color))
    look_from(renderer, arguments.up, arguments.azimuth, arguments.elevation, arguments.zoom)
    save(renderer, arguments.picture, arguments.size)


if __name__ == "__main__":
    main()
