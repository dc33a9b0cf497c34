#!/usr/bin/env python3
"""The Action's installer: which package it takes on which system, and what it refuses before anything is installed. Its step
of action.yml runs as it stands; apt-get, curl and the like are stand-ins that write down how they were called.

    install_test.py SOURCE_FOLDER
"""
import hashlib
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import yaml

SYSTEMS = {'debian12': 'ID=debian\nVERSION_ID="12"\n', 'debian13': 'ID=debian\nVERSION_ID="13"\n',
           'ubuntu24.04': 'ID=ubuntu\nID_LIKE=debian\nVERSION_ID="24.04"\n'}
UNKNOWN = {'ubuntu22.04': 'ID=ubuntu\nVERSION_ID="22.04"\n', 'fedora41': 'ID=fedora\nVERSION_ID=41\n', 'debian': 'ID=debian\n'}
PACKAGE = b'a package'
SHA256 = hashlib.sha256(PACKAGE).hexdigest()
TOOLS = 'bash cat chmod cut dirname env grep id mktemp realpath rm sed sha256sum wc'.split()


def require(is_right, what):
    if not is_right:
        sys.exit('install_test: ' + what)


class Machine:
    """A system whose programs are the installer's own tools and stand-ins."""

    def __init__(self, source, place):
        self.place, self.bin = place, place / 'bin'
        self.bin.mkdir()
        for tool in TOOLS:
            (self.bin / tool).symlink_to(shutil.which(tool))
        written = f'echo "${{0##*/}} $*" >>{place}/calls'
        for name, work in (('apt-get', written), ('zproof', written), ('dpkg', 'echo amd64'), ('sudo', '"$@"'),
                           ('curl', written + '; while [ "$1" != -o ]; do shift; done; printf %s "a package" >"$2"')):
            (self.bin / name).write_text(f'#!/bin/bash\n{work}\n')
            (self.bin / name).chmod(0o755)
        action = yaml.safe_load((source / 'action.yml').read_text())
        self.step, = (step for step in action['runs']['steps'] if step['name'] == 'Install zproof')
        self.defaults = {f'inputs.{name}': one['default'] for name, one in action['inputs'].items()}
        self.source = source

    def install(self, system, repository='OWNER/zproof', **inputs):
        """Runs the step; returns its status, what it said on stderr, and the calls of the stand-ins."""
        (self.place / 'os-release').write_text((SYSTEMS | UNKNOWN)[system])
        (self.place / 'calls').write_text('')
        values = self.defaults | {'github.action_repository': repository}
        values |= {'inputs.' + name.replace('_', '-'): value for name, value in inputs.items()}
        given = {name: re.sub(r'\${{ (.*?) }}', lambda match: values[match[1]], value)
                 for name, value in self.step['env'].items()}
        ran = subprocess.run(['/bin/bash', '-e', '-o', 'pipefail', '-c', self.step['run']], cwd=self.place, text=True,
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                             env=given | {'PATH': str(self.bin), 'OS_RELEASE': str(self.place / 'os-release'),
                                          'GITHUB_ACTION_PATH': str(self.source), 'TMPDIR': str(self.place)})
        return ran.returncode, ran.stderr, (self.place / 'calls').read_text().splitlines()


def require_refused(answer, words, what):
    status, said, calls = answer
    require(status == 3 and said.count('\n') == 1 and words in said, f'{what}: status {status}, {said}')
    require(calls == [], f'{what}: refused after {calls}')


def try_release(machine, version):
    """Without a package: that of the release, for this system; on another one a line that says which would do."""
    for system in SYSTEMS:
        status, said, calls = machine.install(system)
        url = f'https://github.com/OWNER/zproof/releases/download/v{version}/zproof_{version}-{system}_amd64.deb'
        require(status == 0, f'{system}: status {status}, {said}')
        require(calls[0].startswith('curl') and calls[0].endswith(' ' + url), f'{system}: {calls[0]}; expected {url}')
        require(re.search(r'^apt-get .* install .*/zproof\.deb povray$', calls[2]), f'{system}: {calls}')
        require(calls[3:] == ['zproof --version'], f'{system}: {calls}')
    for system in UNKNOWN:
        require_refused(machine.install(system), f'no package for {system}; expected \'runs-on: ubuntu-24.04\'', system)
    require_refused(machine.install('debian12', repository=''), 'no package', 'no repository')


def try_file(machine):
    """A file is taken on any system; of several, the one for this system."""
    for system in SYSTEMS:
        (machine.place / f'zproof_1-{system}_amd64.deb').write_bytes(PACKAGE)
    for system in SYSTEMS:
        status, said, calls = machine.install(system, package='zproof_*.deb')
        require(status == 0 and f'/zproof_1-{system}_amd64.deb povray' in calls[1], f'{system}: {status}, {said}, {calls}')
    status, said, _ = machine.install('fedora41', package='zproof_1-debian12_*.deb')
    require(status == 0, f'a package for another system is for apt-get to judge: {status}, {said}')
    for package, words in (('gone.deb', 'gone.deb: no such file'), ('*', 'several files, none of them for fedora41')):
        require_refused(machine.install('fedora41', package=package), words, package)


def try_sum(machine):
    """Another file than the one that is meant is refused before anything of it is installed."""
    file = 'zproof_1-debian13_amd64.deb'
    for sha256 in SHA256, SHA256.upper():
        status, said, calls = machine.install('debian13', package=file, package_sha256=sha256)
        require(status == 0 and calls[-1] == 'zproof --version', f'{sha256}: {status}, {said}, {calls}')
    wrong = SHA256[:-1] + ('0' if SHA256[-1] != '0' else '1')
    require_refused(machine.install('debian13', package=file, package_sha256=wrong), f'its SHA-256 is {SHA256}', file)
    for given in {}, {'package': 'https://example.org/zproof.deb'}:
        status, said, calls = machine.install('debian13', package_sha256=wrong, **given)
        require(status == 3 and f'expected {wrong}' in said, f'{given}: status {status}, {said}')
        require(len(calls) == 1 and calls[0].startswith('curl'), f'{given}: refused after {calls}')


def try_without_curl(machine):
    """Where curl is missing, apt-get is asked for it. The stand-in brings none, so that nothing else is installed."""
    (machine.bin / 'curl').unlink()
    status, _, calls = machine.install('debian12')
    require(status != 0 and len(calls) == 2 and calls[1].endswith('ca-certificates curl'), f'without curl: {status}, {calls}')


def main():
    source = Path(sys.argv[1]).resolve()
    version = re.search(r'project\(zproof VERSION (\S+)', (source / 'CMakeLists.txt').read_text())[1]
    with tempfile.TemporaryDirectory() as folder:
        machine = Machine(source, Path(folder))
        try_release(machine, version)
        try_file(machine)
        try_sum(machine)
        try_without_curl(machine)


if __name__ == '__main__':
    main()
