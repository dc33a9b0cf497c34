"""The programs of examples/python and the page docs/python.md do what they say."""
import pathlib
import re
import subprocess
import sys

import pytest

SOURCE = pathlib.Path(__file__).resolve().parents[2]

# Each program, with the lines that it must print, as patterns of whole lines in this order.
SAYS = {
    "raycaster": [
        r"room, float32: door: proven, 2,304 pixels",
        r"coplanar, float64: aside: proven, 2,304 pixels",
        r"door: [\d,]+ of 2,304 pixels are defects: .*",
        r"likely cause: the image is shifted by \(-1/2, 0\) px .*",
        r"pixel \(\d+, \d+\): hidden, FAIL",
    ],
    "vtk_offscreen": [
        r"room, door: proven, 57,600 pixels",
        r"orthographic, isometric: proven, 57,600 pixels",
        r"likely cause: depth is NDC z \(0 to 1\) \(explains 100% .*",
    ],
    "open3d_raycasting": [
        r"room, door: proven, 57,600 pixels",
        r"near_plane, aside: proven, 57,600 pixels",
        r"likely cause: depth is the ray's length \(explains 100% .*",
    ],
    "opencv_camera": [
        r"front: proven, 19,200 pixels",
        r"left: proven, 19,200 pixels",
        r"back: proven, 19,200 pixels",
        r"likely cause: the image is shifted by \(\+1/2, \+1/2\) px .*",
    ],
    "own_filter": [
        r"mine-4x4: rmse of all pixels 0\.\d+",
        r"  mine-centre as bilinear: passed .*",
        r"  mine-4x4 as supersample-bilinear:n=4: passed .*",
        r"  mine-4x4 as bilinear: FAILED .*",
    ],
}


def test_every_example_is_known():
    assert {file.stem for file in (SOURCE / "examples/python").glob("*.py")} == set(SAYS)


@pytest.mark.parametrize("name", SAYS)
def test_example(name, tmp_path):
    program = SOURCE / "examples/python" / f"{name}.py"
    command = [sys.executable, program]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    left = iter(done.stdout.splitlines())
    for pattern in SAYS[name]:
        assert any(re.fullmatch(pattern, line) for line in left), f"no line {pattern!r} in\n{done.stdout}"


def blocks(page):
    """(line, code) of each block of Python."""
    text = page.read_text(encoding="utf-8")
    for found in re.finditer(r"^```python\n(.*?)^```$", text, re.DOTALL | re.MULTILINE):
        yield text.count("\n", 0, found.start(1)) + 1, found[1]


def test_page_runs_in_order(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    page, names = SOURCE / "docs/python.md", {"__name__": "page"}
    code = list(blocks(page))
    assert len(code) >= 10
    for line, block in code:
        # with the page's own lines in a traceback
        exec(compile("\n" * (line - 1) + block, str(page), "exec"), names)  # pylint: disable=exec-used
    assert (tmp_path / "report/report.html").is_file()


def test_page_shows_what_is_printed(tmp_path, monkeypatch, capsys):
    """print(...) # text: the output has the text, where "..." stands for anything."""
    monkeypatch.chdir(tmp_path)
    names, shown = {"__name__": "page"}, 0
    for _, block in blocks(SOURCE / "docs/python.md"):
        exec(block, names)  # pylint: disable=exec-used
        printed = capsys.readouterr().out
        for text in re.findall(r"^ *print\(.*?\) +# (.*)$", block, re.MULTILINE):
            if text.startswith("all that"):
                continue
            shown += 1
            pattern = ".*".join(map(re.escape, text.split("...")))
            assert re.search(pattern, printed), f"{text!r} in {printed!r}"
    assert shown >= 3
