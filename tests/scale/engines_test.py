#!/usr/bin/env python3
"""The files of examples/ for GNU parallel, Snakemake, Kubernetes and GitHub's matrix, on small scenes: each engine, or
each command that the file names, makes the shards of a plan, and merged they are one run.

    engines_test.py ZPROOF SOURCE_FOLDER parallel|snakemake|kubernetes|github
"""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import yaml

from same_run import differences


def require(is_right, what):
    if not is_right:
        sys.exit(f'engines_test: {what}')


class Place:
    """A folder with models, and a zproof on PATH that plans for small pictures, notes what it is called for, and dies
    the first time at the shards of DIES_AT."""

    def __init__(self, zproof, source):
        self.folder = Path(tempfile.mkdtemp(prefix='zproof-engines-'))
        self.source = source
        (self.folder / 'bin').mkdir()
        wrapper = self.folder / 'bin/zproof'
        wrapper.write_text(f'''#!/bin/sh
echo "$*" >> {self.folder}/called
if [ "$1" = plan ]; then exec {zproof} "$@" --width 48 --height 32 --oracle none --config none; fi
for shard in $DIES_AT; do
    case "$*" in *"--shard $shard "*) mkdir {self.folder}/died-$shard 2>&- && kill -9 $$;; esac
done
exec {zproof} "$@"
''')
        wrapper.chmod(0o755)
        self.environment = dict(os.environ, PATH=f'{self.folder}/bin:{os.environ["PATH"]}')
        mine = self.folder / 'mine'
        mine.write_text(f'#!/bin/sh\nexec python3 {source}/examples/zbuffer.py "$1" "$2" "$5"\n')
        mine.chmod(0o755)
        subprocess.run([zproof, 'scenes', 'generate', 'guard_band', 'fan_at_pixel_centre', '-o', self.folder / 'made'],
                       check=True, stdout=subprocess.DEVNULL)
        (self.folder / 'models').mkdir()
        for model in (self.folder / 'made').glob('*.glb'):  # without their view files, which state their own sizes
            model.rename(self.folder / 'models' / model.name)

    def run(self, words, **environment):
        return subprocess.run(words, cwd=self.folder, env=self.environment | environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def ran(self, words, status=0, **environment):
        ran = self.run(words, **environment)
        require(ran.returncode == status, f'{words}: status {ran.returncode}, expected {status}:\n{ran.stdout}')
        return ran.stdout

    def shell(self, script, **environment):
        return self.ran(['sh', '-e', '-c', script], **environment)

    def calls_of_shard(self, shard):
        return sum(f'--shard {shard} ' in line for line in (self.folder / 'called').read_text().splitlines())

    def require_one_run(self):
        """What was merged into zproof-out is what the plan's own run gives."""
        argv = json.loads((self.folder / 'plan.json').read_text())['runs'][0]['argv']
        self.ran(['zproof', *argv, '-o', 'one', '-q'])
        different = differences(self.folder / 'zproof-out', self.folder / 'one')
        require(not different, f'merged, and not as one run: {different}')


def try_parallel(place):
    shutil.copy(place.source / 'examples/parallel/judge.sh', place.folder)
    require(place.run(['./judge.sh'], DIES_AT='3').returncode != 0, 'a shard died, and nobody was told')
    require(not (place.folder / 'zproof-out').exists(), 'merged without shard 3')
    place.ran(['./judge.sh'])
    require([place.calls_of_shard(shard) for shard in range(1, 9)] == [1, 1, 2, 1, 1, 1, 1, 1],
            'others than the shard that died were made again')


def try_snakemake(place):
    shutil.copy(place.source / 'examples/snakemake/Snakefile', place.folder)
    words = ['snakemake', '--cores', '2', '--config', 'shards=3', '--nolock']
    require(place.run(words, DIES_AT='2').returncode != 0, 'a shard died, and nobody was told')
    place.ran(words)
    require([place.calls_of_shard(shard) for shard in (1, 3)] == [1, 1] and place.calls_of_shard(2) == 2,
            'others than the shard that died were made again')


def try_kubernetes(place):
    job = yaml.safe_load((place.source / 'examples/kubernetes/job.yml').read_text())
    require((job['apiVersion'], job['kind']) == ('batch/v1', 'Job'), 'it is no Job')
    spec = job['spec']
    require(spec['completionMode'] == 'Indexed', 'its pods have no index')
    pod = spec['template']['spec']
    require(pod['restartPolicy'] in ('Never', 'OnFailure'), 'a Job takes no other restartPolicy')
    mounts = [mount['name'] for mount in pod['containers'][0]['volumeMounts']]
    require(mounts == [volume['name'] for volume in pod['volumes']], 'volumes and their mounts differ')
    place.ran(['zproof', 'plan', 'models', '--of', str(spec['completions'])])
    for index in range(spec['completions']):
        place.ran(pod['containers'][0]['command'], JOB_COMPLETION_INDEX=str(index))
    results = json.loads((place.folder / 'shards/1/results.json').read_text())
    require(results['run']['shard']['taken_from'] == 'JOB_COMPLETION_INDEX', 'the index was not taken')
    place.shell('zproof merge --plan plan.json shards/* -o zproof-out')


def filled(text, values):
    """A text with its expressions replaced; one that has no value is an error."""
    return re.sub(r'\$\{\{\s*(.*?)\s*\}\}', lambda match: str(values[match[1]]), str(text))


def try_github(place):
    workflow = yaml.safe_load((place.source / 'examples/ci/github-plan.yml').read_text())
    jobs = workflow['jobs']
    for name, job in jobs.items():
        needs = job.get('needs', [])
        for needed in [needs] if isinstance(needs, str) else needs:
            require(needed in jobs, f'{name} needs {needed}, which is no job')
        for step in job['steps']:
            require(('uses' in step) != ('run' in step), f'{name}: a step either uses or runs')
    variables = {key: str(value) for key, value in workflow['env'].items()} | {
        'GITHUB_OUTPUT': str(place.folder / 'told'), 'GITHUB_STEP_SUMMARY': str(place.folder / 'summary')}
    (place.folder / 'shards').mkdir()

    def run_steps(job, values):
        for step in job['steps']:
            if 'run' in step:
                place.shell(filled(step['run'], values), **variables)

    run_steps(jobs['plan'], {})
    told = (place.folder / 'told').read_text()
    require(told.startswith('matrix='), f'the plan told {told}')
    cells = json.loads(told.removeprefix('matrix='))
    require(filled(jobs['judge']['strategy']['matrix'], {'fromJSON(needs.plan.outputs.matrix)': 'it'}) == 'it',
            'the matrix is not that of the plan')
    for shard in cells['shard']:
        run_steps(jobs['judge'], {'matrix.shard': shard})
    run_steps(jobs['verdict'], {})
    require('proven' in (place.folder / 'summary').read_text(), 'the step summary does not tell the verdict')
    run_steps(jobs['plan'], {})  # with the times of the run before


def main(zproof, source, engine):
    place = Place(zproof, source)
    {'parallel': try_parallel, 'snakemake': try_snakemake, 'kubernetes': try_kubernetes,
     'github': try_github}[engine](place)
    if engine != 'github':  # whose second plan is another
        place.require_one_run()
    shutil.rmtree(place.folder)


if __name__ == '__main__':
    main(Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3])
