"""What the programs that plant defects have in common: catalogues of them, the words that compile and link, and
sections of a page."""
import collections
import functools
import json
import pathlib
import re
import shlex
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent

Mutant = collections.namedtuple("Mutant", "area sentence name file find put survives mode cause symptom admitted")


class Refusal(Exception):
    """A defect that cannot be planted, built or run."""


def mutant_of(area, lines):
    """`survives` says why nothing can catch it; empty where something should. `mode`: of the plain renderer, or
    the filter that is judged. `cause`: how the diagnosis's right name begins; empty where no hypothesis describes it.
    `symptom`: how a name begins that is true of the frame, and does not say why. `admitted`: why a promise of less
    precision admits it."""
    fields = {key: value.strip() for key, value in (line.split(":", 1) for line in lines[1:])}
    return Mutant(area, lines[0], fields["name"], fields["file"], fields["find"], fields["put"],
                  *(fields.get(key, "") for key in Mutant._fields[6:]))


def read_catalogue(name):
    mutants, area = [], ""
    for block in (HERE / name).read_text().split("\n\n"):
        lines = [line for line in block.splitlines() if line and not line.startswith("# ")]
        if not lines:
            continue
        if lines[0].startswith("## "):
            area = lines[0][3:]
        else:
            mutants.append(mutant_of(area, lines))
    names = [mutant.name for mutant in mutants]
    if len(set(names)) != len(names):
        raise Refusal(f"{name}: a name occurs twice")
    return mutants


def pattern_of(find):
    """Lines may be broken otherwise than in the catalogue."""
    return r"\s+".join(re.escape(word) for word in find.split())


def planted_text(mutant):
    file = ROOT / mutant.file
    if not file.is_file():
        raise Refusal(f"{mutant.name}: there is no {mutant.file}")
    planted, times = re.subn(pattern_of(mutant.find), lambda _: mutant.put, file.read_text())
    if times != 1:
        raise Refusal(f"{mutant.name}: the text occurs {times} times in {mutant.file}, not once: {mutant.find}")
    return planted


def check(mutants, least):
    """Can all be planted, and are there so many? Names those that cannot."""
    plantable = 0
    for mutant in mutants:
        try:
            planted_text(mutant)
            plantable += 1
        except Refusal as refusal:
            print(refusal, file=sys.stderr)
    return 0 if plantable == len(mutants) >= least else 1


def add_list_options(parser):
    """What is asked of the list alone, without a build."""
    parser.add_argument("--check", action="store_true", help="only see whether every defect can be planted")
    parser.add_argument("--rebase", action="store_true", help="find texts that have moved again, and rewrite the list")


def write_if_changed(file, text):
    file.parent.mkdir(parents=True, exist_ok=True)
    if not file.exists() or file.read_text() != text:
        file.write_text(text)


def call(words, what, folder):
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        raise Refusal(f"{what}:\n{done.stderr[-2000:]}")
    return done.stdout


def without_precompiled(words):
    """Without the headers that the build parses beforehand: they are for its own flags."""
    if "-include" not in words:
        return words
    at = words.index("-include")
    return [word for word in words[:at] + words[at + 2:] if word != "-Winvalid-pch"]


def sources_of(unit):
    """What is compiled together: the sources that a file of the build's includes, or one source."""
    if "Unity" not in unit.parts:
        return [unit]
    return [pathlib.Path(file) for file in re.findall(r'^#include "(.+)"', unit.read_text(), re.MULTILINE)]


def compile_words(build, is_wanted):
    """The units that hold such a source: words that compile, up to a name, and all sources that are compiled together.
    A defect in one of them can be in the code of all."""
    units = []
    for command in json.loads((build / "compile_commands.json").read_text()):
        sources = [file.relative_to(ROOT) for file in sources_of(pathlib.Path(command["file"]))
                   if file.is_relative_to(ROOT)]
        if any(is_wanted(source) for source in sources):
            words = without_precompiled(shlex.split(command["command"]))
            flags = [word for word in words[:words.index("-o")] if word not in ("-Werror", "-O3", "-g1")]
            units.append((flags, [source.as_posix() for source in sources]))
    return units


def link_words(build, target):
    """Of a program; what may follow, such as listing its tests, is left out."""
    line = call(["ninja", "-t", "commands", target], "ninja", build).splitlines()[-1]
    return shlex.split(line.split(" && ")[1])


def prepare_headers(build, work, words, room):
    """What no defect touches, parsed once for all of them: the headers of other rooms and libraries."""
    included = sorted({line for source in (ROOT / room).rglob("*") if source.is_file()
                       for line in source.read_text().splitlines()
                       if line.startswith("#include") and f'"{room}/' not in line and "immintrin" not in line})
    header = work / "headers.h"
    header.write_text("\n".join(included) + "\n")
    call([*words, "-w", "-O1", "-x", "c++-header", str(header), "-o", f"{header}.gch"], "headers", build)
    return header


def compile_source(words, folder, header, source, made, what, build, level="-O1"):
    """What lies in the folder goes before what has its name elsewhere. Bits do not depend on the level."""
    at = next(i for i, word in enumerate(words) if word.startswith("-I"))
    headers = ["-include", str(header)] if header else []
    call([*words[:at], f"-I{folder}", *words[at:], "-w", level, *headers, "-o", str(made), "-c", str(source)], what,
         build)


@functools.lru_cache(maxsize=None)
def headers_of(file):
    """What of ours a source or header includes."""
    included = re.findall(r'^#include "([^"]+)"', (ROOT / file).read_text(), re.MULTILINE)
    return frozenset(header for header in included if (ROOT / header).is_file())


@functools.lru_cache(maxsize=None)
def sees(source, file):
    return source == file or any(sees(header, file) for header in headers_of(source))


def compile_mutant(mutant, folder, commands, build, header=None):
    """Objects of all that sees the defect."""
    write_if_changed(folder / mutant.file, planted_text(mutant))
    objects = []
    for number, (words, sources) in enumerate(commands):
        if not any(sees(source, mutant.file) for source in sources):
            continue
        whole, made = folder / f"unit{number}.cpp", folder / f"unit{number}.o"
        whole.write_text("".join(f'#include "{(folder if source == mutant.file else ROOT) / source}"\n'
                                 for source in sources))
        compile_source(words, folder, header, whole, made, f"{mutant.name} does not compile", build)
        objects.append(str(made))
    return objects


def link(target, objects, folder, build):
    """What the objects define, the linker takes neither from the program nor from its libraries."""
    words = link_words(build, target)
    at = next(i for i, word in enumerate(words) if word.endswith(".o"))
    program = folder / pathlib.Path(target).name
    words[words.index("-o") + 1] = str(program)
    call([*words[:at], *objects, *words[at:]], f"{folder.name} does not link", build)
    return program


# Of docs/detection-tables.md.
PLAINS_SECTION = "the plain renderer's mutants"
JUDGES_SECTION = "the judge's own mutants"


def marks_of(name):
    return f"<!-- {name} -->\n", f"<!-- end of {name} -->\n"


def section_of(page, name):
    """The part of a page between its marks; empty where it has none."""
    begin, end = marks_of(name)
    return page.split(begin, 1)[1].split(end, 1)[0] if begin in page else ""


def with_section(page, name, text):
    """The page with that text between these marks, at its end where it had none."""
    begin, end = marks_of(name)
    before, rest = page.split(begin, 1) if begin in page else (page + "\n", end)
    return before + begin + text + end + rest.split(end, 1)[1]
