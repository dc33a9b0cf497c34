#!/usr/bin/env python3
"""A ray caster in numpy before the judge, and the same with its rays half a pixel off (docs/python.md).

Moeller and Trumbore 1997. All rays start at the eye, so that each of its triple products is a ray's
direction times a vector of the triangle's: a product of two matrices, rays by triangles.
"""
import sys

import numpy as np

import zproof

RAYS_AT_A_TIME = 256  # rays times triangles are held in memory
SCENES = ["room", "near_plane", "t_junctions", "coplanar"]
SIZE = (64, 36)

# One ray for each pixel's centre, each triangle by itself: triangles that share an edge may leave a gap.
# float32: directions are worked out in float64 and rounded once. float64: they have less than 16 roundings.
PROMISES = {
    np.float32: {"kind": "ray", "test": "moeller_trumbore", "arithmetic": "float32", "watertight": False},
    np.float64: {"kind": "ray", "test": "moeller_trumbore", "arithmetic": "float64", "watertight": False,
                 "direction_roundings": 16},
}


def rays(view, offset_px=0.0):
    """The eye, and a direction for each pixel, row by row. Its part along the view axis is 1: a hit at
    parameter t has the camera depth t."""
    K, R, t = view.opencv
    height, width = view.shape
    x, y = np.meshgrid(np.arange(width) + offset_px, np.arange(height))  # the first pixel's centre is (0, 0)
    ahead = np.stack([(x - K[0, 2]) / K[0, 0], (y - K[1, 2]) / K[1, 1], np.ones_like(x)], axis=-1)
    eye = (-R.T @ t).astype(np.float32)  # an eye is three float32
    return eye, ahead.reshape(-1, 3) @ R


def cast(scene, view, dtype, offset_px=0.0):
    """(ids, depths) of the nearest triangles between near and far."""
    eye, directions = rays(view, offset_px)
    directions, corners = directions.astype(dtype), scene.positions.astype(dtype)[scene.triangles]
    edge1, edge2 = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    from_corner = eye.astype(dtype) - corners[:, 0]
    q = np.cross(from_corner, edge1)
    of_det, of_u, of_v = np.cross(edge2, edge1), np.cross(edge2, from_corner), q
    t_times_det = (edge2 * q).sum(axis=1)

    ids = np.full(len(directions), zproof.BACKGROUND_ID, np.uint32)
    depths = np.full(len(directions), np.inf, np.float32)
    with np.errstate(divide="ignore", invalid="ignore"):  # det is 0 where a ray runs along a triangle
        for first in range(0, len(directions), RAYS_AT_A_TIME):
            block = slice(first, first + RAYS_AT_A_TIME)
            det = directions[block] @ of_det.T
            u, v = directions[block] @ of_u.T / det, directions[block] @ of_v.T / det
            t = t_times_det / det
            t[~((u >= 0) & (v >= 0) & (u + v <= 1) & (t >= view.near) & (t <= view.far))] = np.inf
            nearest = t.argmin(axis=1)
            depths[block] = t[np.arange(len(t)), nearest]
            ids[block] = np.where(np.isfinite(depths[block]), nearest, zproof.BACKGROUND_ID)
    return ids.reshape(view.shape), depths.reshape(view.shape)


def judge(scene, view, dtype, offset_px=0.0):
    ids, depths = cast(scene, view, dtype, offset_px)
    return zproof.judge(scene, view, id=ids, depth=depths, precision=PROMISES[dtype])


def main():
    is_right = True
    for name in SCENES:
        scene = zproof.load(name, SIZE)
        for view in scene.views.values():
            for dtype in PROMISES:
                verdict = judge(scene, view, dtype)
                print(f"{name}, {dtype.__name__}: {zproof.summary(verdict)}")
                is_right = is_right and verdict.proven

    print("\nThe same with its rays half a pixel to the right:")
    scene = zproof.load("room", SIZE)
    wrong = judge(scene, scene.views["door"], np.float64, offset_px=0.5)
    print(zproof.summary(wrong), wrong.diagnosis, "", zproof.story_of_worst(wrong), sep="\n")
    is_found = not wrong.proven and "shifted" in wrong.diagnosis.cause
    return 0 if is_right and is_found else 1


if __name__ == "__main__":
    sys.exit(main())
