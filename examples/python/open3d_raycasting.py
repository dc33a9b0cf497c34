#!/usr/bin/env python3
"""Open3D's RaycastingScene before the judge (docs/python.md). Package python3-open3d.

Rays have length 1, so t_hit is the distance from the eye. docs/conventions.md makes depth of it: s / k.
k is the length of the view ray per unit of camera depth.
"""
import os
import subprocess
import sys
import tempfile

import numpy as np
import open3d

import zproof

SCENES = ["room", "near_plane", "t_junctions", "coplanar"]
SIZE = (320, 180)
MASK = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "gallery", "open3d_mask.c")

# Embree's promise for the rays that Open3D casts. Directions are worked out in float64 and rounded once.
# The depth that is made of t_hit is rounded once more: a second rounding along the ray.
PRECISION = "ray,direction_roundings=2"


def rays_of(view):
    """float32 (height, width, 6), eye and direction of length 1; and k, float64 (height, width)."""
    K, R, t = view.opencv
    height, width = view.shape
    x, y = np.meshgrid(np.arange(width), np.arange(height))
    ahead = np.stack([(x - K[0, 2]) / K[0, 0], (y - K[1, 2]) / K[1, 1], np.ones(view.shape)], axis=-1)
    k = np.linalg.norm(ahead, axis=-1)
    rays = np.empty((height, width, 6), np.float32)
    rays[..., :3] = -R.T @ t
    rays[..., 3:] = ahead / k[..., None] @ R
    return rays, k


def cast(scene, view, rays, k, left_out=()):
    """(ids, depths) of rays in a row. Open3D's rays begin at the eye: triangles that are hit before near
    are left out, and the rays are cast again."""
    kept = np.delete(np.arange(scene.triangle_count, dtype=np.uint32), left_out)
    raycasting = open3d.t.geometry.RaycastingScene()
    raycasting.add_triangles(open3d.core.Tensor(scene.positions), open3d.core.Tensor(scene.triangles[kept]))
    hits = raycasting.cast_rays(open3d.core.Tensor(rays))
    depths = hits["t_hit"].numpy() / k
    ids = np.full(len(rays), zproof.BACKGROUND_ID, np.uint32)
    is_hit = np.isfinite(depths)
    ids[is_hit] = kept[hits["primitive_ids"].numpy()[is_hit]]
    for too_near in np.unique(ids[depths < view.near]):
        again = (ids == too_near) & (depths < view.near)
        ids[again], depths[again] = cast(scene, view, rays[again], k[again], [*left_out, int(too_near)])
    ids[depths > view.far], depths[depths > view.far] = zproof.BACKGROUND_ID, np.inf
    return ids, depths


def judge(scene, view, *, as_length=False):
    rays, k = rays_of(view)
    ids, depths = cast(scene, view, rays.reshape(-1, 6), k.ravel())
    depths = depths.reshape(view.shape) * (k if as_length else 1)
    ids, depths = ids.reshape(view.shape), depths.astype(np.float32)
    return zproof.judge(scene, view, id=ids, depth=depths, precision=PRECISION)


def see_anything():
    """Debian's Open3D casts rays that miss all geometry (docs/gallery.md). A small library mends that:
    begin again with it."""
    raycasting = open3d.t.geometry.RaycastingScene()
    raycasting.add_triangles(open3d.core.Tensor(np.float32([[-1, -1, 1], [1, -1, 1], [0, 1, 1]])),
                             open3d.core.Tensor(np.uint32([[0, 1, 2]])))
    hit = raycasting.cast_rays(open3d.core.Tensor(np.float32([[0, 0, 0, 0, 0, 1]])))["t_hit"].numpy()
    if np.isfinite(hit).all():
        return
    others = os.environ.get("LD_PRELOAD", "")
    if "open3d_mask" in others:
        sys.exit("Open3D's rays miss all geometry, with the library as well")
    with tempfile.TemporaryDirectory() as folder:
        library = os.path.join(folder, "open3d_mask.so")
        subprocess.run(["cc", "-shared", "-fPIC", "-o", library, MASK], check=True)
        mended = {**os.environ, "LD_PRELOAD": f"{others}:{library}".strip(":")}
        done = subprocess.run([sys.executable, *sys.argv], env=mended, check=False)
    sys.exit(done.returncode)


def main():
    see_anything()
    is_right = True
    for name in SCENES:
        scene = zproof.load(name, SIZE)
        for view in scene.views.values():
            verdict = judge(scene, view)
            print(f"{name}, {zproof.summary(verdict)}")
            is_right = is_right and verdict.proven

    print("\nThe same, where t_hit is taken for the depth:")
    scene = zproof.load("room", SIZE)
    wrong = judge(scene, scene.views["door"], as_length=True)
    print(zproof.summary(wrong), wrong.diagnosis, sep="\n")
    return 0 if is_right and "ray's length" in wrong.diagnosis.cause else 1


if __name__ == "__main__":
    sys.exit(main())
