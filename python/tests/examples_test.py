"""The programs of examples/python that need numpy alone, and the page docs/python.md, do what they say."""
import re

import pytest
import renderers_test
from example_runs import EXAMPLES, SOURCE, example_says

# The lines that each program must print, as patterns of whole lines in this order.
SAYS = {
    "raycaster": [
        r"room, float32: door: proven, 2,304 pixels",
        r"coplanar, float64: aside: proven, 2,304 pixels",
        r"door: [\d,]+ of 2,304 pixels are defects: .*",
        r"likely cause: the image is shifted by \(-1/2, 0\) px .*",
        r"pixel \(\d+, \d+\): wrong_depth, FAIL",
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


@pytest.mark.parametrize("name", SAYS)
def test_example(name, tmp_path):
    example_says(name, SAYS[name], tmp_path)


def test_every_example_is_tested():
    tested = set(SAYS) | set(renderers_test.SAYS)
    assert {file.stem for file in EXAMPLES.glob("*.py")} == tested


def blocks(page):
    """(line, code) of each block of Python."""
    text = page.read_text(encoding="utf-8")
    for found in re.finditer(r"^```python\n(.*?)^```$", text, re.DOTALL | re.MULTILINE):
        yield text.count("\n", 0, found.start(1)) + 1, found[1]


@pytest.fixture(autouse=True)
def scratch(tmp_path, monkeypatch):
    """A folder of its own; POV-Ray is not asked, and the user's settings are not read."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("ZPROOF_ORACLE", "none")
    monkeypatch.setenv("ZPROOF_CONFIG", "none")


def test_page_runs_in_order(tmp_path):
    page, names = SOURCE / "docs/python.md", {"__name__": "page"}
    code = list(blocks(page))
    assert len(code) >= 10
    for line, block in code:
        # with the page's own lines in a traceback
        exec(compile("\n" * (line - 1) + block, str(page), "exec"), names)  # pylint: disable=exec-used
    assert (tmp_path / "report/report.html").is_file()


def test_page_shows_what_is_printed(capsys):
    """print(...) # text: the output has the text, where "..." stands for anything."""
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
