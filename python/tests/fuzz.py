#!/usr/bin/env python3
"""Draws right and wrong inputs for every public function of the module. Only ValueError, TypeError,
RuntimeError and MemoryError may come out, and Python must live on.

    python3 python/tests/fuzz.py [--seed 1] [--rounds 2000] [--only NAME]

A round's inputs depend on the seed and the round alone. Where Python itself ends (a crash), or another
exception comes out, the last line says how the round is repeated, and the exit status is 1.
"""

import argparse
import collections
import faulthandler
import math
import os
import subprocess
import sys
import tempfile
import warnings

import numpy as np

import zproof
from zproof import _zproof

ROUND = "round"  # the file that names the last one
ALLOWED = (ValueError, TypeError, RuntimeError, MemoryError)
DTYPES = ["bool", "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", "float16",
          "float32", "float64",
          "longdouble", "complex64", "M8[s]", "S4", "U2", "V3", "O", ">f4", ">u4", [("a", "u4")]]
NUMBERS = [0, 1, -1, 0.5, -0.0, 1e-45, 1e-38, 1e-10, 1e10, 1e11, 1.1e11, 3e38, 1e300, 5e-324, math.nan,
           math.inf, -math.inf,
           2**31 - 1, 2**31, 2**32 - 1, 2**32, -2**31, 2**63, 10**400, math.pi]
STRANGE = [None, "", "word", b"bytes", (), [], {}, object(), 3j, True, np, print, float, [[]], range(4), "\0",
           "\ud800",
           "a" * 5000, "%s%n", "../..", "/", "/dev/null", "."]


class Gives:
    """An object with numpy's protocols that gives what it is told to, or raises it."""

    def __init__(self, value):
        self.value = value

    def __array__(self, *_, **__):
        if isinstance(self.value, Exception):
            raise self.value
        return self.value


class Dlpack(Gives):
    __array__ = None

    def __dlpack__(self, *_, **keys):
        if isinstance(self.value, Exception):
            raise self.value
        return self.value.__dlpack__(**keys) if isinstance(self.value, np.ndarray) else self.value

    def __dlpack_device__(self):
        return (1, 0)


class Drawn:
    """Everything of one round."""

    def __init__(self, seed, number):
        self.random = np.random.default_rng([seed, number])

    def chance(self, of_one):
        return self.random.random() < of_one

    def one_of(self, choices):
        return choices[self.random.integers(len(choices))]

    def number(self, usual):
        """The usual one, mostly."""
        return usual if self.chance(0.93) else self.one_of(NUMBERS if self.chance(0.8) else STRANGE)

    def word(self, usual):
        return usual if self.chance(0.96) else self.one_of(STRANGE + NUMBERS)

    def shape(self, usual):
        kind = self.random.integers(6)
        if kind == 0:
            return ()
        if kind == 1:
            return tuple(self.random.integers(0, 5, self.random.integers(0, 5)))
        if kind == 2:
            return usual[::-1]
        if kind == 3:
            return (*usual, 1)
        if kind == 4:
            return usual[:-1]
        return tuple(max(0, n + int(self.random.integers(-1, 2))) for n in usual)

    def turned(self, array):
        """The same shape and dtype in another layout, or in other hands."""
        kind = self.random.integers(13)
        if kind == 0:
            return np.asfortranarray(array)
        if kind == 1:
            return array[::-1]
        if kind == 2 and array.ndim:
            return np.repeat(array, 2, -1)[..., ::2]
        if kind == 3 and array.dtype.kind in "fiu":
            return np.zeros(array.nbytes + 1, np.uint8)[1:].view(array.dtype).reshape(array.shape)
        if kind == 4:
            array.flags.writeable = False
            return array
        if kind == 5:
            return np.broadcast_to(np.zeros((), array.dtype),
                                   self.one_of([array.shape, (2**40, 2**15), (2**33, 3), (2**31 + 1, 2, 4)]))
        if kind == 6:
            return Gives(self.one_of([array, *STRANGE, ValueError("no"), KeyError(5), RuntimeError()]))
        if kind == 7:
            return Dlpack(self.one_of([array, array, *STRANGE, BufferError("no")]))
        if kind == 8:
            return np.ma.array(array, mask=self.random.random(array.shape) < 0.5)
        if kind == 9:
            return array.tolist()
        if kind == 10:
            return array.astype(array.dtype.newbyteorder())
        if kind == 11 and array.ndim == 2:
            return np.matrix(array)
        return memoryview(array) if array.dtype.kind in "fiu" else array

    def array(self, right):
        """The right array, mostly."""
        kind = self.random.random()
        if kind < 0.75:
            return right
        if kind < 0.85:
            return self.turned(right.copy())
        if kind < 0.9:
            return np.zeros(self.shape(right.shape), right.dtype)
        if kind < 0.95:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                return np.zeros(right.shape, self.one_of(DTYPES))
        return self.one_of(STRANGE + NUMBERS) if kind < 0.98 else None

    def spoilt(self, floats, share=0.05):
        """Some of the numbers are others."""
        if self.chance(0.3):
            places = self.random.random(floats.shape) < share
            with np.errstate(over="ignore"):
                floats[places] = np.array([float(n) for n in NUMBERS if n != 10**400])[
                    self.random.integers(0, len(NUMBERS) - 1, places.sum())].astype(floats.dtype)
        return floats

    def size(self):
        return self.one_of([(32, 24), (1, 1), (57, 3), (2, 40)]) if self.chance(0.95) else self.one_of(
            [(0, 0), (-1, 5), (32769, 1), (2**31, 2**31), (1.5, 2), (3,), 5, "ab", None,
             (np.int64(8), np.uint8(9))])


def a_mesh(drawn):
    """(positions, triangles, further arguments), all of them right."""
    count = int(drawn.one_of([0, 1, 2, 10, 60]))
    positions = drawn.random.uniform(-2, 2, (3 * count, 3)).astype(np.float32)
    if drawn.chance(0.3):
        positions = np.round(positions * 4) / 4
    triangles = drawn.random.integers(0, max(3 * count, 1), (count, 3)).astype(np.uint32)
    if drawn.chance(0.7):
        triangles = np.arange(3 * count, dtype=np.uint32).reshape(-1, 3)
    more = {}
    if drawn.chance(0.3):
        more["uv"] = drawn.spoilt(drawn.random.uniform(-2, 2, (3 * count, 2)).astype(np.float32))
        more["texture"] = drawn.random.integers(0, 256, (*drawn.random.integers(1, 9, 2), 4)).astype(np.uint8)
    return positions, triangles, more


def a_view(drawn, size=(32, 24)):
    """A right one."""
    if drawn.chance(0.3):
        K = np.array([[30.0, 0, 15], [0, 30, 12], [0, 0, 1]])
        return zproof.View.from_opencv(K, np.diag([1, -1, -1.0]), [0, 0, 4], size, 0.1, 100)
    eye = drawn.random.uniform(-4, 4, 3)
    eye[2] = 5
    if drawn.chance(0.3):
        return zproof.View.orthographic(eye=eye, target=(0, 0, 0), height=4.0, near=0.1, far=100.0, size=size)
    return zproof.View.perspective(eye=eye, target=(0, 0, 0), yfov=0.8, near=0.1, size=size)


def a_scene(drawn):
    positions, triangles, more = a_mesh(drawn)
    return zproof.Scene(positions, triangles, **more)


# ---- a round of each function ----


def scene(drawn, _):
    positions, triangles, more = a_mesh(drawn)
    positions = drawn.spoilt(positions)
    if drawn.chance(0.2) and triangles.size:
        triangles[drawn.random.integers(len(triangles)), 0] = drawn.one_of([2**32 - 1, 2**31, len(positions)])
    made = zproof.Scene(drawn.array(positions), drawn.array(triangles), name=drawn.word("scene"),
                        **{name: drawn.array(value) for name, value in more.items()})
    assert (made.positions.shape[1], made.triangles.shape[1]) == (3, 3)
    repr(made), made.views, made.notes, made.name


def load(drawn, folder):
    file = os.path.join(folder, drawn.one_of(["a.obj", "a.ply", "a.gltf", "a.glb", "a.json"]))
    right = {"obj": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
             "ply": b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                    b"property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                    b"0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
             "gltf": b'{"asset": {"version": "2.0"}}', "glb": b"glTF\x02\0\0\0\x0c\0\0\0",
             "json": b'{"views": []}'}
    content = bytearray(right[file.rsplit(".", 1)[1]])
    for _ in range(int(drawn.random.integers(0, 4))):
        content[drawn.random.integers(len(content))] = drawn.random.integers(256)
    with open(file, "wb") as out:
        out.write(content)
    loaded = zproof.load(drawn.word(file), size=drawn.size())
    for seen in list(loaded.views.values())[:1]:
        if max(seen.size) <= 64:
            zproof.render(loaded, seen)


def view(drawn, _):
    def point(usual):
        return [drawn.number(n) for n in usual] if drawn.chance(0.8) else drawn.word(usual)

    placed = {"eye": point((0.0, 0, 5)), "target": point((0, 0, 0)), "up": point((0, 1, 0)),
              "near": drawn.number(0.1),
              "far": drawn.number(100.0), "size": drawn.size(), "name": drawn.word("view")}
    kind = drawn.random.integers(3)
    if kind == 0:
        made = zproof.View.perspective(yfov=drawn.number(0.8), **placed)
    elif kind == 1:
        made = zproof.View.orthographic(height=drawn.number(4.0), **placed)
    else:
        K = np.array([[30.0, 0, 15], [0, 30, 12], [0, 0, 1]])
        R = np.linalg.qr(drawn.random.normal(size=(3, 3)))[0]
        made = zproof.View.from_opencv(drawn.array(drawn.spoilt(K)), drawn.array(drawn.spoilt(R)),
                                       drawn.array(drawn.spoilt(np.ones(3))),
                                       placed["size"], placed["near"], placed["far"], placed["name"])
    for name in ("name", "size", "shape", "near", "far", "camera_from_world", "clip_from_camera"):
        repr(getattr(made, name))
    if made.is_perspective:
        made.opencv
    if max(made.size) <= 64:
        zproof.trace(a_scene(drawn), made)


def frames(drawn, _):
    made, seen = a_scene(drawn), a_view(drawn, drawn.one_of([(32, 24), (1, 1), (57, 3)]))
    for renderer in (zproof.render, zproof.trace):
        frame = renderer(drawn.word(made), drawn.word(seen))
        assert frame.id.shape == frame.depth.shape == seen.shape
        assert ((frame.id == zproof.BACKGROUND_ID) == np.isposinf(frame.depth)).all()
        frame._repr_html_()


PROMISES = ["opengl", "embree", "pytorch3d", "raster,subpixel_bits=4", {"kind": "raster", "subpixel_bits": 8},
            "webgl",
            "ray", "vtk", "d3d11", "cycles", "moeller-trumbore-float32", "raster,subpixel_bits=999",
            "raster,=", {"kind": None}, {"kind": "raster", 5: [1]}, {}, "plane_ray"]


def judge(drawn, folder):
    made, seen = a_scene(drawn), a_view(drawn)
    frame = zproof.render(made, seen)
    ids, depths = frame.id.copy(), drawn.spoilt(frame.depth.copy())
    if drawn.chance(0.5):
        places = drawn.random.random(ids.shape) < 0.05
        ids[places] = drawn.random.integers(0, 2**32, places.sum())
    labels = os.path.join(folder, "labels.json")
    with open(labels, "w", encoding="utf-8") as out:
        out.write(drawn.one_of(["[0]", "[]", "[-1]", '[{"count": 60, "label": 1}]',
                                '[{"count": 99999999999, "label": 1}]', "{"]))
    verdict = zproof.judge(
        drawn.word(made), drawn.word(seen), id=drawn.array(ids), depth=drawn.array(depths),
        precision=drawn.word(drawn.one_of(PROMISES)),
        ids=drawn.word("triangle") if drawn.chance(0.8) else drawn.one_of(
            ["material", "node", "primitive", "cryptomatte-object", "cryptomatte-material", "none", labels]))
    look_at(drawn, verdict)
    if drawn.chance(0.02):
        save(drawn, folder, verdict)


def look_at(drawn, verdict):
    assert sum(verdict.counts.values()) == verdict.classes.size
    assert verdict.proven == (verdict.defects == 0 and not verdict.counts["undecidable"]) == bool(verdict)
    for name in ("findings", "id", "depth", "view", "scene", "reference", "worst", "diagnosis"):
        repr(getattr(verdict, name))
    told = verdict.explain(drawn.number(3), drawn.number(5))
    repr(told), told.finding, [(t.id, t.bound, t.edge_distance_px) for t in told.triangles]
    if verdict.worst is not None:
        verdict.sentence(verdict.worst)
    verdict.sentence(drawn.word(told.finding)) if told.finding.class_name != "agree" else None
    verdict._repr_html_(), zproof.story_of_worst(verdict)


def save(drawn, folder, verdict):
    where = drawn.one_of([os.path.join(folder, "out"), "/proc/out", "/dev/null/out", 5])
    if drawn.chance(0.5):
        verdict.save(where)
    else:
        zproof.save_all({drawn.one_of(["a", "b", "", "a/b", "..", "a\0"]): verdict}, where)


def truth(drawn, _):
    made = a_scene(drawn)
    mean, half = zproof.filters.truth(drawn.word(made), drawn.word(a_view(drawn, (9, 7))),
                                      drawn.word(drawn.one_of(["N", "B", "G", "GN", "M", "BH"])),
                                      half_width=True)
    assert mean.shape == (7, 9, 3) and half.shape == (7, 9)


def assertion(drawn, _):
    made, seen = a_scene(drawn), a_view(drawn)
    frame = zproof.trace(made, seen)
    try:
        zproof.assert_proven(made, seen, id=drawn.array(frame.id.copy()),
                             depth=drawn.array(drawn.spoilt(frame.depth.copy())),
                             precision=drawn.word("embree"))
    except AssertionError as error:
        assert "pixels are defects" in str(error) or "undecided" in str(error)


def check(drawn, _):
    """Asks the program."""
    made, seen = a_scene(drawn), a_view(drawn, (9, 7))
    right = drawn.spoilt(drawn.random.random((7, 9, 3)).astype(np.float32))
    bool(zproof.filters.check(drawn.array(right), drawn.word("nearest"), drawn.word(made), drawn.word(seen),
                              precision=drawn.word(None)))


def study(drawn, _):
    """Asks the program."""
    made, seen = a_scene(drawn), a_view(drawn, (9, 7))
    right = drawn.spoilt(drawn.random.random((7, 9, 3)).astype(np.float32))
    table = zproof.filters.run(drawn.word(["nearest"]), drawn.word(made), drawn.word(seen),
                               truth=drawn.word("B"),
                               pictures={drawn.word("mine"): drawn.array(right)},
                               flicker=drawn.word(0))
    table._repr_html_(), table.rows(method="nearest")


def picture(drawn, folder):
    right = drawn.spoilt(drawn.random.random((7, 9, 3)).astype(np.float32))
    _zproof.save_picture(drawn.word(os.path.join(folder, "picture.exr")), drawn.array(right))


def saved_scene(drawn, folder):
    _zproof.save_scene(drawn.word(a_scene(drawn)), drawn.word([drawn.word(a_view(drawn))]),
                       drawn.word(folder))


def constants(drawn, _):
    _zproof.is_defect(drawn.number(3))
    for kind in (zproof.Verdict, zproof.Frame, zproof.View, zproof.Finding, zproof.Explanation):
        try:
            kind(*[drawn.word(1)] * drawn.random.integers(3))
        except TypeError:
            continue
        raise AssertionError(f"{kind} was made from nothing")


FUNCTIONS = {"scene": scene, "load": load, "view": view, "frames": frames, "judge": judge, "truth": truth,
             "picture": picture,
             "saved_scene": saved_scene, "constants": constants, "assertion": assertion, "check": check,
             "study": study}
SHARES = {"judge": 12, "view": 6, "scene": 6, "load": 4, "frames": 2, "truth": 2, "picture": 2,
          "assertion": 2}


def drawn_rounds(asked, folder):
    """All rounds, in this process. The round is written down before it begins."""
    faulthandler.enable()
    warnings.simplefilter("ignore")
    os.chdir(folder)  # what a strange path names lies here
    lots = [asked.only] if asked.only else [name for name in FUNCTIONS for _ in range(SHARES.get(name, 1))]
    outcomes = collections.Counter()
    for number in range(asked.first, asked.first + asked.rounds):
        drawn = Drawn(asked.seed, number)
        name = drawn.one_of(lots)
        with open(os.path.join(folder, ROUND), "w", encoding="utf-8") as last:
            last.write(f"{name}: repeat with --seed {asked.seed} --rounds 1 --first {number}"
                       + (f" --only {name}" if asked.only else ""))
        try:
            FUNCTIONS[name](drawn, folder)
            outcomes[name, "taken"] += 1
        except ALLOWED as error:
            outcomes[name, type(error).__name__] += 1
    for (name, outcome), count in sorted(outcomes.items()):
        print(f"{name:12} {outcome:20} {count:6}")


def main():
    words = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    words.add_argument("--seed", type=int, default=1)
    words.add_argument("--rounds", type=int, default=2000)
    words.add_argument("--first", type=int, default=0, help="number of the first round")
    words.add_argument("--only", choices=FUNCTIONS)
    words.add_argument("--folder", help=argparse.SUPPRESS)  # of the process that draws
    asked = words.parse_args()
    if asked.folder:
        drawn_rounds(asked, asked.folder)
        return
    os.environ.setdefault("ZPROOF_ORACLE", "none")
    with tempfile.TemporaryDirectory() as folder:
        status = subprocess.run([sys.executable, os.path.abspath(__file__), *sys.argv[1:], "--folder",
                                 folder],
                                check=False).returncode
        if status:
            with open(os.path.join(folder, ROUND), encoding="utf-8") as last:
                sys.exit(f"exit status {status}: {last.read()}")


if __name__ == "__main__":
    main()
