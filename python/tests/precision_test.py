"""A promise as a word, words, a dict or a file."""
import json
import pathlib

import numpy as np
import pytest

import zproof
from zproof.judging import precision_word


@pytest.mark.parametrize("given, word", [
    ("opengl", "opengl"),
    ("raster,subpixel_bits=4", "raster,subpixel_bits=4"),
    ({"kind": "ray"}, "ray"),
    ({"kind": "raster", "subpixel_bits": 4, "snap": "none"}, "raster,subpixel_bits=4,snap=none"),
    ({"subpixel_bits": np.int64(4), "kind": "opengl"}, "opengl,subpixel_bits=4"),
    ({"kind": "ray", "watertight": False}, "ray,watertight=false"),
    ({"kind": "ray", "watertight": np.bool_(True)}, "ray,watertight=true"),
    ({"kind": "bounded", "eps_px": 1e-9, "depth_relative": np.float64(0.5)},
     "bounded,eps_px=1e-09,depth_relative=0.5"),
    (pathlib.Path("mine.json"), "mine.json"),
])
def test_word(given, word):
    assert precision_word(given) == word


@pytest.mark.parametrize("given, message", [
    (None, "precision is a NoneType; expected a str, a path or a dict"),
    (3, "precision is a int"),
    ({}, 'the dict has no "kind"'),
    ({"kind": "raster", "projections": ["perspective"]},
     "'projections' is ['perspective']; expected a word, a number, True or False"),
    ({"kind": "raster", "snap": None}, "'snap' is None"),
    ({"kind": "raster", "snap": "none,subpixel_bits=2"}, "'snap' is 'none,subpixel_bits=2'"),
])
def test_refused(given, message):
    with pytest.raises(ValueError) as refused:
        precision_word(given)
    assert message in str(refused.value)


@pytest.fixture(scope="module")
def snapped():
    """A picture by 8 sub-pixel bits."""
    scene = zproof.load("room", (160, 90))
    view = scene.views["door"]
    frame = zproof.render(scene, view)
    return scene, view, {"id": frame.id, "depth": frame.depth}


def test_a_dict_words_and_a_file_say_the_same(snapped, tmp_path):
    scene, view, frame = snapped
    keys = {"kind": "raster", "transform": "float64", "subpixel_bits": 12}
    file = tmp_path / "mine.json"
    file.write_text(json.dumps(keys), encoding="utf-8")
    words = "raster,transform=float64,subpixel_bits=12"
    counts = [zproof.judge(scene, view, **frame, precision=p).counts for p in (keys, words, file, str(file))]
    assert all(count == counts[0] for count in counts)
    assert counts[0] != zproof.judge(scene, view, **frame, precision="raster,transform=float64").counts


@pytest.mark.parametrize("precision, message", [
    ("opengL", "opengL"),
    ({"kind": "raster", "subpixel_bits": 4.5}, "/subpixel_bits: expected a whole number from 0 to 16"),
    ({"kind": "raster", "colour": "red"}, "/colour: unknown key"),
    ("", "no precision"),
])
def test_the_judge_refuses(snapped, precision, message):
    scene, view, frame = snapped
    with pytest.raises(ValueError) as refused:
        zproof.judge(scene, view, **frame, precision=precision)
    assert message in str(refused.value)
