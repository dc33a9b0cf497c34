#!/usr/bin/env python3
"""A z-buffer in plain Python: the smallest renderer that zproof can judge (docs/renderer-contract.md).

    zproof contract-check 'python3 examples/zbuffer.py {scene} {camera} {out}' \\
        --precision raster,transform=float64,interpolation=float64,depth_roundings=1

Corners are transformed in float64 and snapped to 1/256 pixel. Coverage is decided in integers, which Python
never lets overflow, by the top-left rule. Depth is interpolated in float64 and rounded once to float32.
"""
import json
import math
import struct
import sys
from array import array

GRID = 256  # sub-pixel positions per pixel
BACKGROUND = 0xFFFFFFFF


# --- the scene: binary glTF, one mesh in world space, triangle i is id i -----------------------------------

def read_glb(path):
    """Returns the JSON document and the binary chunk."""
    with open(path, 'rb') as file:
        content = file.read()
    json_size, = struct.unpack_from('<I', content, 12)
    return json.loads(content[20:20 + json_size]), memoryview(content)[20 + json_size + 8:]


def read_accessor(document, binary, index):
    """Yields one tuple per element; float32 or uint32 components."""
    accessor = document['accessors'][index]
    view = document['bufferViews'][accessor['bufferView']]
    count = {'SCALAR': 1, 'VEC3': 3}[accessor['type']]
    layout = struct.Struct('<%d%s' % (count, {5126: 'f', 5125: 'I'}[accessor['componentType']]))
    start = view.get('byteOffset', 0) + accessor.get('byteOffset', 0)
    stride = view.get('byteStride', layout.size)
    for i in range(accessor['count']):
        yield layout.unpack_from(binary, start + i * stride)


def read_triangles(path):
    """World-space corners of every triangle, in the order of their ids."""
    document, binary = read_glb(path)
    triangles = []
    for primitive in document['meshes'][0]['primitives']:
        points = list(read_accessor(document, binary, primitive['attributes']['POSITION']))
        corners = [points[i] for i, in read_accessor(document, binary, primitive['indices'])]
        triangles += [corners[i:i + 3] for i in range(0, len(corners), 3)]
    return triangles


# --- from world to raster ----------------------------------------------------------------------------------

def transformed(rows, p):
    return tuple(r[0] * p[0] + r[1] * p[1] + r[2] * p[2] + r[3] for r in rows)


class Camera:
    """The camera file, as far as this renderer needs it."""

    def __init__(self, path):
        with open(path) as file:
            view = json.load(file)
        self.width, self.height = view['width'], view['height']
        self.camera_from_world = view['camera_from_world'][:3]
        self.clip_from_camera = view['clip_from_camera']
        self.raster_from_ndc = view['raster_from_ndc']
        self.near = view['near']
        self.far = math.inf if view['far'] == 'infinity' else view['far']
        self.perspective = view['projection'] == 'perspective'

    def raster(self, p_camera):
        """(x, y) on the grid of 1/256 pixel, and what is affine in the image: 1/depth, or depth itself."""
        x, y, _, w = transformed(self.clip_from_camera, p_camera)
        x_raster, y_raster = (transformed([row], (x / w, y / w, 0.0))[0] for row in self.raster_from_ndc)
        depth = -p_camera[2]
        return round(x_raster * GRID), round(y_raster * GRID), 1.0 / depth if self.perspective else depth


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

class Frame:
    def __init__(self, width, height):
        self.width, self.height = width, height
        self.id = array('I', [BACKGROUND]) * (width * height)
        self.depth = array('f', [math.inf]) * (width * height)


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
        polygon = [transformed(camera.camera_from_world, p) for p in corners_world]
        polygon = clipped(polygon, lambda p: -p[2] - camera.near)
        polygon = clipped(polygon, lambda p: camera.far + p[2])
        corners = [camera.raster(p) for p in polygon]
        for i in range(1, len(corners) - 1):
            draw(frame, (corners[0], corners[i], corners[i + 1]), primitive, depth_of)
    return frame


# --- the answer: OpenEXR, scan lines, not compressed -------------------------------------------------------

def attribute(name, kind, value):
    return name.encode() + b'\0' + kind.encode() + b'\0' + struct.pack('<i', len(value)) + value


def write_exr(path, frame):
    """Channels in alphabetical order, as the format has it: Z (float32), id (uint32)."""
    uint32, float32 = 0, 2

    def channel(name, kind):
        return name.encode() + b'\0' + struct.pack('<iBxxxii', kind, 0, 1, 1)

    window = struct.pack('<4i', 0, 0, frame.width - 1, frame.height - 1)
    header = struct.pack('<ii', 20000630, 2) + b''.join([
        attribute('channels', 'chlist', channel('Z', float32) + channel('id', uint32) + b'\0'),
        attribute('compression', 'compression', b'\0'),
        attribute('dataWindow', 'box2i', window),
        attribute('displayWindow', 'box2i', window),
        attribute('lineOrder', 'lineOrder', b'\0'),
        attribute('pixelAspectRatio', 'float', struct.pack('<f', 1)),
        attribute('screenWindowCenter', 'v2f', struct.pack('<2f', 0, 0)),
        attribute('screenWindowWidth', 'float', struct.pack('<f', 1))]) + b'\0'
    line_size = 8 * frame.width
    first_line = len(header) + 8 * frame.height
    with open(path, 'wb') as file:
        file.write(header)
        for y in range(frame.height):
            file.write(struct.pack('<Q', first_line + y * (8 + line_size)))
        for y in range(frame.height):
            line = slice(y * frame.width, (y + 1) * frame.width)
            file.write(struct.pack('<ii', y, line_size))
            file.write(frame.depth[line].tobytes() + frame.id[line].tobytes())


def main():
    if len(sys.argv) != 4:
        sys.exit('usage: zbuffer.py SCENE.glb CAMERA.json OUT.exr')
    scene, camera, out = sys.argv[1:]
    write_exr(out, render(read_triangles(scene), Camera(camera)))


if __name__ == '__main__':
    main()
