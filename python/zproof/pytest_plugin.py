"""A gate in pytest: the fixture `zproof_gate` fails a test whose picture is not proven right.

    def test_my_renderer(zproof_gate):
        scene = zproof.load("model.glb")
        view = scene.views["cam"]
        ids, depths = my_renderer(scene, view)
        zproof_gate(scene, view, id=ids, depth=depths, precision="opengl")

pytest finds the fixture where zproof is installed. Elsewhere name it: `pytest -p zproof.pytest_plugin`.

The arguments are those of zproof.judge(), and `name`. The gate returns the verdict where it is proven.
Otherwise the test fails, and the message has the number of defects, their likely cause and the story of the
worst pixel. An undecidable pixel fails the test, too. A test may call the gate more than once; the first call
that is not proven ends it.

JUnit: `pytest --junitxml FILE` writes properties for each call:

    zproof.view           the view's name
    zproof.proven         true or false
    zproof.counts.CLASS   pixels of each class, as in Verdict.counts
    zproof.worst          x, y and class of the worst defect; absent where there is none
    zproof.sentence       one line: the worst defect, or what was proven
    zproof.report         the verdict's folder, below that of --zproof-report

The second call's begin with `zproof.2.`, and those of a call with name="back" with `zproof.back.`.

Report: `pytest --zproof-report DIR` writes DIR/report.html, DIR/results.json and DIR/junit.xml at the end of
the session, of all verdicts, proven ones too. Each verdict has its own folder DIR/NAME with its frames and
pictures. NAME is the test's: `tests/test_a.py::test_b[box]` becomes `tests.test_a.test_b_box`. A second call
in it adds `--2`, and one with name="back" adds `--back`. DIR must be new, empty, or of an earlier session.
Folders of tests that are not run again stay there, and are not in the new report. A verdict's folder is
written as soon as it is judged, and nothing of its arrays is kept.

The program zproof writes the report. It is looked for on PATH, or is the one that ZPROOF_PROGRAM names. Where
a report cannot be written, the session fails (exit status 1) and its summary says why.

pytest-xdist: each worker writes the folders of its own verdicts. The main process collects their lines and
writes the report. DIR must be a folder that all of them see.
"""

import collections
import contextlib
import hashlib
import os
import re
import subprocess

import pytest

from zproof.judging import failure_text, judge, summary

_MARK = ".zproof-pytest"  # in a folder that --zproof-report has made
_REPORTS = ("report.html", "results.json", "junit.xml")
_LONGEST_NAME = 100  # a file's name has at most 255 bytes, and the program adds to it
_LINES = pytest.StashKey[list]()  # of an item: what its verdicts leave
_NAMES = pytest.StashKey[dict]()  # of the session's configuration: {nodeid: name in the report}
_COLLECTOR = "zproof-collector"


def pytest_addoption(parser):
    group = parser.getgroup("zproof")
    group.addoption("--zproof-report", metavar="DIR", help="write a report of all verdicts into this folder")


def pytest_configure(config):
    folder = config.getoption("zproof_report")
    if folder is not None:
        folder = config.option.zproof_report = os.path.abspath(folder)
    if hasattr(config, "workerinput"):  # a worker of pytest-xdist: the main process collects
        return
    if folder is not None:
        _prepare(folder)
    config.pluginmanager.register(_Collector(folder), _COLLECTOR)


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config, items):
    """Workers of pytest-xdist collect the same tests, so that all find the same names."""
    config.stash[_NAMES] = names_of([item.nodeid for item in items])


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item, call):
    """A report travels from a worker to the main process, with what it holds."""
    outcome = yield
    if call.when == "teardown" and item.stash.get(_LINES, None):
        outcome.get_result().zproof_verdicts = item.stash[_LINES]


@pytest.fixture
def zproof_gate(request):
    """zproof_gate(scene, view, *, id=None, depth=None, precision, ids="triangle", name=None): the test fails
    unless the picture is proven right. The arguments are those of zproof.judge(). name: which of the test's
    pictures it is, in the report and in JUnit. Returns the verdict."""
    lines = request.node.stash.setdefault(_LINES, [])
    properties = request.node.user_properties
    del lines[:]  # of an earlier run of the same test, and below
    properties[:] = [(name, value) for name, value in properties if not name.startswith("zproof.")]
    config = request.config
    test_name = config.stash.get(_NAMES, {}).get(request.node.nodeid) or file_name(request.node.nodeid)
    return _Gate(test_name, config.getoption("zproof_report"), properties, lines)


class _Gate:
    """The callable of one test."""

    def __init__(self, test_name, folder, properties, lines):
        self._test_name, self._folder = test_name, folder
        self._properties, self._lines = properties, lines  # of JUnit; of the session
        self._labels = []

    def __repr__(self):
        return "<zproof_gate>"

    def __call__(self, scene, view, *, id=None, depth=None, precision, ids="triangle", name=None):
        __tracebackhide__ = True
        label = self._label(name)
        try:
            verdict = judge(scene, view, id=id, depth=depth, precision=precision, ids=ids)
        except (ValueError, TypeError) as error:
            raise error.with_traceback(None)  # the test's line is the place, and not the gate's
        self._record(verdict, label)
        if not verdict.proven:
            raise AssertionError(failure_text(verdict))
        return verdict

    def _label(self, name):
        """Tells the calls of a test apart: "", "2", "3" ... or the name."""
        number = len(self._labels) + 1
        wanted = ("" if number == 1 else str(number)) if name is None else file_name(str(name))
        label, again = wanted, 2
        while label in self._labels:
            label, again = f"{wanted or 'again'}.{again}", again + 1
        self._labels.append(label)
        return label

    def _record(self, verdict, label):
        folder_name = f"{self._test_name}--{label}" if label else self._test_name
        line = {"name": folder_name, "proven": verdict.proven, "error": ""}
        if self._folder is not None:
            line["error"] = _saved(verdict, folder_name, self._folder)
        prefix = f"zproof.{label}." if label else "zproof."
        self._properties += [(prefix + key, value) for key, value in _properties(verdict)]
        if self._folder is not None and not line["error"]:
            self._properties.append((prefix + "report", folder_name))
        self._lines.append(line)


def _properties(verdict):
    """(key, value) of JUnit."""
    yield "view", verdict.view.name
    yield "proven", str(verdict.proven).lower()
    for class_name, pixels in verdict.counts.items():
        yield f"counts.{class_name}", pixels
    worst = verdict.worst
    if worst is not None:
        yield "worst", f"{worst.x} {worst.y} {worst.class_name}"
    yield "sentence", verdict.sentence(worst) if worst is not None else summary(verdict)


def _saved(verdict, name, folder):
    """Writes folder/name. Returns what went wrong, in one line, or ""."""
    try:
        verdict.save(os.path.join(folder, name), name)
    except (RuntimeError, ValueError, OSError) as error:
        return f"{name}: {_one_line(error)}"
    return ""


def file_name(text):
    """Letters, digits, '-', '_', '.', without a run of '-', and not such as the program adds to."""
    name = re.sub(r"\.py(?=::|$)", "", text).replace("::", ".").replace("/", ".")
    name = re.sub(r"[^A-Za-z0-9_.-]+", "_", name)
    name = re.sub(r"-+", "-", name).strip("._-") or "test"
    if len(name) > _LONGEST_NAME:
        name = f"{name[:_LONGEST_NAME - 9].rstrip('._-')}_{_digest(text)}"
    return re.sub(r"-input$", "_input", name)


def names_of(nodeids):
    """{nodeid: file name}. Tests that would share one are told apart by a digest of their ids."""
    shared = collections.Counter(file_name(nodeid) for nodeid in set(nodeids))
    return {nodeid: file_name(nodeid) if shared[file_name(nodeid)] == 1
            else f"{file_name(nodeid)}-{_digest(nodeid)}" for nodeid in nodeids}


def _digest(text):
    return hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()[:8]


def _prepare(folder):
    """Before a test runs: can the report be written there? Ends pytest with one line where it cannot."""
    try:
        os.makedirs(folder, exist_ok=True)
        if os.listdir(folder) and not os.path.exists(os.path.join(folder, _MARK)):
            raise pytest.UsageError(f"--zproof-report {folder}: holds other files; expected a folder that is "
                                    "new, empty, or of an earlier --zproof-report")
        with open(os.path.join(folder, _MARK), "w", encoding="utf-8"):
            pass
        for file in _REPORTS:  # of an earlier session
            with contextlib.suppress(FileNotFoundError):
                os.remove(os.path.join(folder, file))
    except OSError as error:
        raise pytest.UsageError(f"--zproof-report {folder}: cannot be written: {error.strerror}") from None


class _Collector:
    """Of the main process: a line of each verdict, and at the end the report of all."""

    def __init__(self, folder):
        self._folder = folder
        self._lines = {}  # by name: a test that is run again has one place
        self._error = ""

    def pytest_runtest_logreport(self, report):
        for line in getattr(report, "zproof_verdicts", []):
            self._lines[line["name"]] = line

    @pytest.hookimpl(trylast=True)
    def pytest_sessionfinish(self, session):
        if self._folder is None or not self._lines:
            return
        self._error = self._write()
        if self._error and session.exitstatus == pytest.ExitCode.OK:
            session.exitstatus = pytest.ExitCode.TESTS_FAILED

    def _write(self):
        """The report of all that was saved. Returns what went wrong, in one line, or nothing."""
        saved = [line["name"] for line in self._lines.values() if not line["error"]]
        errors = [line["error"] for line in self._lines.values() if line["error"]]
        if saved:
            errors += filter(None, (_report(saved, file, self._folder) for file in _REPORTS))
        if not errors:
            return ""
        return errors[0] + (f" (and {len(errors) - 1} more)" if len(errors) > 1 else "")

    def pytest_terminal_summary(self, terminalreporter):
        if not self._lines and self._folder is None:
            return
        proven = sum(line["proven"] for line in self._lines.values())
        said = f"zproof: {proven} of {len(self._lines)} verdicts proven"
        if not self._lines:
            terminalreporter.write_line("zproof: no verdict, and no report")
        elif self._error:
            terminalreporter.write_line(said)
            terminalreporter.write_line(f"zproof: the report is not whole: {self._error}", red=True)
        elif self._folder is not None:
            terminalreporter.write_line(f"{said}; report: {os.path.join(self._folder, 'report.html')}")
        else:
            terminalreporter.write_line(said)


def _report(folders, file, home):
    """One report of many folders, below home. Returns what went wrong, in one line, or nothing."""
    program = os.environ.get("ZPROOF_PROGRAM") or "zproof"
    program = os.path.abspath(program) if os.sep in program else program
    try:
        done = subprocess.run([program, "report", *folders, "-o", file, "--quiet"], cwd=home,
                              capture_output=True, text=True, errors="replace", check=False)
    except OSError as error:
        return f"{program}: {error.strerror}"
    if done.returncode == 0:
        return ""
    return f"zproof report: exit status {done.returncode}: {_one_line(done.stderr or done.stdout)}"


def _one_line(message):
    return " ".join(str(message).split())
