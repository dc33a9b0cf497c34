"""The pytest plugin, as a user meets it: pytest runs small test files in a Python of its own."""

import json
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

import pytest

from zproof.pytest_plugin import file_name, names_of

HERE = Path(__file__).parent

PICTURES = """
import pytest
from small_scenes import PRECISION, layers, traced, view

def picture(wrong=()):
    scene, seen_from = layers(), view()
    ids, depths = traced(scene, seen_from)
    for x, y in wrong:
        ids[y, x] = 2
    return {"scene": scene, "view": seen_from, "id": ids, "depth": depths, "precision": PRECISION}
"""
GOOD = "def test_good(zproof_gate):\n    assert zproof_gate(**picture()).proven\n"
BAD = "def test_bad(zproof_gate):\n    zproof_gate(**picture(wrong=[(36, 28)]))\n"


class Ran:
    """What pytest did with a test file."""

    def __init__(self, folder, tests, *options, plugin=("-p", "zproof.pytest_plugin"), paths=(),
                 **environment):
        (folder / "picture_test.py").write_text(PICTURES + tests)
        path = os.pathsep.join([str(p) for p in paths] + [str(HERE), *sys.path])
        settings = {"PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1", "ZPROOF_ORACLE": "none", "PYTHONPATH": path,
                    **environment}
        done = subprocess.run([sys.executable, "-m", "pytest", *plugin, "-p", "no:cacheprovider", "-W",
                               "error",
                               "picture_test.py", *options], cwd=folder, capture_output=True, text=True,
                              check=False,
                              env={**os.environ, **settings})
        self.status, self.said = done.returncode, done.stdout + done.stderr
        self.lines = [line for line in self.said.splitlines() if line.startswith("zproof: ")]


def views(folder):
    """(scene, outcome) of a report."""
    return [(v["scene"], v["outcome"]) for v in json.loads((folder / "results.json").read_text())["views"]]


def properties(file):
    """{test: {property: value}} of a file of JUnit."""
    return {case.get("name"): {p.get("name"): p.get("value") for p in case.iter("property")}
            for case in xml.parse(file).iter("testcase")}


def test_a_picture_that_is_proven_passes(tmp_path):
    ran = Ran(tmp_path, GOOD)
    assert ran.status == 0, ran.said
    assert ran.lines == ["zproof: 1 of 1 verdicts proven"]
    assert [f.name for f in tmp_path.iterdir() if f.name != "__pycache__"] == ["picture_test.py"]


def test_a_picture_that_is_wrong_fails_with_its_story(tmp_path):
    ran = Ran(tmp_path, GOOD + BAD)
    assert ran.status == 1
    assert "AssertionError: view: 1 of 3,072 pixels are defects: 1 hidden" in ran.said
    assert "pixel (36, 28): hidden, FAIL" in ran.said
    assert "no cause is certain" in ran.said, "the diagnosis"
    assert ran.lines == ["zproof: 1 of 2 verdicts proven"]


def test_the_traceback_is_of_the_test_alone(tmp_path):
    ran = Ran(tmp_path, """
DEEPER = picture()["depth"] + 1

@pytest.mark.parametrize("wrong", [{"depth": DEEPER}, {"precision": "nonsense"}, {"scene": None}])
def test_bad(zproof_gate, wrong):
    zproof_gate(**{**picture(), **wrong})
""")
    places = re.findall(r"^(\S+.py):\d+: (\w+)$", ran.said, re.M)
    errors = ["AssertionError", "InputError", "TypeError"]
    assert places == [("picture_test.py", error) for error in errors], ran.said
    assert ran.said.count(">       zproof_gate(") + ran.said.count(">   zproof_gate(") == 3
    assert "pytest_plugin.py" not in ran.said and "judging.py" not in ran.said


def test_an_undecidable_picture_fails(tmp_path):
    undecided = """
import zproof.pytest_plugin as plugin

class Undecided:
    proven, defects, worst, diagnosis = False, 0, None, None
    def __init__(self, verdict):
        self.view, self.classes, self.explain = verdict.view, verdict.classes, verdict.explain
        self.counts = {**verdict.counts, "undecidable": 1}
        self.findings = verdict.findings

def test_undecided(zproof_gate, monkeypatch):
    judge = plugin.judge
    monkeypatch.setattr(plugin, "judge", lambda *a, **k: Undecided(judge(*a, **k)))
    zproof_gate(**picture())
"""
    ran = Ran(tmp_path, undecided, "--junitxml", "junit.xml")
    assert ran.status == 1 and "view: undecided, 1 of 3,072 pixels" in ran.said
    assert ran.lines == ["zproof: 0 of 1 verdicts proven"]
    assert properties(tmp_path / "junit.xml")["test_undecided"]["zproof.proven"] == "false"


def test_a_session_without_a_gate_is_not_spoken_to(tmp_path):
    ran = Ran(tmp_path, "def test_other():\n    pass\n")
    assert ran.status == 0 and ran.lines == []


# ---- report ----


CALLS = """
@pytest.mark.parametrize("side", ["a/b", "a b"])
def test_sides(zproof_gate, side):
    zproof_gate(**picture())
    zproof_gate(**picture())
    zproof_gate(**picture(), name="back")
    zproof_gate(**picture(), name="back")

class TestInside:
    def test_good(self, zproof_gate):
        zproof_gate(**picture())
"""


def test_a_report_has_every_verdict(tmp_path):
    ran = Ran(tmp_path, GOOD + BAD, "--zproof-report", "out")
    assert ran.status == 1
    assert ran.lines == [f"zproof: 1 of 2 verdicts proven; report: {tmp_path}/out/report.html"]
    assert views(tmp_path / "out") == [("picture_test.test_good", "proven"),
                                       ("picture_test.test_bad", "defective")]
    page = (tmp_path / "out/report.html").read_text()
    assert "picture_test.test_good" in page and "picture_test.test_bad" in page
    assert (tmp_path / "out/picture_test.test_bad/scenes/picture_test.test_bad-view/view.webp").exists()
    assert len(list(xml.parse(tmp_path / "out/junit.xml").iter("testcase"))) == 2


def test_every_call_of_every_test_has_its_own_name(tmp_path):
    ran = Ran(tmp_path, CALLS, "--zproof-report", "out", "--junitxml", "junit.xml")
    assert ran.status == 0, ran.said
    names = [scene for scene, _ in views(tmp_path / "out")]
    assert len(set(names)) == len(names) == 9
    assert all(re.fullmatch(r"[A-Za-z0-9_.-]+", name) for name in names)
    assert names[:4] == ["picture_test.test_sides_a.b" + end for end in ("", "--2", "--back", "--back.2")]
    assert names[-1] == "picture_test.TestInside.test_good"
    said = properties(tmp_path / "junit.xml")
    assert {v for test in said.values() for k,
            v in test.items() if k.endswith(".report") or k == "zproof.report"} == set(names)
    assert {k for k in said["test_sides[a b]"] if k.endswith("proven")} == {
        "zproof.proven", "zproof.2.proven", "zproof.back.proven", "zproof.back.2.proven"}


def test_a_later_session_replaces_the_report(tmp_path):
    assert Ran(tmp_path, GOOD + BAD, "--zproof-report", "out").status == 1
    assert Ran(tmp_path, GOOD, "--zproof-report", "out").status == 0
    assert views(tmp_path / "out") == [("picture_test.test_good", "proven")]
    ran = Ran(tmp_path, GOOD, "--zproof-report", "out", "-k", "nothing")
    assert ran.lines == ["zproof: no verdict, and no report"]
    assert not (tmp_path / "out/report.html").exists(), "an old report looks like this session's"


def test_verdicts_outside_of_the_call_are_in_the_report(tmp_path):
    tests = """
@pytest.fixture
def judged_before(zproof_gate):
    zproof_gate(**picture(), name="before")
    yield
    zproof_gate(**picture(wrong=[(36, 28)]), name="after")

def test_between(judged_before):
    pass
"""
    ran = Ran(tmp_path, tests, "--zproof-report", "out")
    assert ran.status == 1 and "ERROR at teardown" in ran.said
    assert views(tmp_path / "out") == [("picture_test.test_between--before", "proven"),
                                       ("picture_test.test_between--after", "defective")]


def cannot_be_written(folder, out):
    ran = Ran(folder, GOOD, "--zproof-report", out)
    assert ran.status == 4, ran.said
    [line] = [line for line in ran.said.splitlines() if "--zproof-report" in line]
    assert line.startswith("ERROR: --zproof-report ") and "Traceback" not in ran.said
    assert "passed" not in ran.said, "no test runs for a report that nobody gets"
    return line


def test_a_folder_that_cannot_be_made_ends_the_session_with_one_line(tmp_path):
    (tmp_path / "file").write_text("dear")
    assert "cannot be written: Not a directory" in cannot_be_written(tmp_path, "file/out")
    assert "cannot be written: File exists" in cannot_be_written(tmp_path, "file")
    assert "cannot be written" in cannot_be_written(tmp_path, "/proc/out")


def test_a_folder_of_others_is_left_alone(tmp_path):
    (tmp_path / "site").mkdir()
    (tmp_path / "site/report.html").write_text("dear")
    assert "holds other files" in cannot_be_written(tmp_path, "site")
    assert (tmp_path / "site/report.html").read_text() == "dear"
    (tmp_path / "empty").mkdir()
    assert Ran(tmp_path, GOOD, "--zproof-report", "empty").status == 0


@pytest.mark.parametrize("program, words", [("/nowhere/zproof", "/nowhere/zproof"),
                                            ("/bin/false", "exit status 1")])
def test_a_program_that_writes_no_report_fails_the_session(tmp_path, program, words):
    ran = Ran(tmp_path, GOOD, "--zproof-report", "out", ZPROOF_PROGRAM=program)
    assert "1 passed" in ran.said and ran.status == 1
    assert len(ran.lines) == 2
    assert ran.lines[1].startswith("zproof: the report is not whole: picture_test.test_good: ")
    assert words in ran.lines[1] and "Traceback" not in ran.said


def test_a_report_that_fails_at_the_end_fails_the_session(tmp_path):
    tests = GOOD + """
def test_last():
    import os
    os.mkdir("out/report.html")
    open("out/report.html/file", "w").close()
"""
    ran = Ran(tmp_path, tests, "--zproof-report", "out")
    assert "2 passed" in ran.said and ran.status == 1
    assert "zproof: the report is not whole: zproof report: exit status" in ran.lines[1]


def test_one_verdict_that_cannot_be_saved_leaves_the_others(tmp_path):
    tests = """
def test_first(zproof_gate):
    import os
    os.mkdir("out/picture_test.test_second")
    open("out/picture_test.test_second/letter", "w").close()
    zproof_gate(**picture())

def test_second(zproof_gate):
    zproof_gate(**picture())

def test_third(zproof_gate):
    zproof_gate(**picture())
"""
    ran = Ran(tmp_path, tests, "--zproof-report", "out")
    assert ran.status == 1 and "3 passed" in ran.said
    assert "picture_test.test_second: " in ran.lines[1] and "was not made by zproof" in ran.lines[1]
    names = [scene for scene, _ in views(tmp_path / "out")]
    assert names == ["picture_test.test_first", "picture_test.test_third"]
    assert (tmp_path / "out/picture_test.test_second/letter").exists()


# ---- JUnit ----


def test_junit_has_what_the_verdict_says(tmp_path):
    Ran(tmp_path, GOOD + BAD, "--junitxml", "junit.xml")
    said = properties(tmp_path / "junit.xml")
    good, bad = said["test_good"], said["test_bad"]
    assert good["zproof.view"] == bad["zproof.view"] == "view"
    assert (good["zproof.proven"], bad["zproof.proven"]) == ("true", "false")
    assert (good["zproof.counts.agree"], good["zproof.counts.hidden"]) == ("3072", "0")
    assert (bad["zproof.counts.agree"], bad["zproof.counts.hidden"]) == ("3071", "1")
    assert "zproof.worst" not in good and bad["zproof.worst"] == "36 28 hidden"
    assert good["zproof.sentence"] == "view: proven, 3,072 pixels"
    assert bad["zproof.sentence"].startswith("candidate says triangle 2")
    assert not any(name.endswith("report") for name in (*good, *bad)), "no report was asked for"


# ---- names, memory, entry point ----


def test_names_of_files():
    assert file_name("tests/test_a.py::test_b[box]") == "tests.test_a.test_b_box"
    assert file_name("a.py::TestC::test_d") == "a.TestC.test_d"
    for nodeid in ("../..", "::", "", ".hidden", "a.py::t[\u00e9\U0001f600]", "a.py::t[x-input]",
                   "a.py::t[--x--]", "a" * 999,
                   "a.py::t[\n\0]", "a.py::t[\ud800]", "-x", "a.py::t[" + "é" * 500 + "]"):
        name = file_name(nodeid)
        assert re.fullmatch(r"[A-Za-z0-9_][A-Za-z0-9_.-]*", name) and len(name) <= 100, nodeid
        assert "--" not in name and not name.endswith(("-input", "-", ".")), nodeid


def test_no_two_tests_share_a_name():
    nodeids = ["a.py::t[x/y]", "a.py::t[x.y]", "a/b.py::t", "a.b.py::t", "b.py::u", "c" * 200 + "1",
               "c" * 200 + "2"]
    names = names_of(nodeids)
    assert len(set(names.values())) == len(nodeids)
    assert names["b.py::u"] == "b.u"
    assert names_of(nodeids[::-1]) == names, "the order does not matter"


def test_nothing_of_the_arrays_is_kept(tmp_path):
    tests = """
import gc, weakref
kept = []

@pytest.mark.parametrize("i", range(2))
def test_one(zproof_gate, i):
    given = picture()
    kept.append(weakref.ref(given["id"]))
    zproof_gate(**given)

def test_gone():
    gc.collect()
    assert len(kept) == 2 and [k() for k in kept] == [None] * 2
"""
    ran = Ran(tmp_path, tests, "--zproof-report", "out")
    assert ran.status == 0, ran.said


def test_a_test_that_runs_again_has_one_place(tmp_path):
    again = """
def pytest_runtest_protocol(item, nextitem):
    from _pytest.runner import runtestprotocol
    for _ in range(2):
        for report in runtestprotocol(item, nextitem=nextitem, log=False):
            item.ihook.pytest_runtest_logreport(report=report)
    return True
"""
    (tmp_path / "conftest.py").write_text(again)
    ran = Ran(tmp_path, GOOD, "--zproof-report", "out", "--junitxml", "junit.xml")
    assert ran.status == 0, ran.said
    assert views(tmp_path / "out") == [("picture_test.test_good", "proven")]
    for case in xml.parse(tmp_path / "junit.xml").iter("testcase"):
        names = [p.get("name") for p in case.iter("property")]
        assert len(set(names)) == len(names), "a property of the earlier run"


def test_a_worker_hands_its_lines_to_the_main_process(tmp_path):
    """As pytest-xdist does it: reports travel as JSON, and the worker writes no report of all."""
    (tmp_path / "conftest.py").write_text("""
import json
def pytest_configure(config):
    config.pluginmanager.unregister(name="zproof-collector")
def pytest_runtest_logreport(report):
    with open("reports", "a") as file:
        print(json.dumps(report._to_json()), file=file)
""")
    (tmp_path / "early.py").write_text("def pytest_load_initial_conftests(early_config):\n"
                                       "    early_config.workerinput = {}\n")
    ran = Ran(tmp_path, GOOD + BAD, "-p", "early", "--zproof-report", "out", paths=[tmp_path])
    assert ran.status == 1 and ran.lines == [] and not (tmp_path / "out/.zproof-pytest").exists()
    assert (tmp_path / "out/picture_test.test_bad/report.html").exists()
    from _pytest.reports import TestReport
    from zproof.pytest_plugin import _Collector
    collector = _Collector(str(tmp_path / "out"))
    for line in (tmp_path / "reports").read_text().splitlines():
        collector.pytest_runtest_logreport(TestReport._from_json(json.loads(line)))
    assert collector._write() == ""
    assert views(tmp_path / "out") == [("picture_test.test_good", "proven"),
                                       ("picture_test.test_bad", "defective")]


@pytest.mark.parametrize("named", [(), ("-p", "zproof.pytest_plugin")])
def test_an_installed_zproof_is_found_by_pytest(tmp_path, named):
    written = HERE.parent / "dist-info"
    installed = tmp_path / "site/zproof-1.2.3.dist-info"
    installed.mkdir(parents=True)
    (installed / "entry_points.txt").write_text((written / "entry_points.txt").read_text())
    metadata = (written / "METADATA.in").read_text().replace("@PROJECT_VERSION@", "1.2.3")
    (installed / "METADATA").write_text(metadata)
    ran = Ran(tmp_path, GOOD, plugin=named, paths=[tmp_path / "site"], PYTEST_DISABLE_PLUGIN_AUTOLOAD="")
    assert ran.status == 0 and "zproof-1.2.3" in ran.said, ran.said
    assert ran.lines == ["zproof: 1 of 1 verdicts proven"]


def test_the_reports_commands_can_be_repeated_where_it_was_moved(tmp_path, program):
    """The page of zproof run, whose paths are relative."""
    ran = Ran(tmp_path, GOOD + BAD, "--zproof-report", "out")
    assert ran.status == 1
    moved = (tmp_path / "out").rename(tmp_path / "moved")
    for file in ("report.html", "results.json"):
        assert str(tmp_path) not in (moved / file).read_text(), file
    bad = json.loads((moved / "results.json").read_text())["views"][1]
    command = bad["worst"][0]["command"]
    name = "picture_test.test_bad"
    assert command.startswith(f"zproof explain {name}-input/{name}.view.json 36 28 ")
    words = [program, *command.split()[1:]]
    told = subprocess.run(words, cwd=moved, capture_output=True, text=True, check=False)
    assert told.returncode == 1 and "pixel (36, 28): hidden, FAIL" in told.stdout, told.stdout + told.stderr
