#!/usr/bin/env python3
"""Open3D's RaycastingScene before the judge (docs/gallery.md).

    zproof run room --renderer 'python3 examples/gallery/open3d_render.py {scene} {camera} {out}' --precision open3d
"""
import os
import sys

import numpy as np
import open3d

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'contract'))
import zproof_contract as contract  # noqa: E402


def cast(corners, left_out, rays, near):
    """(triangle, depth) of each ray. Open3D's rays begin at their origin: what they hit before near is left out,
    and they are cast again."""
    kept = np.delete(np.arange(len(corners), dtype=np.uint32), left_out)
    scene = open3d.t.geometry.RaycastingScene()
    scene.add_triangles(open3d.core.Tensor(corners[kept].reshape(-1, 3)),
                        open3d.core.Tensor(np.arange(3 * len(kept), dtype=np.uint32).reshape(-1, 3)))
    hits = scene.cast_rays(open3d.core.Tensor(rays))
    depth, index = hits['t_hit'].numpy(), hits['primitive_ids'].numpy()
    triangle = np.full(len(rays), contract.BACKGROUND, dtype=np.uint32)
    is_hit = np.isfinite(depth)
    triangle[is_hit] = kept[index[is_hit]]
    for too_near in np.unique(triangle[depth < near]):
        again = (triangle == too_near) & (depth < near)
        triangle[again], depth[again] = cast(corners, left_out + [too_near], rays[again], near)
    return triangle, depth


def render(triangles, camera):
    x, y = (a.ravel() for a in np.meshgrid(np.arange(camera.width), np.arange(camera.height)))
    rays = np.stack([np.broadcast_to(axis, x.shape) for part in camera.ray(x, y) for axis in part], axis=1)
    corners = np.array(triangles, dtype=np.float32).reshape(-1, 3, 3)
    triangle, depth = cast(corners, [], rays.astype(np.float32), camera.near)
    triangle[depth > camera.far] = contract.BACKGROUND
    depth[triangle == contract.BACKGROUND] = np.inf
    frame = contract.Frame(camera.width, camera.height)
    frame.id, frame.depth = triangle, depth
    return frame


contract.main(render)
