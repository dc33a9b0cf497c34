#!/usr/bin/env python3
"""VTK before the judge (docs/python.md): ids by a colour for each cell, depth from the z-buffer.

Packages python3-vtk9, and xvfb where there is no display. docs/gallery.md tells what VTK promises.
"""
import os
import sys

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the renderer itself
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkRenderWindow
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLPolyDataMapper

import zproof

SCENES = ["room", "near_plane", "t_junctions", "orthographic"]
SIZE = (320, 180)
STEPS = 0xFFFFFF  # of a depth buffer of 24 bits
BACKGROUND_COLOUR = 0xFFFFFF


def actor_of(scene):
    """One cell for each triangle; the colour of cell i is i in three bytes."""
    points, cells, mesh = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(scene.positions, deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(scene.triangles.astype(np.int64).ravel(), deep=True))
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    ids = np.arange(scene.triangle_count, dtype=np.uint32)
    mesh.GetCellData().SetScalars(numpy_to_vtk(ids.view(np.uint8).reshape(-1, 4)[:, :3].copy(), deep=True))
    mapper, actor = vtkOpenGLPolyDataMapper(), vtkActor()
    mapper.SetInputData(mesh)
    mapper.SetScalarModeToUseCellData()
    mapper.SetVBOShiftScaleMethod(0)  # corners as they are
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    return actor


def window_of(scene, view):
    renderer, window = vtkRenderer(), vtkRenderWindow()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor_of(scene))
    axes, shift = view.camera_from_world[:3, :3], view.camera_from_world[:3, 3]
    eye = (-axes.T @ shift).astype(np.float32)  # an eye is three float32
    camera, projection = renderer.GetActiveCamera(), vtkMatrix4x4()
    camera.SetPosition(eye.tolist())
    camera.SetFocalPoint(eye - axes[2])  # the axes are right, up and back
    camera.SetViewUp(axes[1])
    projection.DeepCopy(view.clip_from_camera.ravel())
    camera.SetExplicitProjectionTransformMatrix(projection)
    camera.UseExplicitProjectionTransformMatrixOn()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(0)
    window.SetSize(view.size)
    window.AddRenderer(renderer)
    window.Render()
    return window


def render(scene, view):
    """Ids, and what the z-buffer holds: 0 at near, 1 at far. Row 0 is at the top, as the judge has it."""
    (width, height), window = view.size, window_of(scene, view)
    colours, z = vtkUnsignedCharArray(), vtkFloatArray()
    window.GetPixelData(0, 0, width - 1, height - 1, 1, colours, 0)
    window.GetZbufferData(0, 0, width - 1, height - 1, z)
    rgb = vtk_to_numpy(colours).reshape(height, width, 3)[::-1].astype(np.uint32)
    ids = rgb @ np.array([1, 1 << 8, 1 << 16], dtype=np.uint32)
    ids[ids == BACKGROUND_COLOUR] = zproof.BACKGROUND_ID
    # the float that is read is a step of the buffer, rounded once more
    z = np.rint(vtk_to_numpy(z).reshape(height, width)[::-1].astype(np.float64) * STEPS) / STEPS
    return ids, z


def camera_depth(view, ids, z):
    """Worked out in float64, rounded once (docs/conventions.md, window_z)."""
    if view.is_perspective:
        depth = view.near / (1 - z * (1 - view.near / view.far))
    else:
        depth = view.near + z * (view.far - view.near)
    return np.where(ids == zproof.BACKGROUND_ID, np.inf, depth).astype(np.float32)


def main():
    is_right = True
    for name in SCENES:
        scene = zproof.load(name, SIZE)
        for view in scene.views.values():
            ids, z = render(scene, view)
            verdict = zproof.judge(scene, view, id=ids, depth=camera_depth(view, ids, z), precision="vtk")
            print(f"{name}, {zproof.summary(verdict)}")
            is_right = is_right and verdict.proven

    print("\nThe same, where the z-buffer is taken for the depth:")
    scene = zproof.load("room", SIZE)
    view = scene.views["door"]
    ids, z = render(scene, view)
    wrong = zproof.judge(scene, view, id=ids, depth=z.astype(np.float32), precision="vtk")
    print(zproof.summary(wrong), wrong.diagnosis, sep="\n")
    return 0 if is_right and "NDC z" in wrong.diagnosis.cause else 1


if __name__ == "__main__":
    if "DISPLAY" not in os.environ:
        os.execvp("xvfb-run", ["xvfb-run", "-a", sys.executable, *sys.argv])
    sys.exit(main())
