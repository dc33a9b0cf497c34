#!/usr/bin/env python3
"""Every worked example of the helps, README.md and docs/cli.md, run as it stands on small pictures.

    help_test.py ZPROOF SOURCE_FOLDER RAYCASTER quick|long

What an example speaks of (a model, a renderer, shards, waivers) is made before, most of it by zproof itself. An
example that says nothing of the picture's size gets a small one.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

# What takes minutes; `quick` leaves it to `long`.
LONG = re.compile(r'zproof (selftest|filters check all|filters run worked'
                  r'|filters run checker_plane --view phi-45 --truth B -o)')
# `zproof run` hears of a size by the environment; these are told. A picture of one's own has a size.
SIZE = {'ZPROOF_WIDTH': '48', 'ZPROOF_HEIGHT': '32'}
SIZED = re.compile(r'zproof (render|filters run|filters check|filters crow|filters normals|study \w+)\b(?!.*--picture)')
TODAY = '2026-11-21'  # a day on which the waivers of the examples hold

# --- the examples ------------------------------------------------------------------------------------------


def helps(zproof, *command):
    """The help of a command and of those below it."""
    text = subprocess.run([zproof, *command, '--help'], check=True, stdout=subprocess.PIPE, text=True).stdout
    yield ' '.join(command), text
    below = re.search(r'^Subcommands:\n((?:  .*\n)+)', text, re.MULTILINE)
    for name in re.findall(r'^  ([a-z]\S*)', below.group(1), re.MULTILINE) if below else ():
        yield from helps(zproof, *command, name)


def in_helps(zproof):
    for command, text in helps(zproof):
        found = [re.split(r'  +', line.strip())[0] for line in text.splitlines() if line.startswith('  zproof ')]
        if not found:
            sys.exit(f'help_test: zproof {command} --help has no example')
        yield from found


def in_markdown(file):
    """Not what a synopsis has: words in capitals and brackets, and what a command is for behind it."""
    for line in file.read_text().splitlines():
        found = re.match(r'    (?:build/release/)?(zproof .*)', line)
        example = found.group(1).split('  #')[0].strip() if found else ''
        if example and not re.search(r'\[|\w\|\w|   |\b[A-Z]{3,}\b', example):
            yield example


# --- what they speak of ------------------------------------------------------------------------------------


class Place:
    """A folder in which zproof, and nothing else, is on PATH before what is there anyway."""

    def __init__(self, folder, zproof):
        self.folder, self.zproof = folder, zproof
        (folder / 'bin').mkdir()
        (folder / 'bin/zproof').symlink_to(zproof)
        self.environment = dict(os.environ, **SIZE, ZPROOF_NOW=TODAY, PATH=f'{folder}/bin:{os.environ["PATH"]}')

    def made(self, line, status=0, **environment):
        """What the line wrote on stderr."""
        ran = subprocess.run(['sh', '-c', line], cwd=self.folder, env=self.environment | environment, text=True,
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        if ran.returncode != status:
            sys.exit(f'help_test: to furnish the examples: status {ran.returncode}: {line}\n{ran.stdout}{ran.stderr}')
        return ran.stderr

    def script(self, name, line):
        (self.folder / name).parent.mkdir(exist_ok=True)
        (self.folder / name).write_text(f'#!/bin/sh\nexec {line}\n')
        (self.folder / name).chmod(0o755)


def furnish_models(place):
    place.made('zproof scenes generate textured_ground guard_band near_plane room -o made')
    (place.folder / 'models').mkdir()
    for name in 'guard_band', 'near_plane':
        shutil.copy(place.folder / f'made/{name}.glb', place.folder / 'models')
    shutil.copy(place.folder / 'made/textured_ground.glb', place.folder / 'model.glb')
    shutil.copytree(place.folder / 'models', place.folder / 'path/to/models')
    shutil.copy(place.folder / 'model.glb', place.folder / 'path/to')


def furnish_frames(place):
    """Stored frames of the model's first view, whose name is returned."""
    told = place.made("zproof explain model.glb 0 0 --view '?'", status=2)
    view = re.search(r'has the views ([^,;\n]*)', told).group(1).strip()
    place.made('zproof render model.glb -o stored')
    for name in 'frame.exr', 'a.exr', 'b.exr':
        shutil.copy(place.folder / f'stored/{view}.exr', place.folder / name)
    place.made('zproof render room -o sampled --sample standard:4')
    for sample in range(4):
        shutil.copy(place.folder / f'sampled/door.sample-{sample}.exr', place.folder / f'frame-{sample}.exr')
    return view


# The scene's first view at SIZE, as PyTorch3D's rasterizer would give it: int64 with -1, float32 with -1.
ARRAYS = '''
import numpy, OpenImageIO as oiio
image = oiio.ImageInput.open("frame.exr")
spec = image.spec()
channel = lambda name, kind: image.read_image(0, 0, spec.channelnames.index(name), spec.channelnames.index(name) + 1, kind)
ids = channel("id", "uint")[..., 0].astype(numpy.int64)
ids[ids == 0xFFFFFFFF] = -1
depths = channel("Z", "float")[..., 0].astype(numpy.float32)
depths[ids == -1] = -1
numpy.save("id.npy", ids)
numpy.save("z.npy", depths)
'''


def furnish_arrays(place):
    place.made(f"/usr/bin/python3 -c '{ARRAYS}'")


def furnish_cameras(place):
    """One camera, as three programs write it."""
    (place.folder / 'sparse/0').mkdir(parents=True)
    (place.folder / 'sparse/0/cameras.txt').write_text('1 PINHOLE 64 48 50 50 32 24\n')
    (place.folder / 'sparse/0/images.txt').write_text('1 1 0 0 0 0 0 2 1 a.png\n\n')
    pose = '[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 4], [0, 0, 0, 1]]'
    (place.folder / 'transforms.json').write_text(
        f'{{"camera_angle_x": 0.69, "frames": [{{"file_path": "r_0", "transform_matrix": {pose}}}]}}')
    (place.folder / 'cameras.json').write_text(
        '{"views": [{"name": "a", "width": 64, "height": 48, "pixel_centre": "integer", '
        '"K": [[60, 0, 32], [0, 60, 24], [0, 0, 1]], "R": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "t": [0, 0, 2]}]}')


def furnish_results(place):
    """Shards of one run; runs before and after a defect was mended; studies; a picture of a filter."""
    for shard in 1, 2:
        place.made(f'zproof run guard_band room --oracle none --shard hash:{shard}/2 -o shard-{shard}')
    place.made('zproof plan models --of 2 -o plan.json')
    for shard in 1, 2:
        place.made(f'zproof run --plan plan.json --shard {shard} --exit-zero -o shards/{shard}')
    (place.folder / 'runs').mkdir()
    place.made('zproof run guard_band --oracle none --precision ray,arithmetic=float64 -o runs/main/zproof-out', status=1)
    place.made('zproof run guard_band --oracle none -o runs/mine/zproof-out')
    for name, side in ('old', 'main'), ('new', 'mine'):
        place.made(f'zproof report runs/{side}/zproof-out -o runs/{name}.json')
    place.made('zproof study depth -o zproof-study')
    place.made('zproof filters run worked --view phi-0 --methods nearest,ewa-true --width 64 --height 64 -o study')
    place.made('zproof filters run worked --view phi-0 --methods trilinear-gl -o pictured')
    shutil.copy(place.folder / 'pictured/pictures/worked-phi-0/trilinear-gl.exr', place.folder / 'mine.exr')


def furnish_gate(place):
    """A run whose every depth breaks its promise, in a picture that has the example's pixel; waivers that it needs."""
    (place.folder / 'gate').mkdir()
    place.made('cd gate && zproof run room --oracle none --precision ray,arithmetic=float64', status=1,
               ZPROOF_WIDTH='820', ZPROOF_HEIGHT='348')
    place.made('cd gate && zproof waive add --waivers waivers.toml --from zproof-out --scene room --view floor '
               '--pixel 0,0 --reason "of the other view" --link https://example.org/11 --expires 2026-12-01')
    shutil.copy(place.folder / 'gate/waivers.toml', place.folder)
    (place.folder / 'zproof.toml').write_text('[profiles.ci]\ntime-limit = 60\n')


def folder_of(line):
    """Below the place: where this example finds a renderer or results that others find otherwise."""
    if '--precision ray' in line:
        return 'caster'
    if line.startswith('zproof diff-results'):
        return 'runs'
    return 'gate' if line.startswith('zproof waive') else '.'


# --- the test ----------------------------------------------------------------------------------------------

def sized(line):
    if not SIZED.match(line):
        return line
    words = f' --width {SIZE["ZPROOF_WIDTH"]} --height {SIZE["ZPROOF_HEIGHT"]}'
    return line.replace(' > ', words + ' > ') if ' > ' in line else line + words


def fails(line, view, place):
    typed = sized(line.replace('--view cam', f'--view {view}'))
    began = time.monotonic()
    ran = subprocess.run(['sh', '-c', typed], cwd=place.folder / folder_of(line), env=place.environment, text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    print(f'{time.monotonic() - began:5.1f} s  {typed}', flush=True)
    if ran.returncode != 0:
        print(f'status {ran.returncode}\n{ran.stdout[-1500:]}', flush=True)
    return ran.returncode != 0


def main():
    zproof, source, raycaster = (Path(word).resolve() for word in sys.argv[1:4])
    lines = dict.fromkeys([*in_helps(zproof), *in_markdown(source / 'README.md'), *in_markdown(source / 'docs/cli.md')])
    chosen = [line for line in lines if bool(LONG.match(line)) == (sys.argv[4] == 'long')]
    with tempfile.TemporaryDirectory() as folder:
        place = Place(Path(folder), zproof)
        place.script('mine', f'python3 {source}/examples/zbuffer.py "$1" "$2" "$5"')
        place.script('caster/mine', f'{raycaster} "$1" "$2" "$5"')
        furnish_models(place)
        view = furnish_frames(place)
        furnish_arrays(place)
        furnish_cameras(place)
        furnish_results(place)
        furnish_gate(place)
        failed = sum([fails(line, view, place) for line in chosen])
        sys.exit(f'help_test: {failed} of {len(chosen)} examples failed' if failed else 0)


if __name__ == '__main__':
    main()
