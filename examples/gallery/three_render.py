#!/usr/bin/env python3
"""three.js in a headless Chromium before the judge (docs/gallery.md). THREE names the folder of three.module.js, and
ANGLE the driver: gl-egl (Mesa) or swiftshader.

    THREE=node_modules/three/build zproof run room --precision webgl \\
        --renderer 'python3 examples/gallery/three_render.py {scene} {camera} {out}'
"""
import base64
import json
import os
import re
import subprocess
import sys
import tempfile

import numpy as np

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(here, '..', 'contract'))
import zproof_contract as contract  # noqa: E402
from opengl_projection import projection  # noqa: E402

PAGE = '''<!DOCTYPE html><body><script type="module">
import {render} from './three_render.js';
const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
try {
    const frame = render(%s, new Float32Array(bytes('%s').buffer));
    let text = '';
    for (const byte of new Uint8Array(frame.buffer)) text += String.fromCharCode(byte);
    document.body.dataset.frame = btoa(text);
} catch (error) { document.body.dataset.trouble = String(error); }
</script></body>'''


def page_of(triangles, camera):
    view = {'width': camera.width, 'height': camera.height,
            'cameraFromWorld': np.transpose(camera.camera_from_world).ravel().tolist(),
            'clipFromCamera': projection(camera).T.ravel().tolist()}
    corners = np.array(triangles, dtype='<f4').tobytes()
    return PAGE % (json.dumps(view), base64.b64encode(corners).decode())


def dom_of(page):
    """What the page has made of itself."""
    with tempfile.TemporaryDirectory() as folder:
        for name in ('three.module.js', 'three.core.js'):
            os.symlink(os.path.abspath(os.path.join(os.environ['THREE'], name)), os.path.join(folder, name))
        os.symlink(os.path.join(here, 'three_render.js'), os.path.join(folder, 'three_render.js'))
        with open(os.path.join(folder, 'page.html'), 'w') as file:
            file.write(page)
        return subprocess.run(
            ['chromium', '--headless', '--no-sandbox', '--use-gl=angle', '--enable-unsafe-swiftshader',
             '--use-angle=' + os.environ.get('ANGLE', 'swiftshader'), '--ignore-gpu-blocklist',
             '--allow-file-access-from-files', '--user-data-dir=' + os.path.join(folder, 'profile'), '--dump-dom',
             'file://' + os.path.join(folder, 'page.html')], capture_output=True, text=True, check=True).stdout


def render(triangles, camera):
    dom = dom_of(page_of(triangles, camera))
    found = re.search('data-frame="([^"]*)"', dom)
    if not found:
        sys.exit('three.js drew nothing: ' + ''.join(re.findall('data-trouble="([^"]*)"', dom)))
    depth, low, high, drawn = np.frombuffer(base64.b64decode(found[1]), dtype='<f4').reshape(
        camera.height, camera.width, 4)[::-1].transpose(2, 0, 1)
    ids = low.astype(np.uint32) | high.astype(np.uint32) << 16
    frame = contract.Frame(camera.width, camera.height)
    frame.id = np.where(drawn > 0, ids, np.uint32(contract.BACKGROUND)).astype(np.uint32)
    frame.depth = np.where(drawn > 0, depth, np.float32(np.inf)).astype(np.float32)
    return frame


contract.main(render)
