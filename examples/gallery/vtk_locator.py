#!/usr/bin/env python3
"""VTK's static cell locator before the judge (docs/gallery.md), package python3-vtk9.

    zproof run room --precision plane_ray \
        --renderer '/usr/bin/python3 examples/gallery/vtk_locator.py {scene} {camera} {out}'
"""
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import mutable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkGenericCell, vtkPolyData, vtkStaticCellLocator

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'contract'))
import zproof_contract as contract  # noqa: E402
from reach import end_of_rays  # noqa: E402


def locator_of(corners):
    points, cells, mesh = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(corners, deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.arange(len(corners)), deep=True))
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    locator = vtkStaticCellLocator()
    locator.SetDataSet(mesh)
    locator.BuildLocator()
    return locator


def render(triangles, camera):
    frame = contract.Frame(camera.width, camera.height)
    corners = np.array(triangles, dtype=np.float32).reshape(-1, 3)
    end = end_of_rays(corners, camera)
    if not end > camera.near:
        return frame
    locator, cell = locator_of(corners), vtkGenericCell()
    share, part, triangle, place, weights = mutable(0.0), mutable(0), mutable(0), [0.0] * 3, [0.0] * 3
    for y in range(camera.height):
        for x in range(camera.width):
            origin, direction = camera.ray(x, y)
            first, last = ([o + depth * d for o, d in zip(origin, direction)] for depth in (camera.near, end))
            if locator.IntersectWithLine(first, last, 0.0, share, place, weights, part, triangle, cell):
                frame.set(x, y, int(triangle), camera.near + (end - camera.near) * float(share))
    return frame


contract.main(render)
