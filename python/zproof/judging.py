"""The judge, as Python calls it."""

import difflib
import numbers
import os

import numpy

from zproof import _zproof


def precision_word(precision):
    """A promise in one word, as `zproof --precision` takes it.

    precision: a preset's name ("opengl", docs/presets.md), words ("raster,subpixel_bits=4"), the path of a JSON
    file, or a dict of the same keys: {"kind": "raster", "subpixel_bits": 4}. Raises ValueError for anything else.
    """
    if isinstance(precision, dict):
        keys = dict(precision)
        kind = keys.pop("kind", None)
        if kind is None:
            raise ValueError('precision: the dict has no "kind"; expected e.g. {"kind": "raster", "subpixel_bits": 4}')
        return ",".join([str(kind)] + [f"{key}={_value(key, value)}" for key, value in keys.items()])
    if isinstance(precision, (str, os.PathLike)):
        return os.fspath(precision)
    raise ValueError(f"precision is a {type(precision).__name__}; expected a str, a path or a dict")


def _value(key, value):
    if isinstance(value, (bool, numpy.bool_)):
        return str(value).lower()
    if isinstance(value, (str, numbers.Real)) and "," not in str(value):
        return str(value)
    raise ValueError(f"precision: {key!r} is {value!r}; expected a word, a number, True or False")


class _Views(dict):
    """A scene's views by name."""

    def __missing__(self, name):
        meant = self._nearest(name)
        raise KeyError(f"{name!r} is no view of the scene; expected one of: {', '.join(self)}"
                       + (f"; did you mean {meant!r}?" if meant else ""))

    def example(self, given):
        """How a view is named, for what was given instead; "" where the scene has none."""
        name = self._nearest(given) or next(iter(self), None)
        return "" if name is None else f", such as scene.views[{name!r}]"

    def _nearest(self, name):
        near = difflib.get_close_matches(name, self, 1) if isinstance(name, str) else []
        return near[0] if near else None


def judge(scene, view, *, id=None, depth=None, precision, ids="triangle"):
    """Judges what a renderer saw, pixel by pixel, beside Embree.

    id: uint32 (height, width), triangle indices, BACKGROUND_ID where nothing is seen; None: depth alone is judged.
    depth: float32 (height, width), along the view axis in scene units, +inf where nothing is seen; None: ids alone.
    Row 0 is at the top. Tensors that have __array__ or __dlpack__ are taken as they are. C-contiguous arrays are not
    copied, and the verdict refers to them: leave them as they are while you use it.
    precision: what the renderer promises, see precision_word(). ids: what the ids stand for, "triangle", or coarser
    "material", "node", "primitive", "cryptomatte-object", "cryptomatte-material", or a label file (docs/labels.md).

    Returns a Verdict. Raises ValueError for arrays of another dtype, shape, order or byte order, and for a precision or
    ids that are not known. The GIL is released while the judge works.
    """
    return _zproof.judge(scene, view, id, depth, precision_word(precision), os.fspath(ids))


def story_of_worst(verdict):
    """The story of the worst defect, several lines; of an undecidable pixel where there is no defect."""
    worst = verdict.worst
    if worst is not None:
        return verdict.explain(worst.x, worst.y).text
    undecidable = verdict.findings[verdict.findings["class"] == _zproof.CLASS_NAMES.index("undecidable")]
    if len(undecidable) == 0:
        return "no defect\n"
    return verdict.explain(int(undecidable[0]["x"]), int(undecidable[0]["y"])).text


def summary(verdict):
    """One line: "cam: 3 of 12,288 pixels are defects: 2 hidden, 1 outside"."""
    from zproof._zproof import CLASS_NAMES, is_defect

    pixels = verdict.classes.size
    if verdict.proven:
        return f"{verdict.view.name}: proven, {pixels:,} pixels"
    if verdict.defects == 0:
        return f"{verdict.view.name}: undecided, {verdict.counts['undecidable']:,} of {pixels:,} pixels"
    kinds = ", ".join(f"{verdict.counts[name]:,} {name}" for number, name in enumerate(CLASS_NAMES)
                      if is_defect(number) and verdict.counts[name])
    return f"{verdict.view.name}: {verdict.defects:,} of {pixels:,} pixels are defects: {kinds}"


def assert_proven(scene, view, *, id=None, depth=None, precision, ids="triangle"):
    """judge(), and AssertionError with the story of the worst pixel where the verdict is not `proven`."""
    verdict = judge(scene, view, id=id, depth=depth, precision=precision, ids=ids)
    if not verdict.proven:
        raise AssertionError(failure_text(verdict))
    return verdict


def failure_text(verdict):
    """The summary, the likely cause, and the story of the worst pixel."""
    diagnosis = verdict.diagnosis
    cause = f"{diagnosis}\n" if diagnosis else ""
    return f"{summary(verdict)}\n{cause}\n{story_of_worst(verdict)}"


def save_all(verdicts, folder):
    """One report of many verdicts: {name: Verdict}, each name the scene's in the report. See Verdict.save().

    Raises TypeError for anything but a dict, ValueError for a name that is no file's."""
    if not isinstance(verdicts, dict):
        raise TypeError(f"verdicts is a {type(verdicts).__name__}; expected a dict of names and Verdicts")
    _zproof.save_all(list(verdicts.items()), folder)
