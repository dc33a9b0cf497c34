#!/usr/bin/env python3
"""The gallery's adapters (docs/gallery.md): as declared, no pixel of theirs is a defect. `./dev test --full`
installs the renderers.

    gallery_test.py ZPROOF SOURCE open3d|vtk|blender|bullet|cgal|ode|mesh_bvh
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


def compiled(source, folder, name, *words):
    program = os.path.join(folder, name)
    subprocess.run(['g++', '-O2', '-std=c++17', '-I', f'{source}/examples/contract',
                    f'{source}/examples/gallery/{name}.cpp', '-o', program, *words], check=True)
    return f'{program} {{scene}} {{camera}} {{out}}'


def bullet_command(source, folder):
    return compiled(source, folder, 'bullet_render', '-I', '/usr/include/bullet', '-lBulletCollision', '-lLinearMath')


def cgal_command(source, folder):
    return compiled(source, folder, 'cgal_render', '-frounding-math', '-lgmp', '-lmpfr')


def ode_command(source, folder):
    return compiled(source, folder, 'ode_render', '-lode')


def mesh_bvh_command(source, folder):
    subprocess.run(['npm', 'install', '--prefix', folder, 'three@0.187', 'three-mesh-bvh@0.9'], check=True)
    return (f'MODULES={folder} {PYTHON} {source}/examples/gallery/mesh_bvh_render.py {{scene}} {{camera}} {{out}}')


RENDERERS = {
    'open3d': ('open3d', open3d_command),
    'vtk': ('vtk', vtk_command),
    'blender': ('cycles', blender_command),
    'bullet': ('ray,barycentric_tolerance=1e-4,depth_of_range=3e-7', bullet_command),
    'cgal': ('ray,arithmetic=float64', cgal_command),
    'ode': ('ray,test=moeller_trumbore', ode_command),
    'mesh_bvh': ('ray,arithmetic=float64', mesh_bvh_command),
}


def main():
    zproof, source, name = sys.argv[1:]
    precision, command = RENDERERS[name]
    with tempfile.TemporaryDirectory() as folder:
        return subprocess.run([zproof, 'run', 'near_plane', '--width', '96', '--height', '54', '--oracle', 'none',
                               '--precision', precision, '--renderer', command(source, folder), '--report', 'json',
                               '-o', os.path.join(folder, 'out')]).returncode


sys.exit(main())
