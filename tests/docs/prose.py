#!/usr/bin/env python3
"""Lists prose that is too long: lines above 120 columns and sentences above 35 words.

    tests/docs/prose.py                    look at README, CONTRIBUTING, CHANGELOG and docs/*.md
    tests/docs/prose.py FILE...            look at these
    tests/docs/prose.py --self-test        see whether planted offenders are found

Tables and code blocks may have long lines; a table's cells keep to the limit of words. Exit status: 1 where anything is
too long.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LONGEST_LINE, MOST_WORDS = 120, 35
ITEM = re.compile(r"^\s*([-*]|\d+\.)\s+")
SENTENCE_END = re.compile(r"(?<!\be\.g)(?<!\bi\.e)(?<!\bcf)(?<!\bvs)(?<=\S)[.!?][)\"*_]*\s+")


def pages():
    top = [ROOT / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")]
    return [*top, *sorted((ROOT / "docs").glob("*.md"))]


def cells_of(line):
    return re.split(r"(?<!\\)\|", line.strip().strip("|"))


def read(text):
    """The prose lines (number, line), and the blocks (number, text): paragraphs, list items, headings, cells."""
    lines, blocks, fenced, before = [], [], False, "blank"
    for number, line in enumerate(text.splitlines(), 1):
        is_fence = line.lstrip().startswith(("```", "~~~"))
        if is_fence or fenced:
            fenced, before = fenced != is_fence, "code"
        elif not line.strip():
            before = "code" if before == "code" else "blank"
        elif line.startswith("    ") and before in ("blank", "code") and not ITEM.match(line):
            before = "code"
        elif line.lstrip().startswith("|"):
            blocks += [(number, cell) for cell in cells_of(line)]
            before = "table"
        else:
            text_of = line.lstrip(" >")
            starts = before != "prose" or ITEM.match(line) or line.startswith("#")
            if starts:
                blocks.append((number, ITEM.sub("", text_of, count=1)))
            else:
                blocks[-1] = (blocks[-1][0], blocks[-1][1] + " " + text_of)
            lines.append((number, line))
            before = "blank" if line.startswith("#") else "prose"
    return lines, blocks


def sentences_of(block):
    """Code is one piece, whatever stops are in it; of a link only the text is read."""
    plain = re.sub(r"`[^`]*`", lambda code: re.sub(r"[.!?]", "_", code[0]), block)
    plain = re.sub(r"\]\([^)]*\)", "]", plain)
    return SENTENCE_END.split(plain)


def words_of(sentence):
    return [word for word in sentence.split() if re.search(r"\w", word)]


def offenders(text):
    """(line number, what is wrong) of a page."""
    lines, blocks = read(text)
    found = [(number, f"{len(line)} columns") for number, line in lines if len(line) > LONGEST_LINE]
    for number, block in blocks:
        for sentence in sentences_of(block):
            words = words_of(sentence)
            if len(words) > MOST_WORDS:
                found.append((number, f"{len(words)} words: {' '.join(words[:8])} ..."))
    return sorted(found)


def self_test():
    many = " ".join("w" * 36)
    few = " ".join("w" * 20)
    long_line = "x" * 121
    wrong = [many, f"- {many}", f"{few}\n{few}", f"| a | {many} |", long_line, f"{few} `a. b`\n{few}", f"> {many}",
             f"{few} e.g. {few}", f"```\ncode\n```\n{many}", f"    code\n\n{many}", f"{few}; {few}", f"# {few} {few}"]
    right = [f"{few}. {few}", f"- {few}\n- {few}", f"```\n{long_line}\n```", f"    {long_line}", f"| {long_line} |",
             f"# {few}\n{few}", f"| {few} | {few} |", f"{few}\n\n{few}", f"**{few}.** {few}"]
    missed = [text for text in wrong if not offenders(text)] + [text for text in right if offenders(text)]
    for text in missed:
        print(f"self-test: judged wrongly:\n{text}")
    return 1 if missed else 0


def main(arguments):
    if arguments == ["--self-test"]:
        return self_test()
    files = [pathlib.Path(name) for name in arguments] or pages()
    count = 0
    for file in files:
        for number, what in offenders(file.read_text()):
            print(f"{file}:{number}: {what}")
            count += 1
    print(f"{len(files)} pages, {count} offenders")
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
