#!/usr/bin/env python3
"""Makes every system call of a command fail once, and kills the command at every rename.

    tests/faults/inject.py PROGRAM [--every N [--seed S]] [--scenario NAME]

Of a call that is made more than 60 times, one in N is tried, drawn by the seed. Without --seed each run draws others; the
seed is printed. strace does the injecting. What `--version` does in the same order loads the program and is left out; of
every other thread, as many first calls are left out, too, since strace counts for each by itself. Whatever fails:

- the command ends with a documented status, never by a signal;
- the folder or file that it replaces is whole afterwards, the old one or the new one; a file is the new one where the
  status says so;
- nothing half-written lies beside it; after a kill, or where it could not be removed, the next run tidies up.

Prints a table of the calls and errors that were tried. Exit status: 1 where anything of this does not hold.
"""
import argparse
import collections
import json
import math
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

UNCHANGED = "retval=0"  # the kernel tells no error of brk, but an end of the heap that is not the wanted one
PATIENCE_SECONDS = 300
# What a folder's removal calls; the last two open it.
REMOVALS = ("unlink", "rmdir", "getdents64", "openat", "fcntl")
STATUSES = {0, 1, 2, 3, 4, 70, 130}
# clone3, which starts a thread, is left out: liblog4cplus, which OpenImageIO brings along, aborts or waits for ever where it
# gets none for its pool, while it is being loaded. So are stacks of threads, which mmap gives. Pipes are left out of close:
# Linux closes them whatever it says, but strace leaves them open.
LEFT_OUT = re.compile(r"(MAP_STACK|close\(\d+<pipe:).*\(INJECTED\)")
ERRORS = {"write": ["ENOSPC", "EIO", "EINTR"], "pwrite64": ["ENOSPC", "EIO"], "writev": ["ENOSPC", "EIO"],
          "openat": ["EMFILE", "EIO", "ENOMEM"], "read": ["EIO", "EINTR"], "close": ["EIO"], "fsync": ["EIO", "ENOSPC"],
          "rename": ["ENOSPC", "EIO"], "renameat2": ["EIO", "EINVAL"], "mkdir": ["ENOSPC"], "mmap": ["ENOMEM"],
          "brk": [UNCHANGED], "pipe2": ["EMFILE"], "clone": ["EAGAIN"], "vfork": ["EAGAIN"],
          "unlink": ["EIO"], "rmdir": ["EIO"], "unlinkat": ["EIO"], "newfstatat": ["EIO"], "getdents64": ["EIO"],
          "flock": ["ENOLCK"], "lseek": ["EIO"], "ftruncate": ["ENOSPC"], "wait4": ["EINTR"], "statx": ["EIO"],
          "poll": ["EINTR"], "ppoll": ["EINTR"], "pidfd_open": ["EMFILE"], "fcntl": ["EBADF"], "prctl": ["EINVAL"]}
SMALL = ["--width", "48", "--height", "27", "--oracle", "none"]
LARGE = ["--width", "64", "--height", "36", "--oracle", "none"]

RENDER = ["render", "room", "-o", "frames", "--width", "48", "--height", "27"]
COPY = ["--renderer", "cp frames/door.exr {out}"]  # right for one view, wrong for the other
ADD = ["waive", "add", "--waivers", "waivers.toml", "--from", "out", "--scene", "room", "--view", "floor", "--pixel", "PIXEL",
       "--link", "https://example.org/12", "--now", "2026-04-10"]
# What is prepared, what is made to fail, and what it replaces.
SCENARIOS = {
    "run": ([["run", "near_plane", "-o", "out", "--evidence", "all", *SMALL]],
            ["run", "near_plane", "-o", "out", "--evidence", "all", *LARGE], "out"),
    "compare": ([RENDER, ["run", "near_plane", "-o", "out", *SMALL]],
                ["compare", "frames/door.exr", "room", "--view", "door", "-o", "out", "--oracle", "none"], "out"),
    "program": ([RENDER, ["run", "near_plane", "-o", "out", *SMALL]],
                ["run", "room", "-o", "out", *COPY, *SMALL], "out"),
    "report": ([["run", "near_plane", "-o", "out", *SMALL], ["report", "out", "-o", "report.html"]],
               ["report", "out", "-o", "report.html"], "report.html"),
    "waive": ([RENDER, ["run", "room", "-o", "out", *COPY, *SMALL],
               [*ADD, "--reason", "first", "--expires", "2026-05-01"]],
              [*ADD, "--reason", "second", "--expires", "2026-06-01", "--reach", "pixels"], "waivers.toml"),
}


class Trial:
    """One scenario in a folder of its own. The program is a list of words, that the command's follow."""

    def __init__(self, program, name):
        self.program, self.name = program, name
        prepared, self.command, self.target = SCENARIOS[name]
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="zproof-faults-"))
        for words in prepared:
            self.require_sense(self.plain(words), words)
        self.command = self.with_pixel(self.command)
        self.before = self.folder / "before"
        self.before.mkdir()
        self.keep(self.folder / self.target, self.before / self.target)
        self.success = self.require_sense(self.plain(self.command), self.command)
        self.old, self.new = self.text(self.before), self.text(self.folder)
        self.faults, self.tried, self.not_reached = [], collections.Counter(), 0

    def require_sense(self, done, words):
        if done.returncode not in (0, 1, 3):
            sys.exit(f"{self.name}: {words}: status {done.returncode}: {done.stderr.decode()}")
        return done.returncode

    def with_pixel(self, words):
        """PIXEL stands for the worst one of the second view."""
        if "PIXEL" not in words:
            return words
        worst = json.loads((self.folder / "out" / "results.json").read_text())["views"][1]["worst"][0]
        return [f"{worst['x']},{worst['y']}" if word == "PIXEL" else word for word in words]

    def plain(self, words):
        return subprocess.run([*self.program, *self.with_pixel(words)], cwd=self.folder, capture_output=True, timeout=300)

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
        command = ["strace", "-f", "-o", log, *options, *self.program, *(words or self.command)]
        with subprocess.Popen(command, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              start_new_session=True) as process:
            try:
                said = process.communicate(timeout=PATIENCE_SECONDS)
                status = process.returncode
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                said, status = process.communicate(), "that it would have had: it does not end"
        return subprocess.CompletedProcess(command, status, *said), log.read_text(errors="replace")

    def calls(self, words):
        """The calls that each thread makes, in order, with numbers that differ from run to run left out."""
        _, log = self.traced("-e", "trace=" + ",".join("?" + name for name in ERRORS), words=words)
        threads = collections.defaultdict(list)
        for thread, call, rest in re.findall(r"^(\d+) +(\w+)(\(.*)$", log, re.M):
            threads[thread].append((call, re.sub(r"0x[0-9a-f]+", "0x", rest)))
        return list(threads.values())

    def loading_and_all(self):
        """How often each is called while the program is loaded, and at most by one thread: strace counts for each."""
        version, threads = self.calls(["--version"])[0], self.calls(self.command)
        loading = collections.Counter()
        for plain, here in zip(version, threads[0]):
            if plain != here:
                break
            loading[here[0]] += 1
        most = collections.Counter()
        for calls in threads:
            most |= collections.Counter(call for call, _ in calls)
        return loading, most

    def text(self, folder):
        """Of a file that is replaced; a folder's is not compared, since times differ."""
        file = folder / self.target
        return file.read_bytes() if file.is_file() else b""

    def is_whole(self):
        """A file is the old one or the new one. A folder holds what its list says, and its results can be read."""
        target = self.folder / self.target
        if not target.is_dir():
            return self.text(self.folder) in (self.old, self.new)
        for line in (target / ".zproof-out").read_text().splitlines()[1:]:
            size, _, name = line.split(" ", 2)
            file = target / name
            if not file.is_file() or file.stat().st_size != int(size):
                return False
        json.loads((target / "results.json").read_text())
        return True

    def complain(self, what, done, fault):
        said = done.stderr.decode(errors="replace").strip().splitlines()
        self.faults.append(f"{self.name}: {fault}: {what}; status {done.returncode}; {said[-1:] or ''}")
        print(self.faults[-1], flush=True)

    def injected(self, fault):
        """Runs the command; strace injects only into calls that it traces. Threads may not come as far as the place."""
        self.restore()
        call, how = fault.split(":")[:2]
        done, log = self.traced("-y", "-e", "trace=" + call, "-e", "inject=" + fault)
        if ("(INJECTED)" in log and not LEFT_OUT.search(log)) or "killed by SIGKILL" in log:
            self.tried[call, how] += 1
        else:
            self.not_reached += 1
        return done, log

    def try_fault(self, fault):
        done, log = self.injected(fault)
        if LEFT_OUT.search(log):
            return
        if done.returncode not in STATUSES:
            self.complain("not a documented status", done, fault)
        is_silenced = re.search(r"write\(2\b.*\(INJECTED\)", log)
        if done.returncode != 0 and not done.stderr.strip() and not is_silenced:
            self.complain("no word of it", done, fault)
        if done.returncode == self.success and self.text(self.folder) != self.new:
            self.complain("not done, and the status says that it is", done, fault)
        self.look(done, fault)
        if self.beside() and fault.startswith(REMOVALS):
            self.plain(self.command)
        if self.beside():
            self.complain(f"left {self.beside()}", done, fault)

    def beside(self):
        return [e.name for e in self.folder.iterdir() if e.name.startswith(self.target + ".")]

    def look(self, done, fault):
        try:
            if not self.is_whole():
                self.complain("what it leaves is not whole", done, fault)
        except (OSError, ValueError) as error:
            self.complain(f"what it leaves cannot be read: {error}", done, fault)

    def try_kill(self, fault):
        done, _ = self.injected(fault)
        self.look(done, fault)
        after = self.plain(self.command)
        if after.returncode not in (0, 1, 3) or self.beside():
            self.complain(f"the next run ends with {after.returncode} and leaves {self.beside()}", done, fault)


    def try_all(self, every, draw, calls=tuple(ERRORS)):
        loading, all_calls = self.loading_and_all()
        for call in calls:
            errors = ERRORS[call]
            for place in places(loading[call], all_calls[call], every, draw):
                for error in errors:
                    how = error if error == UNCHANGED else f"error={error}"
                    self.try_fault(f"{call}:{how}:when={place}")
                if call in ("rename", "renameat2", "mkdir", "unlink", "fsync"):
                    self.try_kill(f"{call}:signal=KILL:when={place}")
        if not self.tried:
            sys.exit(f"{self.name}: strace injected nothing")


def places(first, last, every, draw):
    """Those after the first, up to the last; of many, one in so many."""
    every_place = range(first + 1, last + 1)
    if len(every_place) <= 60:
        return every_place
    return sorted(draw.sample(every_place, math.ceil(len(every_place) / every)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda p: str(pathlib.Path(p).resolve()))
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--seed", type=int, default=int(time.time()))
    parser.add_argument("--scenario", choices=SCENARIOS)
    parser.add_argument("--call", choices=ERRORS, help="make no other system call fail")
    options = parser.parse_args()
    print("seed", options.seed, flush=True)
    draw, faults, table = random.Random(options.seed), [], collections.Counter()
    for name in [options.scenario] if options.scenario else SCENARIOS:
        trial = Trial([options.program], name)
        trial.try_all(options.every, draw, [options.call] if options.call else tuple(ERRORS))
        table += trial.tried
        faults += trial.faults
        shutil.rmtree(trial.folder, ignore_errors=True)
        print(f"{name}: {len(trial.faults)} faults; {trial.not_reached} places were not reached", flush=True)
    for (call, how), count in sorted(table.items()):
        print(f"| `{call}` | {how} | {count} |")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
