"""A Slurm of this machine alone: one controller and two nodes of one processor each, on loopback, by Debian's
slurm-wlm. Needs no root and touches nothing outside its folder."""
import getpass
import os
import socket
import subprocess
import time
from pathlib import Path

CONFIGURATION = '''ClusterName=zproof
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
ReturnToService=2
NodeName=node1 NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[1]} CPUs=1 State=UNKNOWN
NodeName=node2 NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[2]} CPUs=1 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
'''


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(('127.0.0.1', 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


def wait_for(what, is_so, limit_s=120):
    end = time.monotonic() + limit_s
    while not is_so():
        if time.monotonic() > end:
            raise TimeoutError(f'{what}: not after {limit_s} s')
        time.sleep(0.05)


class Slurm:
    """To be used with `with`."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.environment = dict(os.environ, SLURM_CONF=str(self.folder / 'slurm.conf'))

    def __enter__(self):
        for name in ('munge', 'state', 'spool-node1', 'spool-node2'):
            (self.folder / name).mkdir(parents=True)
        (self.folder / 'munge/key').write_bytes(os.urandom(1024))
        (self.folder / 'munge/key').chmod(0o400)
        (self.folder / 'slurm.conf').write_text(CONFIGURATION.format(
            host=socket.gethostname(), folder=self.folder, user=getpass.getuser(), ports=free_ports(3)))
        self.call('munged', '--force', *(f'--{option}={self.folder}/munge/{file}' for option, file in (
            ('key-file', 'key'), ('socket', 'socket'), ('pid-file', 'pid'), ('log-file', 'log'), ('seed-file', 'seed'))))
        self.call('slurmctld', '-c')
        for node in ('node1', 'node2'):
            self.call('slurmd', '-N', node)
        wait_for('both nodes are idle', lambda: self.said('sinfo', '--noheader', '-o', '%D %t').split() == ['2', 'idle'])
        return self

    def __exit__(self, *_):
        for file in (*self.folder.glob('slurm*.pid'), self.folder / 'munge/pid'):
            if file.exists():
                subprocess.run(['kill', '-9', file.read_text().strip()], check=False)

    def run(self, *words, **options):
        sbin = f'{os.environ["PATH"]}:/usr/sbin:/sbin'
        return subprocess.run(words, env=self.environment | {'PATH': sbin}, text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, **options)

    def call(self, *words, **options):
        ran = self.run(*words, **options)
        if ran.returncode != 0:
            raise RuntimeError(f'{" ".join(words)}: status {ran.returncode}: {ran.stdout}')
        return ran.stdout

    def said(self, *words):
        return self.run(*words).stdout

    def states(self, job):
        """Of each task: {3: 'COMPLETED'}."""
        states = {}
        for line in self.said('scontrol', '--oneliner', 'show', 'job', job).splitlines():
            facts = dict(fact.split('=', 1) for fact in line.split() if '=' in fact)
            if facts.get('ArrayTaskId', '').isdigit():
                states[int(facts['ArrayTaskId'])] = facts['JobState']
        return states
