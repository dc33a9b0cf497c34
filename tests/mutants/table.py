"""The page docs/detection-tables.md and the rows beside it, from what was measured of each defect."""
import collections
import csv
import pathlib

RIVALS = {"idiff": "`idiff`", "idiff_blender": "`idiff`, Blender's settings", "fuzzy": "fuzzy 3 x 3",
          "pytorch3d": "PyTorch3D's rule"}

HEAD = """# Detection, row by row

One row per defect of [detection.md](detection.md), and their sums. `tests/mutants/score --table
docs/detection-tables.md` writes this page and the first two tables, `score_plain --table` and `score_judge
--table` the last two sections and tables:

| table | what was changed |
|---|---|
| [detection-planted.csv](detection-planted.csv) | a line of the rasterizer |
| [detection-injected.csv](detection-injected.csv) | a good frame |
| [detection-plain.csv](detection-plain.csv) | a line of a renderer that is not ours |
| [detection-judge.csv](detection-judge.csv) | a line of the judge |

`share`: percent of the wrong pixels that the named cause explains. `expected`: the cause that should have been
named, where another was. `x`: this rival catches it, too; `?`: it was not asked.

"""


def read_causes():
    lines = (pathlib.Path(__file__).parent / "causes.txt").read_text().splitlines()
    return dict(line.split(": ", 1) for line in lines if line and not line.startswith("#"))


CAUSES = read_causes()


def dominant_class(line):
    failing = {c: n for c, n in line.get("counts", {}).items() if c != "reference_wrong"}
    return max(failing, key=failing.get) if failing else "-"


def cause_cells(line):
    """The named cause, and the percentage that it explains."""
    cause = (line or {}).get("cause", "-")
    return ["", ""] if cause == "-" else [cause, f"{100 * line['share']:.0f}"]


def expected_cell(name, line):
    return "" if name not in CAUSES or is_named(name, line) else CAUSES[name]


def is_named(name, line):
    return (line or {}).get("cause", "-").startswith(CAUSES[name])


def marks(alarms):
    """`?` where the rivals were not asked."""
    return ["?" if alarms is None else "x" if rival in alarms else "" for rival in RIVALS]


def table(head, rows):
    return "\n".join(["| " + " | ".join(head) + " |", "|" + "---|" * len(head), *rows]) + "\n"


def yes_or_no(is_so):
    return "yes" if is_so else "no"


def write_rows(page, name, columns, rows):
    """Beside the page: detection-NAME.csv."""
    with page.with_name(f"detection-{name}.csv").open("w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([columns, *rows])


JUDGED = ["class", "cause", "share", "expected", *RIVALS]
INJECTED_COLUMNS = ["defect", "what", "caught", *JUDGED]
PLANTED_COLUMNS = ["area", "defect", "what", "caught", "width", *JUDGED]
PLAIN_COLUMNS = ["area", "defect", "what", "mode", "caught", "width", "view", "class", "cause", "share",
                 "named", "survives"]
JUDGE_COLUMNS = ["area", "defect", "what", "killed by", "survives"]


def fault_row(line):
    found = "refused" if line["said"] == "refused" else dominant_class(line)
    return [line["name"], line["sentence"], yes_or_no(line["as_expected"]), found, *cause_cells(line),
            expected_cell(line["name"], line), *marks(line["alarms"])]


def mutant_row(row):
    line, mutant = row["line"], row["mutant"]
    found = line.get("ending") or dominant_class(line) if line else ""
    return [mutant.area, mutant.name, mutant.sentence, yes_or_no(line), row["size"][0], found,
            *cause_cells(line), expected_cell(mutant.name, line), *marks(row["alarms"])]


def share(part, whole):
    return f"{part} of {whole}"


def caught_by(rival, rows):
    asked = [row["alarms"] for row in rows if row["alarms"] is not None]
    return share(sum(rival in alarms for alarms in asked), len(asked))


def summary(rows, faults, false_alarms):
    views = false_alarms[(480, 270)]
    caught_faults = sum(line["as_expected"] for line in faults)
    caught_rows = sum(row["line"] is not None for row in rows)
    lines = [f"| **zproof** | {share(caught_faults, len(faults))} | {share(caught_rows, len(rows))} | "
             f"{share(0, len(views))} |"]
    for rival, name in RIVALS.items():
        alarms = sum(rival in alarms for alarms in views.values())
        lines.append(f"| {name} | {caught_by(rival, faults)} | {caught_by(rival, rows)} | {share(alarms, len(views))} |")
    return table(["", "injected faults caught", "planted defects caught", "false alarms on the clean suite, views"], lines)


def diagnosis_line(rows, faults):
    asked = [(line["name"], line) for line in faults] + [(row["mutant"].name, row["line"]) for row in rows]
    covered = [(name, line) for name, line in asked if name in CAUSES]
    named = sum(is_named(name, line) for name, line in covered)
    return (f"\nOf {len(covered)} defects that one of the diagnosis's hypotheses describes, it names {named} "
            f"({100 * named / max(1, len(covered)):.0f} %).\n")


def write_page(file, rows, lines, false_alarms, catalogue_size):
    """Both tables, too. Returns the page's text: sections of other programs follow."""
    faults = [line for line in lines if not line["control"]]
    controls = [line for line in lines if line["control"]]
    text = HEAD
    if len(rows) < catalogue_size:
        text += (f"**Not complete:** {len(rows)} of the {catalogue_size} planted defects were judged for this page; nothing "
                 "is said of the others.\n\n")
    if not any("cause" in line for line in lines):
        text += "**Not complete:** the diagnosis was not asked.\n\n"
    text += summary(rows, faults, false_alarms) + diagnosis_line(rows, faults)
    text += (f"\nOf {len(controls)} good frames among the injected faults (`selftest/clean_frames.cpp`) the gate passes "
             f"{sum(line['as_expected'] for line in controls)}.\n")
    write_rows(file, "planted", PLANTED_COLUMNS, [mutant_row(row) for row in rows])
    write_rows(file, "injected", INJECTED_COLUMNS, [fault_row(line) for line in faults])
    return text


def is_one_of(cause, names):
    return any(name and cause.startswith(name) for name in names.split("|"))


def named_as(mutant, line):
    """What the named cause is worth. One that nobody foresaw for the defect is wrong."""
    cause = line.get("cause")
    if cause is None:
        return "none"
    if is_one_of(cause, mutant.cause):
        return "right"
    return "symptom" if is_one_of(cause, mutant.symptom) else "wrong"


def plain_row(row):
    line, mutant = row["line"], row["mutant"]
    head = [mutant.area, mutant.name, mutant.sentence, mutant.mode, yes_or_no(line), row["size"][0]]
    if not line:
        return [*head, "", "", "", "", "", mutant.survives or "nobody knows why"]
    return [*head, line.get("name", ""), line.get("ending") or dominant_class(line), *cause_cells(line),
            named_as(mutant, line), ""]


def by_mode(rows):
    modes = collections.OrderedDict()
    for row in rows:
        modes.setdefault(row["mutant"].mode, []).append(row)
    return table(["mode", "defects", "caught"],
                 [f"| `{mode}` | {len(of_mode)} | {sum(row['line'] is not None for row in of_mode)} |"
                  for mode, of_mode in modes.items()])


def plain_sums(rows):
    """How many are caught, and what the named causes are worth."""
    caught = [row for row in rows if row["line"]]
    reasons = collections.Counter(row["mutant"].survives.split(":")[0] for row in rows if not row["line"])
    worth = collections.Counter((bool(row["mutant"].cause), named_as(row["mutant"], row["line"])) for row in caught)
    words = ("right", "symptom", "wrong", "none")
    sums = {word: worth[True, word] + worth[False, word] for word in words}
    named = sums["right"] + sums["symptom"] + sums["wrong"]
    lines = [f"{share(len(caught), len(rows))} are caught."]
    lines += [f"Of those that survive, {count}: {reason or 'nobody knows why'}." for reason, count in sorted(reasons.items())]
    for has, whose in ((True, "A hypothesis describes"), (False, "No hypothesis describes")):
        told = ", ".join(f"{worth[has, word]} {word}" for word in words)
        lines.append(f"{whose} {sum(worth[has, word] for word in words)} of the caught: {told}.")
    lines.append(f"Of the {named} causes that it names, {sums['right']} are right, {sums['symptom']} are true of the frame "
                 f"and do not say why, and {sums['wrong']} are wrong ({100 * sums['wrong'] / max(1, named):.0f} %).")
    return "\n".join(lines) + "\n"


def write_plain_rows(file, rows):
    write_rows(file, "plain", PLAIN_COLUMNS, [plain_row(row) for row in rows])


def plain_section(rows, catalogue_size):
    text = ("## A renderer that is not ours\n\n"
            f"{len(rows)} defects of `tests/mutants/plain.txt` are planted into `tests/mutants/plain/`, one at a time.\n")
    if len(rows) < catalogue_size:
        text += f"**Not complete:** nothing is said of the {catalogue_size - len(rows)} others.\n"
    return text + plain_sums(rows) + "\n" + by_mode(rows)


def write_judge_rows(file, rows):
    write_rows(file, "judge", JUDGE_COLUMNS,
               [[mutant.area, mutant.name, mutant.sentence, killer,
                 "" if killer else mutant.survives or "nobody knows why"] for mutant, killer in rows])
