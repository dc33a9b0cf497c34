#!/usr/bin/env python3
"""Runs the shell commands of a page, and compares what the page shows with what they print.

    tests/docs/page_runs.py PAGE ZPROOF        ZPROOF: the program that the page calls zproof

The blocks marked ```sh run in order, in one shell, in a fresh folder that has the project's examples/. Each indented
block shows what the commands since the block before it print on standard output, where `...` stands for anything.
Seconds are not compared, nor what Embree's instruction set decides: the table's last two columns.
`The exit status is N.` speaks of the command before it; a block that nothing is said of ends with 0.

Exit status: 1 where the page shows something else than is printed.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
MARK = "== end of a block =="
PIECE = re.compile(r"^```sh\n(?P<commands>(?:.*\n)*?)```$|^(?P<shown>(?:    .*\n|\n(?=    ))+)|"
                   r"The exit status is (?P<status>\d+)", re.MULTILINE)


def pieces_of(page):
    """(line, kind, text) of the page's commands, shown outputs and exit statuses."""
    for found in PIECE.finditer(page):
        text = found[found.lastgroup]
        if found.lastgroup == "shown":
            text = "\n".join(line[4:] for line in text.strip("\n").split("\n"))
        if text:
            yield page.count("\n", 0, found.start()) + 1, found.lastgroup, text


def printed_by(blocks, program):
    """(exit status, standard output) of each block."""
    script = "".join(f"{block}echo \"{MARK} $?\"\n" for block in blocks)
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "examples").symlink_to(ROOT / "examples")
        (pathlib.Path(folder) / "bin").mkdir()
        (pathlib.Path(folder) / "bin/zproof").symlink_to(program)
        environment = {**os.environ, "PATH": f"{folder}/bin:{os.environ['PATH']}", "ZPROOF_CONFIG": "none"}
        told = subprocess.run(["bash", "-uc", script], cwd=folder, env=environment, text=True, check=True,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE)
    ends = re.compile(f"^{MARK} (\\d+)\n", re.MULTILINE)
    texts = ends.split(told.stdout)
    return list(zip(map(int, texts[1::2]), texts[0::2]))


def without_seconds(text):
    text = re.sub(r"\b\d+\.\d s$", "T s", text, flags=re.MULTILINE)
    return re.sub(r"^([✓✗] .* room/.*?)  +\S+  +\S+$|(ref e/b)  +seconds$", r"\1\2", text, flags=re.MULTILINE)


def pattern_of(shown):
    return "\n".join(".*".join(map(re.escape, line.split("..."))) if line.strip() != "..." else r"(?s:.*?)"
                     for line in without_seconds(shown).split("\n"))


def differences(page, program):
    pieces = list(pieces_of(page))
    outcomes = iter(printed_by([text for _, kind, text in pieces if kind == "commands"], program))
    status, expected, printed = 0, 0, ""
    for line, kind, text in [*pieces, (page.count("\n"), "commands", "")]:
        if kind == "commands":
            if status != expected:
                yield f"{line}: the commands before it end with {status}, not with {expected}"
            status, more = next(outcomes, (0, ""))
            expected, printed = 0, printed + more
        elif kind == "status":
            expected = int(text)
        else:
            if not re.fullmatch(pattern_of(text), without_seconds(printed).strip("\n")):
                yield f"{line}: the page shows\n{text}\nand printed is\n{printed}"
            printed = ""


def main(page, program):
    text = pathlib.Path(page).read_text(encoding="utf-8")
    found = [f"{page}:{difference}" for difference in differences(text, program)]
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
