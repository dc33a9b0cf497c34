"""Verdicts: those of the program on the same arrays, with every class of defect planted."""

import csv
import html
import json
import subprocess
import sys
import threading

import numpy as np
import pytest

import zproof
from small_scenes import HEIGHT, PRECISION, WIDTH, layers, random_mesh, traced, view
from zproof import _zproof
from zproof.judging import failure_text, precision_word, story_of_worst, summary

BACKGROUND = zproof.BACKGROUND_ID
FRONT, SKY = (36, 28), (0, 0)  # (x, y) of a pixel of the front square, and of one that shows nothing


def planted(*answers, scene=None, **options):
    """The verdict of a right frame in which the pixels (x, y) of `answers` say (id, depth) instead."""
    scene, seen_from = scene or layers(), view()
    ids, depths = traced(scene, seen_from)
    for (x, y), i, depth in answers:
        ids[y, x] = ids[y, x] if i is None else i
        depths[y, x] = depths[y, x] if depth is None else depth
    return zproof.judge(scene, seen_from, id=ids, depth=depths, precision=PRECISION, **options)


def bits(findings):
    """Of every column; between them lies what is no value."""
    return b"".join(findings[name].tobytes() for name in findings.dtype.names)


def nonzero(counts):
    return {name: count for name, count in counts.items() if count}


# ---- classes ----


@pytest.mark.parametrize("answer, expected", [
    ((FRONT, None, 2.9), "wrong_depth"), ((FRONT, BACKGROUND, np.inf), "hole"), ((SKY, 0, 3), "outside"),
    ((FRONT, 2, 4), "hidden"), ((FRONT, 4, 3), "invalid"), ((FRONT, None, np.nan), "invalid"),
    ((SKY, BACKGROUND, 3), "invalid"), ((SKY, BACKGROUND, -np.inf), "invalid")])
def test_a_planted_defect_is_found_and_named(answer, expected):
    assert planted().proven and planted().worst is None and planted().diagnosis is None
    verdict = planted(answer)
    (x, y), i, depth = answer
    assert not verdict.proven and not verdict and verdict.defects == 1
    assert nonzero(verdict.counts) == {"agree": WIDTH * HEIGHT - 1, expected: 1}
    number = zproof.CLASS_NAMES.index(expected)
    assert verdict.classes[y, x] == number and np.count_nonzero(verdict.classes == number) == 1
    found = verdict.findings[0]
    assert (found["x"], found["y"], found["class"]) == (x, y, number)
    assert found["id"] == (verdict.reference.id[y, x] if i is None else i)
    assert found["reference_id"] == verdict.reference.id[y, x]
    said = verdict.reference.depth[y, x] if depth is None else np.float32(depth)
    assert np.array_equal(found["depth"], said, equal_nan=True)
    worst = verdict.worst
    assert (worst.x, worst.y, worst.class_name) == (x, y, expected)
    assert expected in verdict.explain(x, y).text and f"({x}, {y})" in str(verdict.explain(x, y))
    assert expected in story_of_worst(verdict) and expected in summary(verdict)


@pytest.mark.parametrize("name, expected", [
    ("fan_at_pixel_centre", "edge"), ("coplanar", "depth_tie"), ("abutting_strips", "abutting_edges")])
def test_what_may_differ_is_told_apart_and_passes(name, expected):
    scene = zproof.load(name, size=(160, 90))
    found = set()
    for seen_from in scene.views.values():
        frame = zproof.render(scene, seen_from)
        verdict = zproof.judge(scene, seen_from, id=frame.id, depth=frame.depth, precision="opengl")
        assert verdict.proven and verdict.worst is None, failure_text(verdict)
        found |= set(nonzero(verdict.counts))
    assert expected in found


def test_the_worst_is_the_defect_of_the_largest_error():
    verdict = planted((FRONT, None, 2.0), ((37, 28), None, 2.9), ((38, 28), None, 1.0))
    assert (verdict.worst.x, verdict.worst.y) == (38, 28)
    verdict = planted((FRONT, None, 1.0), ((37, 28), BACKGROUND, np.inf), ((38, 28), None, 1.5))
    assert (verdict.worst.x, verdict.worst.y) == FRONT
    assert planted(((37, 28), BACKGROUND, np.inf)).worst.class_name == "hole"


def test_counts_classes_and_findings_say_the_same():
    verdict = planted((FRONT, 2, 4), ((37, 28), None, 2.9), (SKY, 1, 3))
    numbers = np.bincount(verdict.classes.ravel(), minlength=len(zproof.CLASS_NAMES))
    assert verdict.counts == dict(zip(zproof.CLASS_NAMES, numbers.tolist()))
    assert verdict.classes.shape == verdict.view.shape and verdict.classes.dtype == np.uint8
    findings = verdict.findings
    assert (verdict.classes[findings["y"], findings["x"]] == findings["class"]).all()
    assert len(findings) == np.count_nonzero(verdict.classes)
    places = findings["y"].astype(int) * WIDTH + findings["x"]
    assert (np.diff(places) > 0).all(), "raster order"
    assert verdict.defects == sum(count for number, count in enumerate(numbers) if _zproof.is_defect(number))


# ---- depth alone, ids alone, labels ----


def test_depth_alone():
    scene, seen_from = layers(), view()
    _, depths = traced(scene, seen_from)
    assert zproof.judge(scene, seen_from, depth=depths, precision=PRECISION).proven
    depths[28, 36] = 4  # of the square behind
    verdict = zproof.judge(scene, seen_from, depth=depths, precision=PRECISION)
    assert nonzero(verdict.counts) == {"agree": WIDTH * HEIGHT - 1, "hidden": 1}
    depths[28, 36], depths[0, 0] = np.inf, 3
    assert nonzero(zproof.judge(scene, seen_from, depth=depths, precision=PRECISION).counts) == {
        "agree": WIDTH * HEIGHT - 2, "hole": 1, "outside": 1}


def test_ids_alone():
    scene, seen_from = layers(), view()
    ids, _ = traced(scene, seen_from)
    assert zproof.judge(scene, seen_from, id=ids, precision=PRECISION).proven
    ids[28, 36], ids[28, 37], ids[0, 0], ids[0, 1] = 2, BACKGROUND, 0, 99
    verdict = zproof.judge(scene, seen_from, id=ids, precision=PRECISION)
    assert nonzero(verdict.counts) == {"agree": WIDTH * HEIGHT - 4, "hidden": 1, "hole": 1, "outside": 1,
                                       "invalid": 1}


def test_labels_of_a_file(tmp_path):
    (tmp_path / "labels.json").write_text('[7, 7, {"count": 2, "label": 8}]')
    scene, seen_from = layers(), view()
    ids, depths = traced(scene, seen_from)
    labels = np.where(ids == BACKGROUND, BACKGROUND, np.uint32(7)).astype(np.uint32)
    judged = {"depth": depths, "precision": PRECISION, "ids": tmp_path / "labels.json"}
    assert zproof.judge(scene, seen_from, id=labels, **judged).proven
    labels[28, 36], labels[28, 37] = 8, 5
    verdict = zproof.judge(scene, seen_from, id=labels, **judged)
    assert verdict.defects == 2 and verdict.counts["invalid"] == 1


@pytest.mark.parametrize("changed, words", [
    ({"precision": "nonsense"}, "nonsense"), ({"precision": ""}, "opengl"),
    ({"precision": "raster,subpixel_bits=x"}, "subpixel_bits"),
    ({"precision": {"subpixel_bits": 4}}, "kind"), ({"precision": 5}, "int"),
    ({"precision": None}, "NoneType"),
    ({"precision": "/"}, "folder"), ({"ids": "nonsense"}, "nonsense"),
    ({"ids": "/missing.json"}, "missing.json"),
    ({"id": None, "depth": None}, "neither"), ({"ids": "material", "depth": None}, "depths")])
def test_arguments_that_are_not_known_are_refused(changed, words):
    scene, seen_from = layers(), view()
    ids, depths = traced(scene, seen_from)
    with pytest.raises(ValueError) as raised:
        zproof.judge(scene, seen_from, **{"id": ids, "depth": depths, "precision": PRECISION, **changed})
    assert words in str(raised.value) and "\n" not in str(raised.value)


def test_a_promise_is_a_word_a_dict_or_a_path(tmp_path):
    (tmp_path / "mine.json").write_text('{"kind": "raster", "subpixel_bits": 4}')
    assert precision_word({"kind": "raster", "subpixel_bits": 4,
                           "watertight": True}) == "raster,subpixel_bits=4,watertight=true"
    scene, seen_from = layers(), view()
    frame = zproof.render(scene, seen_from)
    findings = [bits(zproof.judge(scene, seen_from, id=frame.id, depth=frame.depth,
                                  precision=said).findings) for said in
                ("raster,subpixel_bits=4", {"kind": "raster", "subpixel_bits": 4}, tmp_path / "mine.json")]
    assert findings[0] == findings[1] == findings[2]


# ---- the program says the same ----


def compared(program, scene, seen_from, ids, depths, precision, folder):
    """What `zproof compare` says of the same arrays: (a view of results.json, rows of findings.csv)."""
    _zproof.save_scene(scene, [seen_from], str(folder))
    np.save(folder / "id.npy", ids)
    np.save(folder / "depth.npy", depths)
    done = subprocess.run([program, "compare", f"{folder}/id.npy+{folder}/depth.npy",
                           f"{folder}/{scene.name}.view.json",
                           "--precision", precision, "-o", f"{folder}/out", "--quiet"], capture_output=True,
                          text=True, check=False)
    assert done.returncode in (0, 1), done.stderr
    [said] = json.loads((folder / "out/results.json").read_text())["views"]
    with open(folder / "out" / said["folder"] / "findings.csv", newline="", encoding="utf-8") as text:
        return said, list(csv.DictReader(text))


def faulty(seed):
    """A random scene as our rasterizer sees it, with faults of every kind in it."""
    drawn = np.random.default_rng(seed)
    scene, seen_from = zproof.Scene(*random_mesh(seed), name=f"random-{seed}"), view(96, 72)
    frame = zproof.render(scene, seen_from)
    ids, depths = frame.id.copy(), frame.depth.copy()
    y, x = drawn.integers(0, 72, 60), drawn.integers(0, 96, 60)
    ids[y[:20], x[:20]] = drawn.integers(0, 45, 20)
    depths[y[20:40], x[20:40]] *= np.float32(1.001)
    depths[y[40:50], x[40:50]] = np.nan
    ids[y[50:], x[50:]], depths[y[50:], x[50:]] = BACKGROUND, np.inf
    return scene, seen_from, ids, depths


@pytest.mark.parametrize("seed", range(4))
def test_the_program_says_the_same(program, tmp_path, seed):
    scene, seen_from, ids, depths = faulty(seed)
    verdict = zproof.judge(scene, seen_from, id=ids, depth=depths, precision="opengl")
    said, rows = compared(program, scene, seen_from, ids, depths, "opengl", tmp_path)
    assert verdict.counts == said["counts"] and len(nonzero(verdict.counts)) >= 5
    assert verdict.defects == said["defects"] > 20
    assert verdict.proven == (said["outcome"] == "proven")
    worst = said["worst"][0]
    mine = verdict.worst
    assert (mine.x, mine.y, mine.class_name) == (worst["x"], worst["y"], worst["class"])
    assert_same_sentences(verdict, said["worst"])
    cause = said["diagnosis"]["cause"]
    assert verdict.diagnosis.cause == (cause["name"] if cause else "")
    assert verdict.diagnosis.defects == said["diagnosis"]["defects"]
    assert_same_findings(verdict.findings, rows)


def assert_same_sentences(verdict, worst):
    """Of the worst pixels that the program lists."""
    assert len(worst) > 5
    for said in worst:
        finding = verdict.explain(said["x"], said["y"]).finding
        assert finding.class_name == said["class"]
        assert verdict.sentence(finding) == said["explanation"]


def assert_same_findings(findings, rows):
    by_place = {(f["x"], f["y"]): f for f in findings}
    assert len(rows) > 20
    for row in rows:
        found = by_place[int(row["x"]), int(row["y"])]
        assert zproof.CLASS_NAMES[found["class"]] == row["class"]
        assert_same_id(found["id"], row["candidate_id"])
        assert_same_id(found["reference_id"], row["reference_id"])
        for mine, its in [("depth", "candidate_depth"), ("reference_depth", "reference_depth"),
                          ("eps_px", "eps_px"),
                          ("depth_low", "depth_low"), ("depth_truth", "depth_truth"),
                          ("depth_high", "depth_high"),
                          ("error_over_bound", "error_over_bound")]:
            expected = float(row[its] or "nan")
            assert np.isclose(found[mine], expected, rtol=1e-6, atol=0, equal_nan=True), (mine, row)


def assert_same_id(mine, its):
    assert int(mine) == (int(its) if its.isdigit() else BACKGROUND)


# ---- words ----


def test_an_explanation_has_text_and_numbers():
    told = planted((FRONT, 2, 4)).explain(*FRONT)
    assert told.finding.class_name == "hidden" and told.finding.id == 2
    assert [t.id for t in told.triangles][0] in (0, 1) and not told.is_background_admissible
    by_id = {t.id: t for t in told.triangles}
    low, truth, high = by_id[2].bound
    assert low < truth < high and abs(truth - 4) < 1e-6 and not by_id[2].is_admissible
    assert all(isinstance(d, float) for d in by_id[2].edge_distance_px)
    assert str(told) == told.text == repr(told) and told.text.count("\n") > 3
    assert planted().explain(*SKY).is_background_admissible


@pytest.mark.parametrize("x, y", [(-1, 0), (0, -1), (WIDTH, 0), (0, HEIGHT), (2**31 - 1, 0), (-2**31, 0)])
def test_no_pixel_outside_is_explained(x, y):
    with pytest.raises(ValueError) as raised:
        planted().explain(x, y)
    assert f"pixel ({x}, {y}) lies outside of the view, which is {WIDTH} x {HEIGHT}" in str(raised.value)


@pytest.mark.parametrize("cause, turn", [("flipped in y", lambda a: a[::-1]),
                                         ("flipped in x", lambda a: a[:, ::-1])])
def test_a_diagnosis_names_the_cause(cause, turn):
    scene, seen_from = zproof.Scene(*random_mesh(3)), view()
    ids, depths = (np.ascontiguousarray(turn(a)) for a in traced(scene, seen_from))
    verdict = zproof.judge(scene, seen_from, id=ids, depth=depths, precision=PRECISION)
    assert cause in verdict.diagnosis.cause and cause in failure_text(verdict)
    assert verdict.diagnosis.defects == verdict.defects > 100
    assert verdict.diagnosis.explained_share > 0.9


def test_assert_proven_tells_the_story():
    scene, seen_from = layers(), view(name="cam")
    ids, depths = traced(scene, seen_from)
    assert zproof.assert_proven(scene, seen_from, id=ids, depth=depths, precision=PRECISION).proven
    ids[28, 36] = 2
    with pytest.raises(AssertionError) as raised:
        zproof.assert_proven(scene, seen_from, id=ids, depth=depths, precision=PRECISION)
    said = str(raised.value)
    assert "cam: 1 of 3,072 pixels are defects" in said and "pixel (36, 28)" in said


# ---- reports ----


def test_a_saved_report_says_the_same(program, tmp_path):
    verdict = planted((FRONT, 2, 4), (SKY, 0, 3))
    verdict.save(tmp_path / "out")
    results = json.loads((tmp_path / "out/results.json").read_text())
    [said] = results["views"]
    assert said["counts"] == verdict.counts and said["scene"] == "layers" and said["view"] == "view"
    assert "layers" in (tmp_path / "out/report.html").read_text()
    verdict.save(tmp_path / "out")  # its own report is replaced


def test_reports_of_many_verdicts_are_one(program, tmp_path):
    zproof.save_all({"good": planted(), "bad": planted((FRONT, 2, 4))}, tmp_path / "out")
    views = json.loads((tmp_path / "out/results.json").read_text())["views"]
    assert [(v["scene"], v["outcome"]) for v in views] == [("good", "proven"), ("bad", "defective")]
    page = html.unescape((tmp_path / "out/report.html").read_text())
    assert "good" in page and "bad" in page
    for view in views:
        name, command = view["scene"], view["command"]
        assert command.startswith(f"zproof compare {name}-input/{name}.exr {name}-input/{name}.view.json ")
        assert f"<code>{command}</code>" in page


def test_a_report_never_replaces_a_folder_of_others(program, tmp_path):
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine/letter.txt").write_text("dear")
    with pytest.raises(RuntimeError, match="mine.*was not made by zproof"):
        planted().save(tmp_path / "mine")
    assert [f.name for f in (tmp_path / "mine").iterdir()] == ["letter.txt"]
    assert (tmp_path / "mine/letter.txt").read_text() == "dear"


def test_a_report_writes_into_no_input_folder_of_others(program, tmp_path):
    (tmp_path / "out-input").mkdir()
    (tmp_path / "out-input/layers.glb").write_text("dear")
    with pytest.raises(RuntimeError):
        planted().save(tmp_path / "out")
    assert (tmp_path / "out-input/layers.glb").read_text() == "dear"


def test_without_the_program_no_report_is_written(monkeypatch, tmp_path):
    monkeypatch.setenv("ZPROOF_PROGRAM", "/nowhere/zproof")
    with pytest.raises(RuntimeError, match="/nowhere/zproof"):
        planted().save(tmp_path / "out")
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("name", ["", "a/b", ".", "..", "../b"])
def test_a_name_that_is_no_file_s_is_refused(program, tmp_path, name):
    with pytest.raises(ValueError):
        zproof.save_all({name: planted()}, tmp_path / "out")


def test_a_name_that_is_refused_leaves_nothing(program, tmp_path):
    with pytest.raises(ValueError):
        zproof.save_all({"../b": planted()}, tmp_path / "out")
    assert list(tmp_path.iterdir()) == []


def test_settings_of_the_current_folder_do_not_change_a_report(monkeypatch, tmp_path):
    monkeypatch.setenv("ZPROOF_ORACLE", "none")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "zproof.toml").write_text('report = ["csv"]\nwaivers = "waivers.toml"\n')
    planted((FRONT, 2, 4)).save(tmp_path / "out")
    assert (tmp_path / "out/report.html").exists()


# ---- threads ----


def lets_others_run(work):
    """Does another thread of Python run before `work` ends? The interpreter takes the lock from no one here:
    it is there for others only where `work` itself gives it back."""
    go, ran = threading.Event(), threading.Event()
    ready = threading.Barrier(2)

    def other():
        ready.wait()
        go.wait()
        ran.set()

    thread = threading.Thread(target=other)
    usual = sys.getswitchinterval()
    sys.setswitchinterval(1000)
    try:
        thread.start()
        ready.wait()
        go.set()
        work()
        return ran.is_set()
    finally:
        sys.setswitchinterval(usual)
        thread.join()


@pytest.fixture(scope="module")
def large():
    """(scene, view, ids, depths, verdict) of a frame that takes a while."""
    scene, seen_from = zproof.Scene(*random_mesh(1, triangles=3000)), view(1200, 900)
    frame = zproof.render(scene, seen_from)
    ids, depths = frame.id.copy(), np.roll(frame.depth, 1, 1)
    depths[100:] = frame.depth[100:]
    verdict = zproof.judge(scene, seen_from, id=ids, depth=depths, precision="opengl")
    return scene, seen_from, ids, depths, verdict


@pytest.mark.parametrize("name", ["judge", "trace", "diagnosis", "truth", "load"])
def test_other_threads_go_on(large, name):
    scene, seen_from, ids, depths, verdict = large
    work = {"judge": lambda: zproof.judge(scene, seen_from, id=ids, depth=depths, precision="opengl"),
            "trace": lambda: zproof.trace(scene, seen_from), "diagnosis": lambda: verdict.diagnosis,
            "truth": lambda: zproof.filters.truth(scene, view(80, 60)),
            "load": lambda: zproof.load("million_triangles")}
    assert lets_others_run(work[name])


def test_a_call_that_keeps_the_lock_is_seen():
    assert not lets_others_run(lambda: sum(range(3_000_000)))


def test_one_scene_is_judged_by_many_threads():
    scene, seen_from = zproof.Scene(*random_mesh(1)), view()
    ids, depths = traced(scene, seen_from)
    ids[20:30, 20:30] = 5
    judged = lambda: zproof.judge(scene, seen_from, id=ids, depth=depths, precision=PRECISION)  # noqa: E731
    expected, found = bits(judged().findings), []
    threads = [threading.Thread(target=lambda: found.extend(bits(judged().findings) for _ in range(10)))
               for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 80 and set(found) == {expected}


def test_a_view_s_edges_are_judged_too():
    for width, height in [(1, 1), (1, 50), (50, 1), (257, 3)]:
        seen_from = view(width, height)
        ids, depths = traced(layers(), seen_from)
        assert zproof.judge(layers(), seen_from, id=ids, depth=depths, precision=PRECISION).proven
        ids[-1, -1] = 77
        verdict = zproof.judge(layers(), seen_from, id=ids, depth=depths, precision=PRECISION)
        assert (verdict.worst.x, verdict.worst.y) == (width - 1, height - 1)
        assert verdict.worst.class_name == "invalid"
