#!/usr/bin/env python3
"""The bugs of docs/found.md that Debian's packages show: each is there still, in the words of that page. Where
one was mended, the page has to say so.

    found_test.py ZPROOF SOURCE embree|swiftshader|softpipe|numbers|anisotropy|sliver|openscenegraph|rapier
"""
import os
import re
import subprocess
import sys
import tempfile

SWIFTSHADER = '/usr/lib/chromium/vk_swiftshader_icd.json'


def printed(command, status, **environment):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          env=os.environ | environment)
    assert done.returncode == status, f'{command} ended with {done.returncode}, not {status}:\n{done.stdout}'
    return done.stdout


def expect(text, pattern):
    assert re.search(pattern, text), f'{pattern!r} is not in:\n{text}'


def embree(zproof, _source, folder):
    expect(printed([zproof, 'run', 'random:surface:37:20185', '--oracle', 'none', '-o', f'{folder}/out'], 0),
           '0 defects, 1 reference defect')
    expect(printed([zproof, 'explain', 'random:surface:37:20185', '13', '12'], 0),
           'reference  background.*not admissible: covered for certain')


def swiftshader(zproof, source, folder):
    scene = f'{source}/examples/found/behind_the_eye.view.json'
    text = printed([zproof, 'run', scene, '--oracle', 'none', '--renderer', 'vulkan', '-o', f'{folder}/out'], 1,
                   VK_ICD_FILENAMES=SWIFTSHADER)
    expect(text, '1 wrong_depth')
    printed([zproof, 'explain', scene, '0', '0', '--renderer', 'vulkan'], 1, VK_ICD_FILENAMES=SWIFTSHADER)
    expect(text, r'depth 1\.2348\d*, admissible from 1\.2499\d* to 1\.3400')


def softpipe(zproof, source, folder):
    scene = f'{source}/examples/found/cut_by_the_image.view.json'
    text = printed([zproof, 'run', scene, '--oracle', 'none', '--renderer', 'opengl', '-o', f'{folder}/out'], 1,
                   GALLIUM_DRIVER='softpipe')
    expect(text, '1 hole')
    expect(text, 'explain .* 0 19 ')


def numbers(_zproof, source, folder):
    program = f'{folder}/ids'
    subprocess.run(['g++', '-DGL_GLEXT_PROTOTYPES', f'{source}/examples/found/softpipe_ids.cpp', '-lEGL', '-lOpenGL',
                    '-o', program], check=True)
    expect(printed([program], 0, GALLIUM_DRIVER='softpipe'), 'of the last of 1366 triangles: 0, right is 1365')
    expect(printed([program], 0, GALLIUM_DRIVER='llvmpipe'), 'of the last of 1366 triangles: 1365, right is 1365')


def anisotropy(zproof, _source, folder):
    out = f'{folder}/out'
    printed([zproof, 'filters', 'run', 'worked', '--view', 'phi-0', '--flicker', '0', '-q', '-o', out, '--methods',
             'opengl-aniso:max-anisotropy=2,opengl-aniso:max-anisotropy=16'], 0)
    two, sixteen = (open(f'{out}/pictures/worked-phi-0/opengl-aniso_max-anisotropy_{limit}.exr', 'rb').read()
                    for limit in (2, 16))
    assert two == sixteen, 'llvmpipe heeds the limit of anisotropy'


def sliver(zproof, _source, _folder):
    expect(printed([zproof, 'explain', 'million_triangles', '217', '124', '--view', 'grazing', '--width', '480',
                    '--height', '270', '--sample', 'standard:4:0', '--renderer', 'vulkan', '--device', 'llvmpipe'], 0),
           r'candidate  triangle 163216, depth 121\.517')


def openscenegraph(_zproof, source, folder):
    program = f'{folder}/osg_double'
    subprocess.run(['g++', f'{source}/examples/found/osg_double.cpp', '-losgUtil', '-losg', '-lOpenThreads', '-o',
                    program], check=True)
    expect(printed([program], 1), 'counter-clockwise: hit, clockwise: miss')


def rapier(_zproof, source, folder):
    subprocess.run(['npm', 'install', '--prefix', folder, '@dimforge/rapier3d-compat@0.21.0'], check=True)
    expect(printed(['node', f'{source}/examples/found/rapier_faces.cjs'], 0, NODE_PATH=f'{folder}/node_modules'),
           'triangle 1, front: 0, back: 1')


def main():
    zproof, source, bug = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        globals()[bug](zproof, source, folder)


main()
