#!/usr/bin/env python3
"""The CI files of examples/ci: their shape, and every zproof command in them, run on small scenes.

    ci_test.py ZPROOF SOURCE_FOLDER
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import yaml

TODAY = '2026-11-21'  # a day on which the waiver of the example holds


def require(is_right, what):
    if not is_right:
        sys.exit('ci_test: ' + what)


def require_keys(table, needed, allowed, place):
    require(isinstance(table, dict), f'{place}: a mapping is expected')
    for key in needed:
        require(key in table, f'{place}: {key} is missing')
    for key in table:
        require(key in needed or key in allowed, f'{place}: {key} is no key that is known there')


# --- shape -------------------------------------------------------------------------------------------------

def github_scripts(file):
    """The shell scripts of the workflow in the order of its jobs; once per cell of a matrix."""
    workflow = yaml.safe_load(file.read_text())
    workflow['on'] = workflow.pop(True, workflow.get('on'))  # YAML 1.1 reads "on" as true
    require_keys(workflow, ['name', 'on', 'jobs'], ['env', 'permissions'], file.name)
    require('pull_request' in workflow['on'], 'it does not run on pull requests')
    scripts, uses = [], set()
    for name, job in workflow['jobs'].items():
        require_keys(job, ['runs-on', 'steps'],
                     ['needs', 'container', 'timeout-minutes', 'strategy', 'outputs', 'if'], name)
        needs = job.get('needs', [])
        for needed in [needs] if isinstance(needs, str) else needs:
            require(needed in workflow['jobs'], f'{name} needs {needed}, which is no job')
        cells = job.get('strategy', {}).get('matrix', {}).get('shard', [None])
        for cell in cells:
            for step in job['steps']:
                require_keys(step, [], ['id', 'name', 'run', 'uses', 'with', 'if'], f'a step of {name}')
                require(('run' in step) != ('uses' in step), f'{name}: a step is either run or uses')
                if 'uses' in step:
                    require(re.fullmatch(r'actions/[a-z-]+@v\d+', step['uses']), step['uses'])
                    uses.add(step['uses'].split('@')[0])
                else:
                    scripts.append(step['run'].replace('${{ matrix.shard }}', str(cell))
                                   .replace('${{ needs.plan.outputs.today }}', TODAY))
    require({'actions/upload-artifact', 'actions/download-artifact'} <= uses, 'nothing is handed on')
    return scripts, workflow['env']


def gitlab_scripts(file):
    """The same of GitLab's file; once per parallel job."""
    pipeline = yaml.safe_load(file.read_text())
    scripts = []
    for name, job in pipeline.items():
        if name in ('stages', 'variables') or name.startswith('.'):
            continue
        require_keys(job, ['stage', 'script', 'artifacts'], ['extends', 'parallel', 'timeout', 'when'], name)
        require(job['stage'] in pipeline['stages'], f'{name}: no stage {job["stage"]}')
        require_keys(job['artifacts'], ['paths', 'when'], ['expire_in', 'expose_as', 'reports'], name)
        total = job.get('parallel', 1)
        for index in range(1, total + 1):
            scripts += [f'CI_NODE_INDEX={index} CI_NODE_TOTAL={total}\n' + line for line in job['script']]
    require(pipeline['zproof:verdict']['artifacts']['reports']['junit'] == 'zproof-out/junit.xml', 'no JUnit')
    return scripts, pipeline['variables']


# --- every zproof command ----------------------------------------------------------------------------------

def furnish(place, zproof, source):
    """A project with two small models, a renderer and waivers; zproof is small on PATH."""
    wrapper = place / 'bin/zproof'
    wrapper.parent.mkdir()
    wrapper.write_text(f'#!/bin/sh\nif [ "$1" = run ]; then set -- "$@" --width 48 --height 32 --oracle none; fi\n'
                       f'echo "$1" >> {place}/called\nexec {zproof} "$@"\n')
    (place / 'mine').write_text(f'#!/bin/sh\nexec python3 {source}/examples/zbuffer.py "$1" "$2" "$5"\n')
    for program in wrapper, place / 'mine':
        program.chmod(0o755)
    subprocess.run([zproof, 'scenes', 'generate', 'guard_band', 'fan_at_pixel_centre', '-o', place / 'made'],
                   check=True, stdout=subprocess.DEVNULL)
    (place / 'models').mkdir()
    for model in (place / 'made').glob('*.glb'):
        shutil.copy(model, place / 'models')
    shutil.copy(source / 'examples/ci/waivers.toml', place)


def run_all(scripts, variables, zproof, source):
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        furnish(place, zproof, source)
        environment = dict(os.environ, PATH=f'{place}/bin:{os.environ["PATH"]}', **variables,
                           CI_PIPELINE_CREATED_AT=TODAY + 'T12:00:00Z', GITHUB_STEP_SUMMARY=str(place / 'summary'))
        contract_checks = 0
        for script in scripts:
            contract_checks += 'contract-check' in script
            if 'zproof ' not in script or 'apt-get' in script or ('contract-check' in script and contract_checks > 1):
                continue  # the same conversation on every machine
            ran = subprocess.run(['sh', '-e', '-c', script], cwd=place, env=environment, text=True,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            require(ran.returncode == 0, f'status {ran.returncode}:\n{script}\n{ran.stdout}')
        called = (place / 'called').read_text().split()
        require(called.count('run') == 2 and called.count('merge') == 1, f'called were {called}')
        for name in 'report.html', 'results.json', 'junit.xml':
            require((place / 'zproof-out' / name).stat().st_size > 0, f'{name} is empty')


def main():
    zproof, source = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2]).resolve()
    for file, scripts_of in (('github.yml', github_scripts), ('gitlab-ci.yml', gitlab_scripts)):
        scripts, variables = scripts_of(source / 'examples/ci' / file)
        run_all(scripts, variables, zproof, source)


if __name__ == '__main__':
    main()
