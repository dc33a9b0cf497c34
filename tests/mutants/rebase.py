"""Finds the texts of a list of defects again after code has moved, was formatted or has other names, and
rewrites the list. A text without a certain place is named and left as it is."""
import difflib
import re
import subprocess

from planting import HERE, ROOT, Refusal, pattern_of, planted_text, read_catalogue

TOKEN = re.compile(r"(\w+|[^\w\s])(\s*)")
LINES_AROUND = 3
LEAST_LIKENESS = 0.5  # of a place's surroundings to those that the text had
LEAST_LEAD = 0.1      # over the next likely place


class Undecided(Exception):
    """Why a text has no certain place."""


def git(*words):
    done = subprocess.run(["git", "-C", str(ROOT), *words], capture_output=True, text=True, errors="replace")
    return done.stdout if done.returncode == 0 else ""


def tokens_of(text):
    return [token for token, _ in TOKEN.findall(text)]


def places_of(tokens, text):
    """Where the text has these tokens, however they are spaced."""
    pattern = "".join(re.escape(token) + (r"\s+" if re.match(r"\w+ \w", f"{token} {after}") else r"\s*")
                      for token, after in zip(tokens, [*tokens[1:], "."]))
    return [match.span() for match in re.finditer(pattern.removesuffix(r"\s*"), text)]


def surroundings(text, place):
    """The tokens of some lines before, of the text itself, and of some lines after."""
    begin, end = place
    return ([token for line in text[:begin].splitlines()[-LINES_AROUND:] for token in tokens_of(line)],
            tokens_of(text[begin:end]),
            [token for line in text[end:].splitlines()[:LINES_AROUND] for token in tokens_of(line)])


def last_seen(mutant):
    """The last commit at which the file had the text once, and its surroundings there."""
    for commit in ["HEAD", *git("log", "--format=%H %P", "HEAD", "--", mutant.file).split()]:
        text = git("show", f"{commit}:{mutant.file}")
        places = [match.span() for match in re.finditer(pattern_of(mutant.find), text)]
        if len(places) == 1:
            return commit, surroundings(text, places[0])
    raise Undecided("no commit has the text")


def name_now(file, commit):
    """What git takes for the same file."""
    for line in git("diff", "-M", "--diff-filter=R", "--name-status", commit).splitlines():
        _, before, now = line.split("\t")
        if before == file:
            return now
    return file


def line_of(text, place):
    return text.count("\n", 0, place[0]) + 1


def likeness(ours, theirs):
    matcher = difflib.SequenceMatcher(None, theirs, ours, autojunk=False)
    return matcher.ratio() if matcher.quick_ratio() >= LEAST_LIKENESS else 0


def likeliest(rated):
    """Of (likeness, file, line, what is found), with a clear lead."""
    rated = sorted(rated, key=lambda row: row[0], reverse=True)
    best = next(iter(rated), (0,))
    if best[0] < LEAST_LIKENESS:
        raise Undecided("no place is like the one that it had")
    rival = next((row for row in rated if row[1] != best[1] or abs(row[2] - best[2]) > LINES_AROUND), (0,))
    if best[0] - rival[0] < LEAST_LEAD:
        raise Undecided(f"{best[1]}:{best[2]} and {rival[1]}:{rival[2]} are as likely")
    return best[1], best[3]


def same_tokens(old, texts, preferred):
    """The text as it stands now, where its tokens are the same; empty where they are nowhere."""
    rated = []
    for name, text in texts.items():
        places = places_of(old[1], text)
        if name == preferred and len(places) == 1:
            return name, text[slice(*places[0])]
        for place in places:
            alike = likeness(sum(old, []), sum(surroundings(text, place), []))
            rated.append((alike, name, line_of(text, place), text[slice(*place)]))
    return likeliest(rated) if rated else ("", "")


def between_the_same(old, text):
    """What stands where the text stood: between the tokens before it and those after it."""
    before, inside, _ = old
    theirs = list(TOKEN.finditer(text))
    matcher = difflib.SequenceMatcher(None, sum(old, []), [token[1] for token in theirs], autojunk=False)
    place = {ours + i: their + i for ours, their, size in matcher.get_matching_blocks() for i in range(size)}
    first, last = place.get(len(before) - 1), place.get(len(before) + len(inside))
    if first is None or last is None:
        raise Undecided("its place has no clear bounds")
    return text[theirs[first].end():theirs[last].start()].strip()


def other_tokens(old, texts):
    """The text of the place whose surroundings are likeliest."""
    ours, rated = sum(old, []), []
    for name, text in texts.items():
        lines = text.splitlines()
        tokens = [tokens_of(line) for line in lines]
        for at in range(len(lines)):
            window, end = list(tokens[at]), at + 1
            while end < len(lines) and len(window) < len(ours):
                window += tokens[end]
                end += 1
            whole = "\n".join(lines[max(0, at - LINES_AROUND):end + LINES_AROUND])
            rated.append((likeness(ours, window), name, at + 1, whole))
    name, window = likeliest(rated)
    return name, between_the_same(old, window)


def renamed(old, new):
    """Which tokens are called what; other changes of a text are for people to judge."""
    names = dict(zip(old, new))
    if len(old) != len(new) or [names[token] for token in old] != new or any(
            not (token[0].isalpha() and name[0].isalpha()) for token, name in names.items() if token != name):
        raise Undecided(f"its words have changed: {' '.join(new)}")
    return names


def spaced_alike(put, old, new):
    """The replacement, with the names and spaces that have changed between the old text and the new."""
    names = renamed(tokens_of(old), tokens_of(new))

    def spaces(text):
        found = TOKEN.findall(text)
        return {(names.get(token, token), names.get(after, after)): bool(space)
                for (token, space), (after, _) in zip(found, found[1:])}

    changed = dict(spaces(new).items() - spaces(old).items())
    tokens = [(names.get(token, token), bool(space)) for token, space in TOKEN.findall(put)] + [("", False)]
    return "".join(token + " " * changed.get((token, after), space)
                   for (token, space), (after, _) in zip(tokens, tokens[1:]))


def found_again(mutant, texts):
    commit, old = last_seen(mutant)
    name, text = same_tokens(old, texts, name_now(mutant.file, commit))
    if not name:
        name, text = other_tokens(old, texts)
    find = " ".join(text.split())
    moved = mutant._replace(file=name, find=find, put=spaced_alike(mutant.put, mutant.find, find))
    planted_text(moved)
    return moved


def rewritten(text, mutant, moved):
    """The list with that defect's lines changed."""
    head, rest = text.split(f"\nname: {mutant.name}\n")
    block, *others = rest.split("\n\n", 1)
    for key in ("file", "find", "put"):
        block = re.sub(rf"(?m)^({key}: *).*$", lambda line: line[1] + getattr(moved, key), block)
    return "\n\n".join([f"{head}\nname: {mutant.name}\n{block}", *others])


def rebase(name, *folders):
    """Looks below these folders and prints what it changes. 3 where a text has no certain place."""
    listed = git("ls-files", "--cached", "--others", "--exclude-standard", *folders).splitlines()
    texts = {file: (ROOT / file).read_text() for file in sorted(listed)
             if file.endswith((".h", ".cpp", ".inl")) and (ROOT / file).is_file()}
    status = 0
    for mutant in read_catalogue(name):
        try:
            planted_text(mutant)
            continue
        except Refusal:
            pass
        try:
            moved = found_again(mutant, texts)
        except (Undecided, Refusal) as why:
            print(f"{mutant.name}: undecided, {why}")
            status = 3
            continue
        (HERE / name).write_text(rewritten((HERE / name).read_text(), mutant, moved))
        for key, before, now in zip(mutant._fields, mutant, moved):
            if before != now:
                print(f"{mutant.name}: {key}: {before} -> {now}")
    return status
