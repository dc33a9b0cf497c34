#!/usr/bin/env python3
"""A z-buffer in plain Python: the smallest renderer that zproof can judge (docs/renderer-contract.md).

    zproof contract-check 'python3 examples/zbuffer.py {scene} {camera} {width} {height} {out}' \\
        --precision raster,transform=float64,interpolation=float64,depth_roundings=1

Corners are transformed in float64 and snapped to 1/256 pixel. Coverage is decided in integers, which Python
never lets overflow, by the top-left rule. Depth is interpolated in float64 and rounded once to float32.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), 'contract'))
from zproof_contract import Frame, main  # noqa: E402

GRID = 256  # sub-pixel positions per pixel


# --- from world to raster ----------------------------------------------------------------------------------

def transformed(rows, p):
    return tuple(r[0] * p[0] + r[1] * p[1] + r[2] * p[2] + r[3] for r in rows)


def on_grid(camera, p_camera):
    """(x, y) on the grid of 1/256 pixel, and what is affine in the image: 1/depth, or depth itself."""
    x, y, _, w = transformed(camera.clip_from_camera, p_camera)
    x_raster, y_raster = (transformed([row], (x / w, y / w, 0.0))[0] for row in camera.raster_from_ndc)
    depth = -p_camera[2]
    x, y = (round(p * GRID) - round(offset * GRID)  # as if the sample were the pixel's centre
            for p, offset in zip((x_raster, y_raster), camera.sample_px))
    return x, y, 1.0 / depth if camera.perspective else depth


def clipped(polygon, inside):
    """The part of a convex polygon where inside(p) >= 0 (Sutherland and Hodgman 1974)."""
    kept = []
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        side_a, side_b = inside(a), inside(b)
        if side_a >= 0:
            kept.append(a)
        if (side_a >= 0) != (side_b >= 0):
            t = side_a / (side_a - side_b)
            kept.append(tuple(p + t * (q - p) for p, q in zip(a, b)))
    return kept


# --- from raster to pixels ---------------------------------------------------------------------------------

def edge(a, b):
    """e(x, y) = A x + B y + C in integers, positive on the inside; on the line itself only top and left edges
    (of a triangle that runs clockwise as seen, y down) let a pixel in."""
    A, B = a[1] - b[1], b[0] - a[0]
    owns_its_line = A > 0 or (A == 0 and B > 0)
    return A, B, -(A * a[0] + B * a[1]), 0 if owns_its_line else 1


def pixels_between(low, high, size):
    """Pixels whose centres lie between two grid coordinates, kept inside the image."""
    first = -((GRID // 2 - low) // GRID)
    last = (high - GRID // 2) // GRID
    return range(max(first, 0), min(last, size - 1) + 1)


def draw(frame, corners, primitive, depth_of):
    a, b, c = corners
    area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    if area == 0:
        return
    if area < 0:
        b, c, area = c, b, -area
    edges = [edge(b, c), edge(c, a), edge(a, b)]
    for y in pixels_between(min(a[1], b[1], c[1]), max(a[1], b[1], c[1]), frame.height):
        y_grid = y * GRID + GRID // 2
        row = [(A, B * y_grid + C, least) for A, B, C, least in edges]
        for x in pixels_between(min(a[0], b[0], c[0]), max(a[0], b[0], c[0]), frame.width):
            x_grid = x * GRID + GRID // 2
            e = [A * x_grid + rest for A, rest, _ in row]
            if any(value < least for value, (_, _, least) in zip(e, row)):
                continue
            depth = depth_of((e[0] * a[2] + e[1] * b[2] + e[2] * c[2]) / area)
            i = y * frame.width + x
            if depth < frame.depth[i]:
                frame.depth[i], frame.id[i] = depth, primitive


def render(triangles, camera):
    frame = Frame(camera.width, camera.height)
    depth_of = (lambda inverse_depth: 1.0 / inverse_depth) if camera.perspective else (lambda depth: depth)
    for primitive, corners_world in enumerate(triangles):
        polygon = [transformed(camera.camera_from_world[:3], p) for p in corners_world]
        polygon = clipped(polygon, lambda p: -p[2] - camera.near)
        polygon = clipped(polygon, lambda p: camera.far + p[2])
        corners = [on_grid(camera, p) for p in polygon]
        for i in range(1, len(corners) - 1):
            draw(frame, (corners[0], corners[i], corners[i + 1]), primitive, depth_of)
    return frame


if __name__ == '__main__':
    main(render)
