"""Scenes and frames of the tests. All frames are of our own ray caster, and may be written to."""

import numpy as np

import zproof

WIDTH, HEIGHT = 64, 48
PRECISION = "embree"


def layers():
    """Two squares, one behind the other: triangles 0 and 1 in front, 2 and 3 hidden by them. The rest is background."""
    square = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], np.float32)
    front = np.column_stack([square, np.zeros(4, np.float32)])
    behind = np.column_stack([0.9 * square, np.full(4, -1)]).astype(np.float32)
    corners = np.array([[0, 1, 2], [0, 2, 3]], np.uint32)
    return zproof.Scene(np.concatenate([front, behind]), np.concatenate([corners, corners + 4]), name="layers")


def view(width=WIDTH, height=HEIGHT, name="view"):
    """Straight on: the front square is 1.2 of 3 units away from the image's border, and the eye is 3 before it."""
    return zproof.View.perspective(eye=(0.1, 0.05, 3), target=(0.1, 0.05, 0), yfov=1, near=0.1,
                                   size=(width, height), name=name)


def traced(scene, seen_from):
    """(ids, depths): right answers, as arrays of one's own."""
    frame = zproof.trace(scene, seen_from)
    return frame.id.copy(), frame.depth.copy()


def random_mesh(seed, triangles=40):
    """(positions, triangles): before the eye of view(), of all sizes."""
    drawn = np.random.default_rng(seed)
    centres = drawn.uniform([-1.5, -1.2, -2], [1.5, 1.2, 1], (triangles, 1, 3))
    corners = centres + drawn.uniform(-0.5, 0.5, (triangles, 3, 3))
    return corners.reshape(-1, 3).astype(np.float32), np.arange(3 * triangles, dtype=np.uint32).reshape(-1, 3)
