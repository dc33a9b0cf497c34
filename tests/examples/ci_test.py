#!/usr/bin/env python3
"""The CI files: action.yml, templates/gate.yml and those of examples/ci. Their shape, and every command in them, run on
small scenes. Of the Action's steps only the installation is left out, which install_test.py tries.

    ci_test.py ZPROOF SOURCE_FOLDER
"""
import hashlib
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


def filled(text, values, left='${{', right='}}'):
    """A text with its expressions replaced; one that has no value is an error."""
    def value(match):
        require(match[1] in values, f'{match[0]} has no value')
        return str(values[match[1]])
    return re.sub(re.escape(left) + r'\s*(.*?)\s*' + re.escape(right), value, text)


def require_inputs_used(inputs, used, place):
    require(inputs.keys() == used, f'{place}: inputs that are not used or not declared: {inputs.keys() ^ used}')


def zproof_version(source):
    return re.search(r'project\(zproof VERSION (\S+)', (source / 'CMakeLists.txt').read_text())[1]


# --- GitHub ------------------------------------------------------------------------------------------------

class Action:
    """action.yml, and a step that uses it."""

    def __init__(self, source):
        self.folder = source
        text = (source / 'action.yml').read_text()
        action = yaml.safe_load(text)
        require_keys(action, ['name', 'description', 'inputs', 'outputs', 'runs'], [], 'action.yml')
        self.inputs, self.steps = action['inputs'], action['runs']['steps']
        require(action['runs']['using'] == 'composite', 'action.yml: it is not composite')
        require_inputs_used(self.inputs, set(re.findall(r'inputs\.([a-z0-9-]+)', text)), 'action.yml')
        for name, one in self.inputs.items():
            require_keys(one, ['description', 'default'], [], f'input {name}')
        for step in self.steps:
            require_keys(step, ['name'], ['id', 'if', 'shell', 'env', 'run', 'uses', 'with'], 'a step of action.yml')
            require('uses' in step or step.get('shell') == 'bash', f'{step["name"]}: composite steps name their shell')
            require('inputs.' not in step.get('run', ''), f'{step["name"]}: an input is pasted into a script')
        require(action['outputs'].keys() == {'verdict', 'report'}, 'action.yml: other outputs')

    def run(self, given, place, environment):
        """Runs its steps by hand, all but the installation; returns the last status, the verdict and what is kept."""
        require_keys(given, [], self.inputs, "the action's inputs")
        values = {f'inputs.{name}': given.get(name, one['default']) for name, one in self.inputs.items()}
        values['github.action_repository'] = 'OWNER/zproof'
        kept = None
        for step in self.steps:
            if 'uses' in step:
                kept = {name: filled(str(value), values) for name, value in step['with'].items()}
                continue
            variables = {name: filled(value, values) for name, value in step['env'].items()}
            if step['name'] == 'Install zproof':
                continue
            told = place / 'told'
            told.write_text('')
            ran = subprocess.run(['bash', '-e', '-o', 'pipefail', '-c', step['run']], cwd=place, text=True,
                                 env=environment | variables | {'GITHUB_ACTION_PATH': str(self.folder),
                                                                'GITHUB_OUTPUT': str(told)},
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            for line in told.read_text().splitlines():
                name, value = line.split('=', 1)
                values[f'steps.{step["id"]}.outputs.{name}'] = value
        return ran.returncode, values['steps.judge.outputs.verdict'], kept


def try_github(source, place, environment):
    workflow = yaml.safe_load((source / 'examples/ci/github.yml').read_text())
    workflow['on'] = workflow.pop(True, workflow.get('on'))  # YAML 1.1 reads "on" as true
    require_keys(workflow, ['name', 'on', 'jobs'], ['permissions'], 'github.yml')
    require('pull_request' in workflow['on'], 'it does not run on pull requests')
    action, uses, verdicts = Action(source), set(), []
    for name, job in workflow['jobs'].items():
        require_keys(job, ['runs-on', 'steps'],
                     ['needs', 'container', 'timeout-minutes', 'strategy', 'outputs', 'if'], name)
        require(job.get('needs', name) in workflow['jobs'], f'{name} needs {job.get("needs")}, which is no job')
        for cell in job.get('strategy', {}).get('matrix', {}).get('shard', [None]):
            values = {'matrix.shard': cell, 'needs.plan.outputs.today': TODAY}
            for step in job['steps']:
                require_keys(step, [], ['id', 'run', 'uses', 'with'], f'a step of {name}')
                used, _, tag = step.get('uses', '@').partition('@')
                uses.add(used)
                if used != 'OWNER/zproof':
                    continue
                require(tag == 'v' + zproof_version(source), f'{name}: {tag} is not this version')
                given = {key: filled(str(value), values) for key, value in step['with'].items()}
                status, verdict, kept = action.run(given, place, environment)
                require(status == 0, f'{name}: status {status}, {verdict}')
                require((place / kept['path'] / 'results.json').is_file(), f'{kept["path"]} has no results.json')
                verdicts.append(verdict)
    require(uses == {'', 'actions/checkout', 'actions/download-artifact', 'OWNER/zproof'}, f'it uses {uses}')
    require(verdicts[-1] == 'proven', f'the verdicts are {verdicts}')
    require('proven' in (place / 'summary').read_text(), 'the step summary does not tell the verdict')
    return action


def try_bad_renderers(action, place, environment):
    """What is wrong keeps zproof's status to the end."""
    blank = 'sh -c true {scene} {camera} {out}'
    (place / 'talked').rmdir()
    for given, expected in (
            ({'renderer': blank}, (3, 'contract_broken')),
            ({'renderer': blank, 'contract-check': 'false'}, (3, 'unreadable')),
            ({'scene': 'models', 'renderer': './wrong {scene} {camera} {width} {height} {out}',
              'contract-check': 'false'}, (1, 'defective')),
            ({'arguments': '--no-such-option'}, (2, 'usage')),
            ({'arguments': '"'}, (2, 'usage')),
            ({'scene': 'room', 'shard': 'hash:9/999'}, (0, 'nothing_judged'))):
        status, verdict, _ = action.run({'scene': 'guard_band', 'out': 'bad'} | given, place, environment)
        require((status, verdict) == expected, f'{given}: {status}, {verdict}; expected {expected}')
        shutil.rmtree(place / 'bad', ignore_errors=True)


# --- GitLab ------------------------------------------------------------------------------------------------

def try_gitlab(source, place, environment):
    text = (source / 'templates/gate.yml').read_text()
    header, jobs = (part for part in text.split('\n---\n'))
    inputs = yaml.safe_load(header)['spec']['inputs']
    require_inputs_used(inputs, set(re.findall(r'\$\[\[ inputs\.([a-z0-9_]+) \]\]', jobs)), 'gate.yml')
    include = yaml.safe_load((source / 'examples/ci/gitlab-ci.yml').read_text())['include'][0]
    require(include['component'].endswith('/zproof/gate@v' + zproof_version(source)), 'another component or version')
    require_keys(include['inputs'], [name for name, one in inputs.items() if 'default' not in one], inputs,
                 'the inputs of gitlab-ci.yml')
    values = {f'inputs.{name}': include['inputs'].get(name, one.get('default')) for name, one in inputs.items()}
    jobs = {filled(name, values, '$[[', ']]'): job for name, job in yaml.safe_load(jobs).items()}
    for name, job in jobs.items():
        require_keys(job, [] if name.startswith('.') else ['script', 'artifacts', 'extends'],
                     ['stage', 'image', 'variables', 'before_script', 'parallel', 'timeout', 'needs', 'when'], name)
    variables = {name: filled(value, values, '$[[', ']]') for name, value in jobs['.zproof']['variables'].items()}
    for line in jobs['.zproof']['before_script']:  # needs root
        require(subprocess.run(['sh', '-n', '-c', line]).returncode == 0, f'no shell reads: {line}')
    try_gitlab_sum(jobs['.zproof']['before_script'], place)
    judge, verdict = jobs['zproof:judge'], jobs['zproof:verdict']
    require(verdict['artifacts']['reports']['junit'] == 'zproof-out/junit.xml', 'no JUnit')
    total = int(filled(str(judge['parallel']), values, '$[[', ']]'))
    cells = [(judge, {'CI_NODE_INDEX': str(i), 'CI_NODE_TOTAL': str(total)}) for i in range(1, total + 1)]
    for job, node in [*cells, (verdict, {})]:
        script = '\n'.join(filled(line, values, '$[[', ']]') for line in job['script'])
        ran = subprocess.run(['sh', '-e', '-c', script], cwd=place, env=environment | variables | node, text=True,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        require(ran.returncode == 0, f'status {ran.returncode}:\n{script}\n{ran.stdout}')


def try_gitlab_sum(lines, place):
    """Before the package is installed, its sum is looked at where one is given."""
    check = [number for number, line in enumerate(lines) if 'sha256sum' in line]
    require(len(check) == 1 and check[0] + 1 == len(lines) - 1, f'gate.yml: no sum is looked at before {lines[-1]}')
    (place / 'some_1.deb').write_text('a package')
    right = hashlib.sha256(b'a package').hexdigest()
    for sha256, expected in (('', True), (right, True), (right[1:] + right[0], False)):
        ran = subprocess.run(['sh', '-c', lines[check[0]]], cwd=place, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                             env=dict(os.environ, PACKAGE='some_*.deb', PACKAGE_SHA256=sha256))
        require((ran.returncode == 0) == expected, f'gate.yml: sum {sha256!r}: status {ran.returncode}')


# --- a project that uses them ------------------------------------------------------------------------------

def furnish(place, zproof, source):
    """A project with two small models, renderers and waivers; zproof is small on PATH."""
    (place / 'bin').mkdir()
    programs = {
        # Talked to once: the conversation is the same on every machine.
        'bin/zproof': f'echo "$1" >> {place}/called\n'
                      f'if [ "$1" = run ]; then set -- "$@" --width 48 --height 32 --oracle none; fi\n'
                      f'if [ "$1" = contract-check ] && ! mkdir {place}/talked 2>&-; then exit; fi\n'
                      f'exec {zproof} "$@"',
        'mine': f'exec python3 {source}/examples/zbuffer.py "$1" "$2" "$5"',
        'wrong': f'exec python3 {source}/tests/cli/faulty_renderer.py depth_is_ray_length "$1" "$2" "$5"',
    }
    for name, text in programs.items():
        (place / name).write_text(f'#!/bin/sh\n{text}\n')
        (place / name).chmod(0o755)
    subprocess.run([zproof, 'scenes', 'generate', 'guard_band', 'fan_at_pixel_centre', '-o', place / 'made'],
                   check=True, stdout=subprocess.DEVNULL)
    (place / 'models').mkdir()
    for model in (place / 'made').glob('*.glb'):
        shutil.copy(model, place / 'models')
    shutil.copy(source / 'examples/ci/waivers.toml', place)


def main():
    zproof, source = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2]).resolve()
    for server in 'github', 'gitlab':
        with tempfile.TemporaryDirectory() as folder:
            place = Path(folder)
            furnish(place, zproof, source)
            environment = dict(os.environ, PATH=f'{place}/bin:{os.environ["PATH"]}',
                               CI_PIPELINE_CREATED_AT=TODAY + 'T12:00:00Z', GITHUB_STEP_SUMMARY=str(place / 'summary'))
            action = try_github(source, place, environment) if server == 'github' else None
            if server == 'gitlab':
                try_gitlab(source, place, environment)
            called = (place / 'called').read_text().split()
            require(called == ['contract-check', 'run'] * 2 + ['merge'], f'{server}: called were {called}')
            for name in 'report.html', 'results.json', 'junit.xml':
                require((place / 'zproof-out' / name).stat().st_size > 0, f'{server}: {name} is empty')
            if action:
                try_bad_renderers(action, place, environment)


if __name__ == '__main__':
    main()
