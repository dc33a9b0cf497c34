#!/usr/bin/env python3
"""Makes every system call of a command fail once, and kills the command at every rename.

    tests/faults/inject.py PROGRAM [--every N] [--scenario NAME]   N: only each N-th call of those with more than 60

strace does the injecting; calls that load the program (as many as `--version` makes) are left out. Whatever fails:

- the command ends with a documented status, never by a signal;
- the folder or file that it replaces is whole afterwards: the old one, or the new one where the status is 0;
- nothing half-written lies beside it; after a kill, the next run tidies up.

Prints a table of the calls and errors that were tried. Exit status: 1 where anything of this does not hold.
"""
import argparse
import collections
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

STATUSES = {0, 1, 2, 3, 4, 70, 130}
ERRORS = {"write": ["ENOSPC", "EIO", "EINTR"], "pwrite64": ["ENOSPC", "EIO"], "writev": ["ENOSPC", "EIO"],
          "openat": ["EMFILE", "EIO", "ENOMEM"], "read": ["EIO", "EINTR"], "close": ["EIO"], "fsync": ["EIO", "ENOSPC"],
          "rename": ["ENOSPC", "EIO"], "renameat2": ["EIO", "EINVAL"], "mkdir": ["ENOSPC"], "mmap": ["ENOMEM"],
          "brk": ["ENOMEM"], "pipe2": ["EMFILE"], "clone": ["EAGAIN"], "clone3": ["EAGAIN"], "vfork": ["EAGAIN"],
          "unlink": ["EIO"], "rmdir": ["EIO"], "unlinkat": ["EIO"], "newfstatat": ["EIO"], "getdents64": ["EIO"],
          "flock": ["ENOLCK"], "lseek": ["EIO"], "ftruncate": ["ENOSPC"], "wait4": ["EINTR"], "statx": ["EIO"],
          "poll": ["EINTR"], "ppoll": ["EINTR"], "pidfd_open": ["EMFILE"], "fcntl": ["EBADF"], "prctl": ["EINVAL"]}
SMALL = ["--width", "48", "--height", "27", "--oracle", "none"]
LARGE = ["--width", "64", "--height", "36", "--oracle", "none"]

# What is prepared, what is made to fail, and what it leaves.
SCENARIOS = {
    "run": (["run", "near_plane", "-o", "out", "--evidence", "all", *SMALL],
            ["run", "near_plane", "-o", "out", "--evidence", "all", *LARGE], "out"),
    "compare": (["render", "room", "-o", "frames", "--width", "48", "--height", "27"],
                ["compare", "frames/door.exr", "room", "--view", "door", "-o", "out", "--oracle", "none"], "out"),
    "program": (["render", "room", "-o", "frames", "--width", "48", "--height", "27"],
                ["run", "room", "-o", "out", "--renderer", "cp frames/door.exr {out}", *SMALL], "out"),
    "report": (["run", "near_plane", "-o", "first", *SMALL], ["report", "first", "-o", "report.html"], "report.html"),
}


class Trial:
    """One scenario in a folder of its own."""

    def __init__(self, program, name):
        self.program, self.name = program, name
        self.prepare, self.command, self.target = SCENARIOS[name]
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="zproof-faults-"))
        self.plain(self.prepare)
        self.plain(self.command if self.target != "out" or self.prepare[0] != "run" else self.prepare)
        self.before = self.folder / "before"
        self.before.mkdir()
        self.keep(self.folder / self.target, self.before / self.target)
        self.text_before = self.text()
        self.faults = []

    def plain(self, words):
        return subprocess.run([self.program, *words], cwd=self.folder, capture_output=True, timeout=300)

    def keep(self, source, to):
        if source.is_dir():
            shutil.copytree(source, to)
        else:
            shutil.copy2(source, to)

    def restore(self):
        for entry in self.folder.iterdir():
            if entry.name.startswith(self.target) or ".kept" in entry.name:
                shutil.rmtree(entry) if entry.is_dir() else entry.unlink()
        self.keep(self.before / self.target, self.folder / self.target)

    def traced(self, *options, words=None):
        log = self.folder / "strace.log"
        command = ["strace", "-f", "-o", log, *options, self.program, *(words or self.command)]
        done = subprocess.run(command, cwd=self.folder, capture_output=True, timeout=300)
        return done, log.read_text(errors="replace")

    def calls(self, words):
        """The calls that the threads make: the largest count of any, since strace counts for each by itself."""
        _, log = self.traced("-e", "trace=" + ",".join("?" + name for name in ERRORS), words=words)
        counts = collections.Counter(re.findall(r"^(\d+) +(\w+)\(", log, re.M))
        most = collections.Counter()
        for (_, name), count in counts.items():
            most[name] = max(most[name], count)
        return most

    def text(self):
        target = self.folder / self.target
        file = target / "results.json" if target.is_dir() else target
        return file.read_bytes() if file.is_file() else b""

    def is_whole(self):
        """The folder holds what its list says, and its results can be read."""
        target = self.folder / self.target
        if not target.is_dir():
            return target.is_file() and target.read_bytes().rstrip().endswith(b"</html>")
        for line in (target / ".zproof-out").read_text().splitlines()[1:]:
            size, _, name = line.split(" ", 2)
            file = target / name
            if not file.is_file() or file.stat().st_size != int(size):
                return False
        json.loads(self.text())
        return True

    def complain(self, what, done, fault):
        said = done.stderr.decode(errors="replace").strip().splitlines()
        self.faults.append(f"{self.name}: {fault}: {what}; status {done.returncode}; {said[-1:] or ''}")
        print(self.faults[-1], flush=True)

    def try_fault(self, fault):
        self.restore()
        done, _ = self.traced("-e", "trace=none", "-e", "inject=" + fault)
        if done.returncode not in STATUSES:
            self.complain("not a documented status", done, fault)
        if done.returncode != 0 and not done.stderr.strip():
            self.complain("no word of it", done, fault)
        self.look(done, fault)
        beside = [e.name for e in self.folder.iterdir() if e.name.startswith(self.target + ".")]
        if beside:
            self.complain(f"left {beside}", done, fault)

    def look(self, done, fault):
        try:
            if not self.is_whole():
                self.complain("what it leaves is not whole", done, fault)
        except (OSError, ValueError) as error:
            self.complain(f"what it leaves cannot be read: {error}", done, fault)

    def try_kill(self, fault):
        self.restore()
        done, _ = self.traced("-e", "trace=none", "-e", "inject=" + fault)
        self.look(done, fault)
        after = self.plain(self.command)
        beside = [e.name for e in self.folder.iterdir() if e.name.startswith(self.target + ".")]
        if after.returncode not in (0, 1, 3) or beside:
            self.complain(f"the next run ends with {after.returncode} and leaves {beside}", done, fault)


def places(first, last, every):
    step = every if last - first > 60 else 1
    return range(first + 1, last + 1, step)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda p: str(pathlib.Path(p).resolve()))
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--scenario", choices=SCENARIOS)
    options = parser.parse_args()
    faults, table = [], collections.Counter()
    for name in [options.scenario] if options.scenario else SCENARIOS:
        trial = Trial(options.program, name)
        before, all_calls = trial.calls(["--version"]), trial.calls(trial.command)
        for call, errors in ERRORS.items():
            for place in places(before[call], all_calls[call], options.every):
                for error in errors:
                    trial.try_fault(f"{call}:error={error}:when={place}")
                    table[call, error] += 1
                if call in ("rename", "renameat2", "mkdir", "unlink", "fsync"):
                    trial.try_kill(f"{call}:signal=KILL:when={place}")
                    table[call, "killed"] += 1
        faults += trial.faults
        shutil.rmtree(trial.folder, ignore_errors=True)
        print(f"{name}: {len(trial.faults)} faults", flush=True)
    for (call, error), count in sorted(table.items()):
        print(f"| `{call}` | {error} | {count} |")
    return 1 if faults else 0


sys.exit(main())
