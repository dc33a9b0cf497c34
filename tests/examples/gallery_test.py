#!/usr/bin/env python3
"""The gallery's adapters (docs/gallery.md): as declared, no pixel of theirs is a defect. `./dev test --full`
installs the renderers.

    gallery_test.py ZPROOF SOURCE open3d|vtk|blender
"""
import os
import subprocess
import sys
import tempfile

PYTHON = '/usr/bin/python3'  # Debian's own, which has Debian's packages


def open3d_command(source, folder):
    command = f'{PYTHON} {source}/examples/gallery/open3d_render.py {{scene}} {{camera}} {{out}}'
    version = subprocess.run([PYTHON, '-c', 'import open3d; print(open3d.__version__)'], check=True,
                             stdout=subprocess.PIPE, text=True).stdout
    if not version.startswith('0.16.'):
        return command
    mask = os.path.join(folder, 'open3d_mask.so')
    subprocess.run(['cc', '-shared', '-fPIC', '-o', mask, os.path.join(source, 'examples/gallery/open3d_mask.c')],
                   check=True)
    return f'LD_PRELOAD={mask} {command}'


def vtk_command(source, _):
    return f'xvfb-run -a {PYTHON} {source}/examples/gallery/vtk_render.py {{scene}} {{camera}} {{out}}'


def blender_command(source, _):
    return f'{PYTHON} {source}/examples/gallery/blender_render.py {{scene}} {{camera}} {{out}}'


RENDERERS = {
    'open3d': ('open3d', open3d_command),
    'vtk': ('vtk', vtk_command),
    'blender': ('cycles', blender_command),
}


def main():
    zproof, source, name = sys.argv[1:]
    precision, command = RENDERERS[name]
    with tempfile.TemporaryDirectory() as folder:
        return subprocess.run([zproof, 'run', 'near_plane', '--width', '96', '--height', '54', '--oracle', 'none',
                               '--precision', precision, '--renderer', command(source, folder), '--report', 'json',
                               '-o', os.path.join(folder, 'out')]).returncode


sys.exit(main())
