#!/usr/bin/env python3
"""examples/slurm/zproof.sbatch on a real Slurm: an array of 8, of which one task is killed and queued again. The merged
results are those of one run.

    slurm_test.py ZPROOF SOURCE_FOLDER
"""
import os
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

from same_run import differences
from slurm import Slurm, wait_for

SCENES = ['near_plane', 'clip_blades', 'slivers', 'room', 'million_triangles']
SHARDS = 8


def require(is_right, what):
    if not is_right:
        sys.exit(f'slurm_test: {what}')


def judging():
    """The processes that judge a shard now: {pid: shard}. Of each, the one that the batch script became."""
    found = {}
    for entry in Path('/proc').iterdir():
        try:
            words = (entry / 'cmdline').read_bytes().split(b'\0')
            if b'--shard' in words and b'shards/' in b' '.join(words):
                found.setdefault(words[words.index(b'--shard') + 1].decode(), []).append(int(entry.name))
        except (OSError, ValueError):
            continue
    return {min(pids): int(shard) for shard, pids in found.items() if shard.isdigit()}


def kill_one(place):
    """With signal 9, and before it has written anything. Returns its shard."""
    wait_for('a task judges', judging)
    pid, shard = next(iter(judging().items()))
    os.kill(pid, signal.SIGKILL)
    print(f'killed task {shard} (process {pid})')
    require(not (place / f'shards/{shard}').exists(), f'the killed task left shards/{shard}')
    return shard


def main(zproof, source):
    place = Path(tempfile.mkdtemp(prefix='zproof-slurm-'))
    place.chmod(0o755)
    (place / 'bin').mkdir()
    (place / 'bin/zproof').symlink_to(zproof)
    os.environ['PATH'] = f'{place}/bin:{os.environ["PATH"]}'
    shutil.copy(source / 'examples/slurm/zproof.sbatch', place)
    words = ['zproof', 'plan', *SCENES, '--oracle', 'none', '--of', str(SHARDS), '--config', 'none']
    subprocess.run(words, cwd=place, check=True, stdout=subprocess.DEVNULL)
    with Slurm(place / 'slurm') as slurm:
        job = slurm.call('sbatch', '--parsable', 'zproof.sbatch', cwd=place).strip()
        killed = kill_one(place)
        wait_for('the killed task has ended', lambda: slurm.states(job).get(killed) == 'FAILED')
        print(slurm.said('squeue', '--array'), end='')
        slurm.call('scontrol', 'requeue', f'{job}_{killed}')
        wait_for('all tasks are completed', lambda: set(slurm.states(job).values()) == {'COMPLETED'}, 600)
        print(*(f'task {task}: {state}' for task, state in sorted(slurm.states(job).items())), sep='\n')
    merged = subprocess.run(['zproof', 'merge', '--plan', 'plan.json', *(f'shards/{i}' for i in range(1, SHARDS + 1)),
                             '-o', 'merged', '-q'], cwd=place, stdout=subprocess.PIPE, text=True)
    require(merged.returncode == 0, f'merge: status {merged.returncode}')
    subprocess.run(['zproof', 'run', *SCENES, '--oracle', 'none', '--config', 'none', '-o', 'one', '-q'], cwd=place,
                   check=True, stdout=subprocess.DEVNULL)
    different = differences(place / 'merged', place / 'one')
    require(not different, f'merged, and not as one run: {different}')
    print(merged.stdout, end='')
    shutil.rmtree(place)


if __name__ == '__main__':
    main(Path(sys.argv[1]), Path(sys.argv[2]))
