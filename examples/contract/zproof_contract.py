"""zproof's renderer contract for Python (docs/renderer-contract.md): read scene and camera, make rays, write the frame.

    import zproof_contract as contract

    def render(triangles, camera):
        frame = contract.Frame(camera.width, camera.height)
        ...                                   # frame.set(x, y, triangle, depth)
        return frame

    contract.main(render)      # python3 mine.py {scene} {camera} {width} {height} {out}

It needs nothing but Python. NumPy works where it is used: `Camera.ray` takes arrays of pixels, and `Frame.id` and
`Frame.depth` may be arrays of uint32 and float32.
"""
import json
import math
import struct
import sys
from array import array

BACKGROUND = 0xFFFFFFFF  # the id of a pixel that sees no triangle; its depth is infinity


# --- the scene: binary glTF, one mesh in world space -------------------------------------------------------

def read_triangles(path):
    """The corners ((x, y, z), (x, y, z), (x, y, z)) of every triangle; the index in this list is the id."""
    with open(path, 'rb') as file:
        content = file.read()
    json_size, = struct.unpack_from('<I', content, 12)
    document, binary = json.loads(content[20:20 + json_size]), memoryview(content)[28 + json_size:]
    triangles = []
    for mesh in document.get('meshes', []):  # a scene without triangles has no mesh
        for primitive in mesh['primitives']:
            points = list(_elements(document, binary, primitive['attributes']['POSITION']))
            corners = [points[i] for i, in _elements(document, binary, primitive['indices'])]
            triangles += [tuple(corners[i:i + 3]) for i in range(0, len(corners), 3)]
    return triangles


def _elements(document, binary, index):
    """One tuple for each element of an accessor of float32 or uint32."""
    accessor = document['accessors'][index]
    view = document['bufferViews'][accessor['bufferView']]
    count = {'SCALAR': 1, 'VEC3': 3}[accessor['type']]
    layout = struct.Struct('<%d%s' % (count, {5126: 'f', 5125: 'I'}[accessor['componentType']]))
    start = view.get('byteOffset', 0) + accessor.get('byteOffset', 0)
    stride = view.get('byteStride', layout.size)
    for i in range(accessor['count']):
        yield layout.unpack_from(binary, start + i * stride)


# --- the camera --------------------------------------------------------------------------------------------

class Camera:
    """The camera file. Its matrices are lists of rows, for column vectors; all of it stands in `document`."""

    def __init__(self, path):
        with open(path) as file:
            self.document = view = json.load(file)
        self.width, self.height = view['width'], view['height']
        self.perspective = view['projection'] == 'perspective'
        self.eye, self.right, self.up, self.back = (view[key] for key in ('eye', 'right', 'up', 'back'))
        self.window = view['exact_window']
        self.shear = view.get('shear', [0, 0])
        self.near = view['near']
        self.far = math.inf if view['far'] == 'infinity' else view['far']
        self.camera_from_world = view['camera_from_world']
        self.clip_from_camera = view['clip_from_camera']
        self.raster_from_ndc = view['raster_from_ndc']
        self.sample_px = view['sample_px']

    def ray(self, x, y):
        """(origin, direction) in world space through the centre of pixel (x, y), or its sample, not normalized:
        origin + t * direction has the camera depth t. A hit counts from t = near to t = far."""
        left, right, bottom, top = (self.window[key] for key in ('left', 'right', 'bottom', 'top'))
        u = left + (right - left) * (x + 0.5 + self.sample_px[0]) / self.width
        v = top - (top - bottom) * (y + 0.5 + self.sample_px[1]) / self.height
        if self.perspective:
            return tuple(self.eye), self._sum((u, v, -1), (0, 0, 0))
        return self._sum((u, v, 0), self.eye), self._sum((*self.shear, -1), (0, 0, 0))

    def _sum(self, weights, start):
        r, u, b = weights
        return tuple(s + r * x + u * y + b * z for s, x, y, z in zip(start, self.right, self.up, self.back))


# --- the answer: OpenEXR, scan lines, not compressed -------------------------------------------------------

class Frame:
    """Ids, camera depths and, where asked for, attributes; row by row from the top, all background at first."""

    def __init__(self, width, height):
        self.width, self.height = width, height
        self.id = array('I', [BACKGROUND]) * (width * height)
        self.depth = array('f', [math.inf]) * (width * height)
        self.attributes = {}

    def set(self, x, y, triangle, depth):
        self.id[y * self.width + x], self.depth[y * self.width + x] = triangle, depth

    def attribute(self, name):
        """The values of a channel such as 'bary.u' (docs/renderer-contract.md, "Attributes"), to be filled in."""
        return self.attributes.setdefault(name, array('f', [0]) * (self.width * self.height))


def write_exr(path, frame):
    """Channels in alphabetical order, as the format has it: Z (float32), id (uint32), attributes (float32)."""
    planes = {'Z': _plane(frame, 'depth', frame.depth, 'f', 'float32'),
              'id': _plane(frame, 'id', frame.id, 'I', 'uint32')}
    for name, values in frame.attributes.items():
        planes[name] = _plane(frame, name, values, 'f', 'float32')
    planes = sorted(planes.items())
    window = struct.pack('<4i', 0, 0, frame.width - 1, frame.height - 1)
    channels = b''.join(name.encode() + b'\0' + struct.pack('<iBxxxii', 0 if name == 'id' else 2, 0, 1, 1)
                        for name, _ in planes) + b'\0'
    header = struct.pack('<ii', 20000630, 2) + b''.join(
        name.encode() + b'\0' + kind.encode() + b'\0' + struct.pack('<i', len(value)) + value
        for name, kind, value in (
            ('channels', 'chlist', channels), ('compression', 'compression', b'\0'), ('dataWindow', 'box2i', window),
            ('displayWindow', 'box2i', window), ('lineOrder', 'lineOrder', b'\0'),
            ('pixelAspectRatio', 'float', struct.pack('<f', 1)),
            ('screenWindowCenter', 'v2f', struct.pack('<2f', 0, 0)),
            ('screenWindowWidth', 'float', struct.pack('<f', 1)))) + b'\0'
    row, first_line = 4 * frame.width, len(header) + 8 * frame.height
    line = len(planes) * row
    with open(path, 'wb') as file:
        file.write(header)
        for y in range(frame.height):
            file.write(struct.pack('<Q', first_line + y * (8 + line)))
        for y in range(frame.height):
            file.write(struct.pack('<ii', y, line))
            for _, plane in planes:
                file.write(plane[y * row:(y + 1) * row])


def _plane(frame, name, values, kind, words):
    """The bytes of one of the frame's arrays. What has another type is refused: converted ids would be others."""
    view = memoryview(values)
    if view.format != kind or view.nbytes != 4 * frame.width * frame.height:
        raise TypeError(f'frame.{name}: {view.nbytes} bytes of type {view.format!r}; expected '
                        f'{frame.width} x {frame.height} values of type {words}')
    return view.cast('B')


# --- the program -------------------------------------------------------------------------------------------

def main(render):
    """Reads the files that the command line names, calls render(triangles, camera), and writes its frame."""
    if len(sys.argv) not in (4, 6):  # the camera file tells the size, too
        sys.exit(f'usage: {sys.argv[0]} SCENE.glb CAMERA.json [WIDTH HEIGHT] OUT.exr')
    scene, camera, out = sys.argv[1], sys.argv[2], sys.argv[-1]
    write_exr(out, render(read_triangles(scene), Camera(camera)))
