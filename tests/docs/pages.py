#!/usr/bin/env python3
"""Writes what pages say as the code says it, between marks: `<!-- generated: NAME -->`, `<!-- end of NAME -->`.

    tests/docs/pages.py PROGRAM            write (./dev docs); PROGRAM: page_sections, which prints sections
    tests/docs/pages.py --check PROGRAM    say which page is not current

Exit status: 1 where a page is not current, or lacks the marks.
"""
import json
import pathlib
import subprocess
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parents[2]
LONGEST_LINE = 120


def broken(line):
    """Tables stay as they are; items of lists are continued below their text."""
    if not line.startswith("- "):
        return line
    return textwrap.fill(line, LONGEST_LINE, subsequent_indent="  ", break_on_hyphens=False)


def with_section(page, name, text):
    """The page with this text between its marks; ValueError where it has none."""
    begin, end = f"<!-- generated: {name} -->\n", f"<!-- end of {name} -->\n"
    before, rest = page.split(begin)
    _, after = rest.split(end)
    return before + begin + "".join(broken(line) + "\n" for line in text.splitlines()) + end + after


def main(arguments):
    is_check = arguments[0] == "--check"
    told = subprocess.run([arguments[-1]], capture_output=True, text=True, check=True).stdout
    failed = False
    for name, sections in json.loads(told).items():
        page = text = (ROOT / name).read_text()
        for section, words in sections.items():
            try:
                text = with_section(text, section, words)
            except ValueError:
                print(f"{name}: expected once each: <!-- generated: {section} -->, <!-- end of {section} -->")
                failed = True
        if text == page:
            continue
        if is_check:
            print(f"{name} is not current; run ./dev docs")
            failed = True
        else:
            (ROOT / name).write_text(text)
            print(f"{name}: written")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
