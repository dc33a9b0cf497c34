#!/usr/bin/env python3
"""A depth camera by OpenCV's conventions: its depth map alone before the judge, without ids (docs/python.md).

p_camera = R p_world + t; x is right, y down, z ahead. K maps to an image in which the first pixel's centre is
(0, 0). A principal point of (width / 2, height / 2) is the classic mistake: it is half a pixel off.
"""
import sys

import numpy as np

import zproof

SIZE = (160, 120)
K = np.array([[131.3, 0, 79.5], [0, 131.1, 59.5], [0, 0, 1]])  # the principal point is the picture's middle

# A z-buffer in float64: corners by two matrices and not snapped, edges and weights from a corner, and one
# rounding to float32. Edges are worked out for each triangle by itself, so that a gap may lie between two.
PRECISION = {"kind": "raster", "transform": "float64", "matrices": 2, "snap": "none",
             "edge_functions": "from_corner", "edge_arithmetic": "float64", "watertight": False,
             "interpolation": "float64", "depth_roundings": 1}


def turned(axis, degrees):
    """A rotation about a coordinate axis."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    R = np.eye(3)
    a, b = (axis + 1) % 3, (axis + 2) % 3
    R[a, a], R[a, b], R[b, a], R[b, b] = c, -s, s, c
    return R


def box(centre, size):
    ends = (-0.5, 0.5)
    corners = np.array([[x, y, z] for x in ends for y in ends for z in ends]) * size + centre
    quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    return corners, [[q[i] for i in side] for q in quads for side in ((0, 1, 2), (0, 2, 3))]


def tabletop():
    """A table and five boxes on it, in metres, y up."""
    positions, triangles = [], []
    boxes = [((0, -0.02, 0), (1.2, 0.04, 0.8))]
    for i in range(5):
        boxes.append(((0.2 * i - 0.4, 0.05 + 0.02 * i, 0.12 * (-1) ** i), (0.13, 0.1 + 0.04 * i, 0.11)))
    for centre, size in boxes:
        corners, sides = box(np.array(centre), np.array(size))
        triangles += [[8 * len(positions) + i for i in side] for side in sides]
        positions.append(corners)
    positions = np.concatenate(positions).astype(np.float32)
    return zproof.Scene(positions, np.array(triangles, np.uint32), name="tabletop")


def poses():
    """(name, R, t) of cameras that look at the table from above: y of the world is up, of the camera down."""
    for name, around, down, away in [("front", 0, 35, 1.1), ("left", 55, 30, 1.2), ("back", 160, 60, 1.0)]:
        yield name, turned(0, down) @ np.diag([1.0, -1, -1]) @ turned(1, around), np.array([0.01, 0.02, away])


def depth_map(scene, view, K, R, t):
    """Camera depth through every pixel's centre, +inf where nothing is seen. Nothing is clipped."""
    p_camera = scene.positions.astype(np.float64) @ R.T + t
    z = p_camera[:, 2]
    if not ((z > view.near) & (z < view.far)).all():
        raise ValueError("a corner does not lie between near and far")
    image = p_camera[:, :2] / z[:, None] * [K[0, 0], K[1, 1]] + [K[0, 2], K[1, 2]]
    height, width = view.shape
    nearest = np.zeros(view.shape)  # 1 / depth
    for triangle in scene.triangles:
        p, inverse = image[triangle], 1 / z[triangle]
        box_px = np.clip([p.min(axis=0), p.max(axis=0) + 1], 0, (width - 1, height - 1))
        (x0, y0), (x1, y1) = box_px.astype(int)
        x, y = np.meshgrid(np.arange(x0, x1 + 1), np.arange(y0, y1 + 1))

        def edge(a, b):
            return (x - a[0]) * (b[1] - a[1]) - (y - a[1]) * (b[0] - a[0])

        weights = np.array([edge(p[1], p[2]), edge(p[2], p[0]), edge(p[0], p[1])])
        area = weights.sum(axis=0)
        is_inside = ((weights >= 0).all(axis=0) | (weights <= 0).all(axis=0)) & (area != 0)
        seen = np.where(is_inside, np.tensordot(inverse, weights, 1) / np.where(is_inside, area, 1), 0)
        part = nearest[y0:y1 + 1, x0:x1 + 1]
        np.maximum(part, seen, out=part)
    with np.errstate(divide="ignore"):
        return (1 / nearest).astype(np.float32)


def main():
    scene, is_right = tabletop(), True
    for name, R, t in poses():
        view = zproof.View.from_opencv(K, R, t, SIZE, 0.1, 10.0, name)
        exact = view.opencv  # the eye is rounded to float32: this is the camera that is judged
        verdict = zproof.judge(scene, view, depth=depth_map(scene, view, *exact), precision=PRECISION)
        print(zproof.summary(verdict))
        is_right = is_right and verdict.proven

    print("\nThe same with the principal point at (width / 2, height / 2):")
    wrong_K = exact[0] + [[0, 0, 0.5], [0, 0, 0.5], [0, 0, 0]]
    wrong = zproof.judge(scene, view, depth=depth_map(scene, view, wrong_K, *exact[1:]), precision=PRECISION)
    print(zproof.summary(wrong), wrong.diagnosis, sep="\n")
    return 0 if is_right and "shifted by (+1/2, +1/2)" in wrong.diagnosis.cause else 1


if __name__ == "__main__":
    sys.exit(main())
