"""What the programs that judge a renderer with a defect have in common: a trial's lines, and what they say."""
import json
import subprocess

SIZES = [(480, 270), (1920, 1080)]


def lines_of(words, limit_s=1200):
    """The trial's lines; the last says how it ended where it did not end well."""
    try:
        done = subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=limit_s)
    except subprocess.TimeoutExpired:
        return [{"ending": "does not end"}]
    lines = [json.loads(line) for line in done.stdout.splitlines()]
    return lines if done.returncode == 0 else [*lines, {"ending": f"ends with status {done.returncode}"}]


def first_defect(lines):
    """The line that the gate fails at: a view with a defect, or a program that did not end well."""
    return next((line for line in lines if line.get("defects", 0) > 0 or "ending" in line), None)


def class_of(line):
    """The failing class that most pixels got."""
    if "ending" in line:
        return line["ending"]
    failing = {c: n for c, n in line["counts"].items() if c != "reference_wrong"}
    return max(failing, key=failing.get)


def try_sizes(try_suite):
    """The first size at which the gate fails, and the line that it fails at; the last size and nothing else."""
    for size in SIZES:
        line = first_defect(try_suite(size))
        if line:
            break
    return size, line


def tell(mutant, size, line):
    if line:
        said = f"caught    {mutant.name:36} {class_of(line):12} {line.get('name', '')} at {size[0]}"
    else:
        said = f"SURVIVED  {mutant.name:36} {mutant.survives}"
    unexpected = "" if bool(line) != bool(mutant.survives) else "   <- not what the catalogue says"
    print(said + unexpected, flush=True)
