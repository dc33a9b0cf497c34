#!/usr/bin/env python3
"""Casters of Node before the judge (docs/gallery.md); their packages are looked for in MODULES, a folder with node_modules.

    npm install three three-mesh-bvh
    MODULES=. zproof run room --precision ray,arithmetic=float64 \
        --renderer 'python3 examples/gallery/node_rays.py mesh_bvh.mjs {scene} {camera} {out}'
"""
import os
import subprocess
import sys
import tempfile

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, '..', 'contract'))
import zproof_contract as contract  # noqa: E402
from reach import end_of_rays  # noqa: E402

CASTER = os.path.join(HERE, sys.argv.pop(1))


def cast(corners, rays, reach):
    """(triangle, factor of the direction) of each ray, -1 where it meets none."""
    with tempfile.TemporaryDirectory() as folder:
        files = [os.path.join(folder, name) for name in ('corners', 'rays', 'hits')]
        corners.tofile(files[0])
        rays.tofile(files[1])
        subprocess.run(['node', CASTER, *files, repr(float(reach))], check=True, cwd=os.environ.get('MODULES', '.'),
                       stdout=sys.stderr)
        hits = np.fromfile(files[2]).reshape(-1, 2)
    return hits[:, 0].astype(np.int64), hits[:, 1]


def render(triangles, camera):
    frame = contract.Frame(camera.width, camera.height)
    corners = np.array(triangles, dtype=np.float32).reshape(-1, 3)
    end = end_of_rays(corners, camera)
    if not end > camera.near:
        return frame
    x, y = (a.ravel() for a in np.meshgrid(np.arange(camera.width), np.arange(camera.height)))
    origin, direction = (np.stack([np.broadcast_to(axis, x.shape) for axis in part], axis=1).astype(np.float64)
                         for part in camera.ray(x, y))
    rays = np.concatenate([origin + camera.near * direction, direction], axis=1)
    triangle, factor = cast(corners, rays, end - camera.near)
    depth = camera.near + factor
    is_hit = (triangle >= 0) & (depth <= camera.far)
    frame.id = np.where(is_hit, triangle, contract.BACKGROUND).astype(np.uint32)
    frame.depth = np.where(is_hit, depth, np.inf).astype(np.float32)
    return frame


contract.main(render)
