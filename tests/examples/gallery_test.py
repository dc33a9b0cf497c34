#!/usr/bin/env python3
"""The gallery's adapters (docs/gallery.md): as declared, no pixel of theirs is a defect. The row of that page's table is
renewed. `./dev test --full` installs the renderers.

    gallery_test.py ZPROOF SOURCE NAME     one of RENDERERS
"""
import dataclasses
import fcntl
import json
import os
import re
import subprocess
import sys
import tempfile
import typing

PYTHON = '/usr/bin/python3'  # Debian's own, which has Debian's packages
SCENES = ['room', 't_junctions', 'near_plane', 'shared_edges', 'orthographic']


def output_of(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def python(source, script, before=''):
    return f'{before}{PYTHON} {source}/examples/gallery/{script} {{scene}} {{camera}} {{out}}'


def open3d(source, folder):
    if not output_of(PYTHON, '-c', 'import open3d; print(open3d.__version__)').startswith('0.16.'):
        return python(source, 'open3d_render.py')
    mask = os.path.join(folder, 'open3d_mask.so')
    subprocess.run(['cc', '-shared', '-fPIC', '-o', mask, os.path.join(source, 'examples/gallery/open3d_mask.c')],
                   check=True)
    return python(source, 'open3d_render.py', f'LD_PRELOAD={mask} ')


def vtk(source, _):
    return python(source, 'vtk_render.py', 'xvfb-run -a ')


def script(name):
    return lambda source, _: python(source, name)


def compiled(name, *words):
    def command(source, folder):
        program = os.path.join(folder, name)
        subprocess.run(['g++', '-O2', '-std=c++17', '-I', f'{source}/examples/contract',
                        f'{source}/examples/gallery/{name}.cpp', '-o', program, *words], check=True)
        return f'{program} {{scene}} {{camera}} {{out}}'
    return command


def node(caster, *packages):
    def command(source, folder):
        subprocess.run(['npm', 'install', '--prefix', folder, *packages], check=True, stdout=sys.stderr)
        return python(source, f'node_rays.py {caster}', f'MODULES={folder} ')
    return command


def three(angle):
    def command(source, folder):
        subprocess.run(['npm', 'install', '--prefix', folder, 'three@0.187'], check=True, stdout=sys.stderr)
        return python(source, 'three_render.py', f'THREE={folder}/node_modules/three/build ANGLE={angle} ')
    return command


@dataclasses.dataclass
class Trial:
    title: str    # of the row
    package: str  # of Debian, or of npm: 'npm NAME'
    precision: str
    command: typing.Callable
    scenes: list = dataclasses.field(default_factory=lambda: SCENES)
    size: tuple = (320, 180)
    section: str = ''  # of the page, where it is not the title


FEW = {'scenes': ['near_plane', 'shared_edges'], 'size': (160, 90)}  # of what asks every triangle
RENDERERS = {
    'open3d': Trial('Open3D', 'python3-open3d', 'open3d', open3d),
    'vtk': Trial('VTK', 'python3-vtk9', 'vtk', vtk),
    'three_llvmpipe': Trial('three.js on llvmpipe', 'npm three', 'webgl', three('gl-egl'), section='three.js'),
    'three_swiftshader': Trial('three.js on SwiftShader', 'npm three', 'webgl,subpixel_bits=4', three('swiftshader'),
                               scenes=['room'], section='three.js'),
    'blender': Trial('Blender Cycles', 'blender', 'cycles', script('blender_render.py'), size=(160, 90)),
    'bvhtree': Trial("Blender's BVHTree", 'blender', 'ray,test=woop,direction_roundings=2',
                     script('bvhtree_render.py')),
    'bullet': Trial('Bullet', 'libbullet-dev', 'ray,barycentric_tolerance=1e-4,depth_of_range=3e-7',
                    compiled('bullet_render', '-I', '/usr/include/bullet', '-lBulletCollision', '-lLinearMath')),
    'cgal': Trial('CGAL', 'libcgal-dev', 'ray,arithmetic=float64',
                  compiled('cgal_render', '-frounding-math', '-lgmp', '-lmpfr')),
    'ode': Trial('ODE', 'libode-dev', 'ray,test=moeller_trumbore', compiled('ode_render', '-lode')),
    'coin': Trial('Coin', 'libcoin-dev', 'ray,test=moeller_trumbore,world_absolute=1.8e-4,least_determinant=1e-15',
                  compiled('coin_render', '-lCoin'), **FEW),
    'openscenegraph': Trial('OpenSceneGraph', 'libopenscenegraph-dev',
                            'ray,test=moeller_trumbore,least_determinant=1e-9',
                            compiled('osg_render', '-losgUtil', '-losg', '-lOpenThreads'), **FEW),
    'vtk_locator': Trial("VTK's cell locator", 'python3-vtk9', 'plane_ray', script('vtk_locator.py'),
                         scenes=['room', 't_junctions', 'near_plane', 'orthographic']),
    'mesh_bvh': Trial('three-mesh-bvh', 'npm three-mesh-bvh', 'ray,arithmetic=float64',
                      node('mesh_bvh.mjs', 'three@0.187', 'three-mesh-bvh@0.9')),
    'three_pick': Trial("three.js's Raycaster", 'npm three', 'ray,arithmetic=float64,test=woop,direction_roundings=3',
                        node('three_pick.mjs', 'three@0.187'), **FEW),
    'babylon_pick': Trial("Babylon.js's picking", 'npm @babylonjs/core',
                          'ray,arithmetic=float64,test=moeller_trumbore,barycentric_tolerance=1e-3,'
                          'direction_roundings=3', node('babylon_pick.mjs', '@babylonjs/core@9'), **FEW),
    'rapier': Trial('Rapier', 'npm @dimforge/rapier3d-compat', 'ray,test=moeller_trumbore',
                    node('rapier_rays.mjs', '@dimforge/rapier3d-compat@0.20')),
    'jolt': Trial('Jolt', 'npm jolt-physics',
                  'ray,test=moeller_trumbore,world_absolute=5.7e-5,least_determinant=1e-12',
                  node('jolt_rays.mjs', 'jolt-physics@1.1'), scenes=['room', 'orthographic']),
}


def version(package, folder):
    if package.startswith('npm '):
        with open(os.path.join(folder, 'node_modules', package[4:], 'package.json')) as file:
            return json.load(file)['version']
    found = output_of('dpkg-query', '-W', '-f', '${Version}', package)
    return re.match(r'(?:\d+:)?([0-9.]*[0-9])', found).group(1)


def spaced(number):
    return f'{number:,}'.replace(',', ' ')


def row_of(trial, results, fit, folder):
    views = results['views']
    pixels = sum(view['width'] * view['height'] for view in views)
    largest = max(view['candidate_depth']['max_error_over_bound'] for view in views)
    anchor = re.sub(r'[^a-z0-9 -]', '', (trial.section or trial.title).lower()).replace(' ', '-')
    where = '' if trial.scenes == SCENES else ', '.join(f'`{scene}`' for scene in trial.scenes) + ': '
    size = '' if trial.size == (320, 180) else f' of {trial.size[0]} x {trial.size[1]}'
    promise, rest = fit['promise'], '' if fit['explains_all'] else ', but for some pixels'
    return (f'| [{trial.title}](#{anchor}) {version(trial.package, folder)} | `{trial.precision}` '
            f'| {where}{len(views)} views{size} proven, {spaced(pixels)} pixels, 0 defects '
            f'| {largest:.3f} | {promise["eps_px"]:.2g} px, {promise["depth_relative"]:.2g}{rest} |')


def renew(source, title, row):
    """Other trials may be writing the page, too."""
    with open(os.path.join(source, 'docs/gallery.md'), 'r+') as page:
        fcntl.flock(page, fcntl.LOCK_EX)
        text = page.read()
        new, count = re.subn(rf'^\| \[{re.escape(title)}\]\(.*\n', lambda _: row + '\n', text, flags=re.MULTILINE)
        assert count == 1, f'docs/gallery.md: {count} rows begin with [{title}]; expected 1'
        if new != text:
            print(f'docs/gallery.md, renewed: {row}')
            page.seek(0)
            page.write(new)
            page.truncate()


def main():
    zproof, source, name = sys.argv[1:]
    trial = RENDERERS[name]
    with tempfile.TemporaryDirectory() as folder:
        ways = ['--width', str(trial.size[0]), '--height', str(trial.size[1]), '--renderer',
                trial.command(source, folder)]
        judged, fitted = (os.path.join(folder, part) for part in ('judged', 'fitted'))
        status = subprocess.run([zproof, 'run', *trial.scenes, *ways, '--oracle', 'none', '--precision',
                                 trial.precision, '--report', 'json', '-o', judged]).returncode
        if status != 0:
            return status
        subprocess.run([zproof, 'fit', *trial.scenes, *ways, '-q', '-o', fitted], stdout=subprocess.DEVNULL)
        with open(f'{judged}/results.json') as results, open(f'{fitted}/fit.json') as fit:
            renew(source, trial.title, row_of(trial, json.load(results), json.load(fit), folder))
    return 0


sys.exit(main())
