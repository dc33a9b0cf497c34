"""What a notebook shows: HTML of a frame, a verdict and a study's table."""
import base64
import re
import struct
import zlib

import numpy as np
import pytest

import zproof
from zproof import filters, notebook

PROMISE = "raster,transform=float64"


def unpacked(file):
    """The pixels of a PNG with 8 bits of R, G and B, and filter 0: uint8 (height, width, 3)."""
    assert file[:8] == b"\x89PNG\r\n\x1a\n"
    place, chunks = 8, {}
    while place < len(file):
        size, = struct.unpack_from(">I", file, place)
        name, content = file[place + 4:place + 8], file[place + 8:place + 8 + size]
        assert struct.unpack_from(">I", file, place + 8 + size)[0] == zlib.crc32(name + content)
        chunks[name], place = content, place + 12 + size
    width, height, depth, colours = struct.unpack_from(">IIBB", chunks[b"IHDR"])
    assert (depth, colours) == (8, 2)
    rows = np.frombuffer(zlib.decompress(chunks[b"IDAT"]), np.uint8).reshape(height, 1 + 3 * width)
    assert not rows[:, 0].any()
    return rows[:, 1:].reshape(height, width, 3)


def pictures(html):
    """{caption: (width and height on the screen, pixels)}"""
    found = {}
    for tag in re.findall(r"<img [^>]*>", html):
        caption, width, height = (re.search(f'{key}="([^"]*)"', tag)[1] for key in ("alt", "width", "height"))
        data = re.search(r'src="data:image/png;base64,([^"]*)"', tag)[1]
        found[caption] = ((int(width), int(height)), unpacked(base64.b64decode(data)))
    return found


def class_colour(name):
    value = zproof.CLASS_COLOURS[zproof.CLASS_NAMES.index(name)]
    return [value >> 16, value >> 8 & 255, value & 255]


def view_of(size):
    scene = zproof.load("room", size)
    view = scene.views["door"]
    return scene, view, zproof.render(scene, view)


def verdict_of(size, hole):
    """A pixel that shows background."""
    scene, view, frame = view_of(size)
    ids, depths = frame.id.copy(), frame.depth.copy()
    ids[hole[1], hole[0]], depths[hole[1], hole[0]] = zproof.BACKGROUND_ID, np.inf
    return zproof.judge(scene, view, id=ids, depth=depths, precision=PROMISE)


def test_png_is_what_was_given():
    pixels = np.random.default_rng(1).integers(0, 256, (5, 7, 3)).astype(np.uint8)
    assert (unpacked(notebook.png(pixels)) == pixels).all()


def test_frame_has_ids_and_depth():
    frame = view_of((64, 36))[2]
    shown = pictures(frame._repr_html_())
    assert list(shown) == ["triangle ids, 64 x 36", "camera depth, near is bright"]
    (size, ids), (_, greys) = shown.values()
    assert size == (7 * 64, 7 * 36)  # as large as 480 pixels allow
    for y, x in np.argwhere(frame.id[:, 1:] == frame.id[:, :-1])[:50]:
        assert (ids[y, x] == ids[y, x + 1]).all()
    nearest = np.unravel_index(frame.depth.argmin(), frame.depth.shape)
    assert greys[nearest].tolist() == [255] * 3


def test_background_is_black():
    ids = np.array([[0, zproof.BACKGROUND_ID]], np.uint32)
    assert notebook.id_colours(ids)[0, 1].tolist() == [0, 0, 0] != notebook.id_colours(ids)[0, 0].tolist()
    depths = np.array([[np.inf, np.nan, -1, 0, 2]], np.float32)
    assert notebook.depth_greys(depths)[0, :, 0].tolist() == [0, 0, 0, 0, 64]


def test_neighbouring_ids_have_different_colours():
    colours = notebook.id_colours(np.arange(20000, dtype=np.uint32)[None])[0].astype(int)
    assert np.abs(np.diff(colours, axis=0)).max(axis=1).min() >= 16


@pytest.mark.parametrize("size, hole", [
    ((64, 36), (10, 5)), ((1930, 1083), (1929, 1082)), ((300, 1000), (1, 2))])
def test_no_defect_is_lost_where_a_picture_is_shown_smaller(size, hole):
    verdict = verdict_of(size, hole)
    assert verdict.defects == 1
    shown = pictures(verdict._repr_html_())
    caption, (on_screen, pixels) = next(iter(shown.items()))
    assert caption.startswith(f"class of every pixel, {size[0]} x {size[1]}")
    assert max(on_screen) <= 480
    step = -(-max(size) // 480)
    assert (f"the severest of {step} x {step}" in caption) == (step > 1)
    red = (pixels == class_colour("hole")).all(axis=-1)
    assert red.sum() == 1 and red[hole[1] // step, hole[0] // step]


def test_severest():
    classes = np.array([[0, 9, 0, 0, 1], [0, 0, 10, 0, 0], [0, 0, 0, 0, 12]], np.uint8)
    assert notebook.severest(classes, 2).tolist() == [[9, 10, 1], [0, 0, 12]]
    assert (notebook.severest(classes, 1) == classes).all()


@pytest.mark.parametrize("hole", [(0, 0), (63, 35), (30, 20), (0, 35)])
def test_the_worst_pixel_is_framed(hole):
    html = verdict_of((64, 36), hole)._repr_html_()
    assert f"Around the worst pixel, ({hole[0]}, {hole[1]})" in html
    pixels = pictures(html)["class"][1]
    assert pixels.shape == (32 * 6, 32 * 6, 3)
    red = np.argwhere((pixels == class_colour("hole")).all(axis=-1))
    assert len(red) == 36 and (np.ptp(red, axis=0) == 5).all()
    (top, left), (bottom, right) = red.min(axis=0), red.max(axis=0)
    beside = [(top - 1, left), (bottom + 1, left), (top, left - 1), (top, right + 1)]
    around = [pixels[y, x] for y, x in beside if 0 <= y < 192 and 0 <= x < 192]
    assert len(around) >= 2 and all((pixel == 255).all() for pixel in around)


def test_a_picture_smaller_than_the_surroundings():
    html = verdict_of((9, 7), (8, 6))._repr_html_()
    assert pictures(html)["class"][1].shape == (7 * 6, 9 * 6, 3)


def test_a_verdict_says_counts_and_gate():
    verdict = verdict_of((64, 36), (10, 5))
    text = re.sub(r"<[^>]*>", " ", verdict._repr_html_())
    assert "door: 1 of 2,304 pixels are defects: 1 hole" in text
    assert re.search(r"hole +1 +fails", text)
    assert re.search(r"agree +2,\d+ +passes", text)
    assert re.search(r"10, 5 +hole +background +inf", text)
    assert str(verdict.diagnosis) in text


def test_the_list_begins_with_the_worst():
    scene, view, frame = view_of((64, 36))
    verdict = zproof.judge(scene, view, id=np.roll(frame.id, 1, axis=1), depth=frame.depth, precision=PROMISE)
    listed = re.findall(r"<td[^>]*>(\d+), (\d+)</td>", verdict._repr_html_())
    assert len(listed) == 8 and listed[0] == (str(verdict.worst.x), str(verdict.worst.y))


def test_an_undecided_verdict_shows_where():
    scene, view, frame = view_of((64, 36))
    ids = frame.id.copy()
    y, x = np.argwhere(frame.id[:, 1:] != frame.id[:, :-1])[0]
    ids[y, x] = ids[y, x + 1]
    promise = {"kind": "bounded", "eps_px": 16, "depth_relative": 1e-3, "depth_absolute": 10}
    verdict = zproof.judge(scene, view, id=ids, depth=frame.depth, precision=promise)
    assert verdict.defects == 0 and verdict.counts["undecidable"] > 0
    text = re.sub(r"<[^>]*>", " ", verdict._repr_html_())
    assert re.search(r"undecidable +[\d,]+ +undecided", text)
    assert f"The worst of {verdict.counts['undecidable']} undecidable pixels:" in text
    assert "Around the worst pixel" in text


def test_a_proven_verdict_has_no_list():
    scene, view, frame = view_of((64, 36))
    html = zproof.judge(scene, view, id=frame.id, depth=frame.depth, precision=PROMISE)._repr_html_()
    assert "door: proven, 2,304 pixels" in html and "worst" not in html and len(pictures(html)) == 1


def test_nothing_comes_from_the_network():
    html = verdict_of((64, 36), (10, 5))._repr_html_() + view_of((64, 36))[2]._repr_html_()
    assert not re.search(r"https?:|src=\"(?!data:)|href|<script|<link|@import|url\(", html)


def table(rows=3):
    return filters.Table(scene=np.array(["<b>"] * rows), method=np.array([f"m{i}" for i in range(rows)]),
                         rmse=np.linspace(0.25, 0.5, rows), flicker=np.full(rows, np.nan))


def test_a_table_says_once_what_is_the_same():
    html = table()._repr_html_()
    assert html.startswith("<p>scene &lt;b&gt;</p><table>")
    assert re.findall(r"<th[^>]*>([^<]*)</th>", html) == ["method", "rmse"]  # and no flicker
    assert html.count("<tr>") == 4 and "<b>" not in html
    assert ">0.25<" in html


def test_a_long_table_is_cut():
    html = table(25)._repr_html_()
    assert html.count("<tr>") == 21 and "and 5 more rows" in html


@pytest.mark.parametrize("rows", [0, 1])
def test_a_short_table(rows):
    html = table(1).rows(method="m0" if rows else "none")._repr_html_()
    assert html.count("<tr>") == 1 + rows and "more rows" not in html


def test_findings_have_a_text():
    verdict = verdict_of((64, 36), (10, 5))
    of = verdict.worst.reference_id
    assert repr(verdict.worst) == f"<zproof.Finding at (10, 5): hole, background for {of}>"
    nearest = verdict.explain(10, 5).triangles[0]
    assert repr(nearest).startswith(f"<zproof.NearTriangle {of}: admissible, depth ")
