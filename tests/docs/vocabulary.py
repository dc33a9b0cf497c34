#!/usr/bin/env python3
"""Lists words for which the field has a better one (docs/glossary.md): pictures of our own.

    tests/docs/vocabulary.py               look at every source and page
    tests/docs/vocabulary.py --self-test   see whether planted words are found

Identifiers are taken apart at '_' and before capitals. Exit status: 1 where there is such a word.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BANNED = set("""accord acquaintance amendment audience comparand contestant court desk district docket easel glance
hearing inquest intruder law lawful lens nearness party plaint plea presort retrial roster ruling sight sitting stance
standing storyteller studio testimony theatre trick witness""".split())
ENDINGS = {".h", ".cpp", ".inl", ".md", ".py", ".ts", ".mjs", ".txt", ".cmake", ".json"}
# Not ours, made by programs, or about these words.
PASSED_OVER = {"build", ".git", "node_modules", "dist", "blender_render.py", "vocabulary.py", "package-lock.json",
               "zproof-out", "CHANGELOG.md"}
WORD = re.compile(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])")


def singulars_of(word):
    yield word
    for ending, put in (("ies", "y"), ("es", ""), ("s", "")):
        if word.endswith(ending):
            yield word[:-len(ending)] + put


def offenders(text):
    """(line number, word) of a text."""
    return [(number, form) for number, line in enumerate(text.splitlines(), 1) for word in WORD.findall(line)
            for form in singulars_of(word.lower()) if form in BANNED]


def texts(folder):
    for path in sorted(folder.iterdir()):
        if path.name in PASSED_OVER:
            continue
        if path.is_dir():
            yield from texts(path)
        elif path.suffix in ENDINGS:
            yield path


def self_test():
    wrong = ["struct LawMaker {};", "int first_sight = 0;", "// The witnesses agree.", '"Parties"', "class Testimony;"]
    right = ["flaws outlaw insight understanding third_partial desktop"]
    missed = [text for text in wrong if len(offenders(text)) != 1] + [text for text in right if offenders(text)]
    for text in missed:
        print(f"self-test: judged wrongly:\n{text}")
    return 1 if missed else 0


def main(arguments):
    if arguments == ["--self-test"]:
        return self_test()
    count = 0
    for path in texts(ROOT):
        name = path.relative_to(ROOT).as_posix()
        for number, word in offenders(name) + offenders(path.read_text(errors="replace")):
            print(f"{name}:{number}: {word}")
            count += 1
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
