#!/usr/bin/env python3
"""Every worked example of the help, the manual page and README.md, run as it stands on small pictures.

    help_test.py ZPROOF SOURCE_FOLDER quick|long
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

# What takes minutes; `quick` leaves it to `long`.
LONG = re.compile(r'zproof (selftest|filters check all|filters run worked|filters run checker_plane --view phi-45 --truth B -o)')
# Sizes for those that would draw 1920 x 1080; an explained pixel must lie within the picture.
SMALL = '--width 48 --height 32'
SIZED = re.compile(r'zproof (run|render|filters run|filters check|filters crow)\b')


def in_manual(zproof):
    roff = subprocess.run([zproof, 'man'], check=True, stdout=subprocess.PIPE, text=True).stdout
    for line in roff.replace('\\-', '-').replace('\\e', '\\').splitlines():
        if line.startswith('  zproof '):
            yield re.split(r'  +', line.strip())[0]


def in_markdown(file):
    """Not what a synopsis has: words in capitals and brackets, and what a command is for behind it."""
    for line in file.read_text().splitlines():
        found = re.match(r'    (?:build/release/)?(zproof .*)', line)
        example = found.group(1).split('  #')[0].strip() if found else ''
        if example and not re.search(r'\[|\w\|\w|   |\b[A-Z]{3,}\b', example):
            yield example


def furnish(place, zproof, source):
    def made(*words):
        subprocess.run([zproof, *words], check=True, cwd=place, stdout=subprocess.DEVNULL)

    wrapper = place / 'bin/zproof'
    wrapper.parent.mkdir()
    wrapper.write_text(f'#!/bin/sh\nexec {zproof} "$@"\n')
    (place / 'mine').write_text(f'#!/bin/sh\nexec python3 {source}/examples/zbuffer.py "$1" "$2" "$5"\n')
    for program in wrapper, place / 'mine':
        program.chmod(0o755)
    made('scenes', 'generate', 'textured_ground', 'guard_band', '-o', 'made')
    (place / 'models').mkdir()
    shutil.copy(place / 'made/guard_band.glb', place / 'models')
    shutil.copy(place / 'made/textured_ground.glb', place / 'model.glb')
    (place / 'path/to').mkdir(parents=True)
    shutil.copy(place / 'model.glb', place / 'path/to')
    shutil.copytree(place / 'models', place / 'path/to/models')


def view_of_model(place, zproof):
    """The name of the model's first view, as --view of a wrong name tells it."""
    told = subprocess.run([zproof, 'explain', 'model.glb', '0', '0', '--view', '?'], cwd=place, text=True,
                          stderr=subprocess.PIPE).stderr
    return re.search(r'has the views ([^,;\n]*)', told).group(1).strip()


def frames(place, zproof, view):
    """Stored frames that the examples name, of the model's first view."""
    subprocess.run([zproof, 'render', 'model.glb', '-o', 'stored'], check=True, cwd=place, stdout=subprocess.DEVNULL)
    for name in 'frame.exr', 'a.exr', 'b.exr':
        shutil.copy(place / f'stored/{view}.exr', place / name)
    subprocess.run([zproof, 'render', 'model.glb', '--filter', 'trilinear-gl', '-o', 'other'], check=True, cwd=place,
                   stdout=subprocess.DEVNULL)


def main():
    zproof, source, how = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2]).resolve(), sys.argv[3]
    lines = dict.fromkeys([*in_manual(zproof), *in_markdown(source / 'README.md'), *in_markdown(source / 'docs/cli.md')])
    if len(lines) < 30:
        sys.exit(f'help_test: only {len(lines)} examples were found')
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        furnish(place, zproof, source)
        view = view_of_model(place, zproof)
        frames(place, zproof, view)
        subprocess.run([zproof, 'filters', 'run', 'worked', '--view', 'phi-0', '--methods', 'nearest,ewa-true', '--width',
                        '64', '--height', '64', '-o', 'study'], check=True, cwd=place, stdout=subprocess.DEVNULL)
        environment = dict(os.environ, PATH=f'{place}/bin:{os.environ["PATH"]}')
        failed = 0
        for line in lines:
            if bool(LONG.match(line)) != (how == 'long'):
                continue
            typed = line.replace('--view cam', f'--view {view}')
            if SIZED.match(typed) and '--picture' not in typed:
                typed = typed.replace(' > ', f' {SMALL} > ') if ' > ' in typed else f'{typed} {SMALL}'
            print(typed, flush=True)
            ran = subprocess.run(['sh', '-c', typed], cwd=place, env=environment, text=True, stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT)
            if ran.returncode != 0:
                print(f'status {ran.returncode}: {typed}\n{ran.stdout[-1500:]}', flush=True)
                failed += 1
        sys.exit(f'help_test: {failed} of {len(lines)} examples failed' if failed else 0)


if __name__ == '__main__':
    main()
