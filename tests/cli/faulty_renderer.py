#!/usr/bin/env python3
"""The example renderer with one fault: faulty_renderer.py FAULT SCENE CAMERA OUT."""
import math
import os
import struct
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'examples'))
import zbuffer  # noqa: E402
import zproof_contract as contract  # noqa: E402 (zbuffer names its folder)

NO_ID = contract.BACKGROUND


def flipped_in_y(frame, camera):
    for plane in (frame.id, frame.depth):
        rows = [plane[y * frame.width:(y + 1) * frame.width] for y in range(frame.height)]
        for y, row in enumerate(reversed(rows)):
            plane[y * frame.width:(y + 1) * frame.width] = row


def ids_from_one(frame, camera):
    for i, one in enumerate(frame.id):
        if one != NO_ID:
            frame.id[i] = one + 1


def depth_is_ndc_z(frame, camera):
    row_z, row_w = camera.clip_from_camera[2], camera.clip_from_camera[3]
    for i, depth in enumerate(frame.depth):
        if depth < math.inf:
            frame.depth[i] = (row_z[2] * -depth + row_z[3]) / (row_w[2] * -depth + row_w[3])


def depth_is_ray_length(frame, camera):
    window = camera.window
    for i, depth in enumerate(frame.depth):
        x, y = i % frame.width + 0.5, i // frame.width + 0.5
        u = window['left'] + (window['right'] - window['left']) * x / frame.width
        v = window['top'] - (window['top'] - window['bottom']) * y / frame.height
        if camera.perspective and depth < math.inf:
            frame.depth[i] = depth * math.sqrt(1 + u * u + v * v)


def one_nan(frame, camera):
    frame.depth[5 * frame.width + 3] = math.nan


def nothing_behind_the_eye(camera):
    camera.near = max(camera.near, 0)


WRONG_FRAMES = {f.__name__: f for f in (flipped_in_y, ids_from_one, depth_is_ndc_z, depth_is_ray_length, one_nan)}


# --- contract errors: what comes is no frame ---------------------------------------------------------------

def exits_with_status_7(out, camera):
    print('no licence for a picture of this size', file=sys.stderr)
    sys.exit(7)


def crashes(out, camera):
    os.abort()


def never_ends(out, camera):
    while True:
        time.sleep(1)


def writes_nothing(out, camera):
    pass


def writes_no_exr(out, camera):
    with open(out, 'w') as file:
        file.write('P6 1 1 255\n')


def writes_half_a_file(out, camera):
    contract.write_exr(out, contract.Frame(camera.width, camera.height))
    os.truncate(out, os.path.getsize(out) // 2)


def another_size(out, camera):
    contract.write_exr(out, contract.Frame(camera.width + 1, camera.height))


def written_with(replacements, out, camera):
    """A background frame in whose file some bytes are others."""
    contract.write_exr(out, contract.Frame(camera.width, camera.height))
    with open(out, 'rb') as file:
        content = file.read()
    for old, new in replacements:
        assert old in content and len(old) == len(new)
        content = content.replace(old, new, 1)
    with open(out, 'wb') as file:
        file.write(content)


def ids_are_float(out, camera):
    written_with([(b'id\0' + struct.pack('<i', 0), b'id\0' + struct.pack('<i', 2))], out, camera)


def depths_are_uint(out, camera):
    written_with([(b'Z\0' + struct.pack('<i', 2), b'Z\0' + struct.pack('<i', 0))], out, camera)


def no_id_channel(out, camera):
    written_with([(b'id\0' + struct.pack('<i', 0), b'ix\0' + struct.pack('<i', 0))], out, camera)


def no_depth_channel(out, camera):
    written_with([(b'Z\0' + struct.pack('<i', 2), b'Y\0' + struct.pack('<i', 2))], out, camera)


NO_FRAMES = {f.__name__: f for f in (exits_with_status_7, crashes, never_ends, writes_nothing, writes_no_exr,
                                     writes_half_a_file, another_size, ids_are_float, depths_are_uint,
                                     no_id_channel, no_depth_channel)}


def main():
    fault, scene, camera_file, out = sys.argv[1:]
    camera = contract.Camera(camera_file)
    if fault in NO_FRAMES:
        NO_FRAMES[fault](out, camera)
        return
    if fault == 'nothing_behind_the_eye':
        nothing_behind_the_eye(camera)
    frame = zbuffer.render(contract.read_triangles(scene), camera)
    if fault in WRONG_FRAMES:
        WRONG_FRAMES[fault](frame, camera)
    contract.write_exr(out, frame)


if __name__ == '__main__':
    main()
