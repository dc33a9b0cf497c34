"""Texture filters held against the exact area integral. The studies and checks are those of the program, which is
looked for on PATH, or is the one that ZPROOF_PROGRAM names."""

import csv
import json
import os
import re
import shutil
import subprocess
import tempfile
import weakref

import numpy

from zproof import _zproof

_KEY = ["scene", "view", "width", "height", "method", "truth", "region"]  # of filters.csv
_WHOLE_NUMBERS = {"width", "height"}


class _Study:
    """Where a study's pictures lie, and its views as filters.json has them. A folder of its own goes with it."""

    def __init__(self, folder):
        self.folder, self.views = os.fspath(folder) if folder is not None else None, []
        if folder is None:
            scratch = tempfile.mkdtemp()
            weakref.finalize(self, shutil.rmtree, scratch, ignore_errors=True)
            self.folder = os.path.join(scratch, "study")

    def file(self, name):
        return os.path.join(self.folder, name)


class Table(dict):
    """A study's figures: {column: numpy array}, a row for each scene, view, method and region. `folder` is where the
    study lies, with its pictures and page; None where it was not kept. `outside` counts the pixels of pictures with a
    claim that their method does not permit: {(scene, view, picture): pixels}. picture(), error() and truth() are there
    as long as the table, or rows of it, is."""

    folder = None
    outside = {}
    _study = None

    def __len__(self):
        """Rows."""
        return len(next(iter(self.values()), ()))

    def rows(self, **wanted):
        """The rows whose columns have these values: table.rows(region="interior", method="nearest")."""
        chosen = numpy.ones(len(self), bool)
        for column, value in wanted.items():
            chosen &= self[column] == value
        part = Table({name: values[chosen] for name, values in self.items()})
        part.folder, part.outside, part._study = self.folder, self.outside, self._study
        return part

    def truth(self, *, scene=None, view=None):
        """The truth of a view: float32 (height, width, 3), linear light. Scene and view may be left out where there is
        one. Raises ValueError."""
        return self._picture(scene, view, None)

    def picture(self, method, *, scene=None, view=None):
        """What the method, or a picture of that name, shows; as truth()."""
        return self._picture(scene, view, method)

    def error(self, method, *, scene=None, view=None):
        """picture() less truth()."""
        return self.picture(method, scene=scene, view=view) - self.truth(scene=scene, view=view)

    def _picture(self, scene, view, method):
        if self._study is None:
            raise ValueError("this table has no pictures: it does not come from run()")
        views = self._study.views
        fitting = [one for one in views if scene in (None, one["scene"]) and view in (None, one["view"])]
        if len(fitting) != 1:
            known = ", ".join(f"{one['scene']} / {one['view']}" for one in views)
            raise ValueError(f"scene {scene!r}, view {view!r}: {len(fitting)} views fit; expected one of {known}")
        files = {one["method"]: one["file"] for one in fitting[0]["methods"]}
        if method is not None and method not in files:
            raise ValueError(f"method {method!r}: not in the study; expected one of {', '.join(files)}")
        return _zproof.load_picture(self._study.file(fitting[0]["truth_file"] if method is None else files[method]))


class Check:
    """What the reference of a method says of a picture. True where the picture keeps to the method's definition, and
    a picture with a defect of half a texel or level would not.

    outcome: "passed", "failed" or "nothing" (docs/filter-conformance.md, "Power"). outside, pixels, undecided: counts.
    slack: by what factor the widest-missing range would have to be widened; 1 or less: none. worst: (x, y) of that
    pixel, or None. permitted_width: mean width of what is permitted, float64 (3,). causes: definitions of which the
    picture is the right picture. chance: {test, z, limit} of a stochastic method, or None.
    offsets: {name: {value, interval, promised, unit, leaves_promise, log2_chance}}, by which the whole picture is off;
    the interval is three standard errors on either side, both None where they are not told. nearer_alternatives: other
    arithmetic that the picture is nearer to.
    power: {would_refuse, would_not_refuse, unproven, settings_that_prove: lists of str, wide_share: float}, or None of
    a picture that failed. text: all of it in words."""

    def __init__(self, told):
        joint = told.get("joint") or {}
        self.outcome, self.text = told["outcome"], told["text"].strip()
        self.outside, self.pixels, self.undecided = told["outside"], told["pixels"], told["undecided"]
        self.slack = numpy.inf if told["slack"] is None else told["slack"]
        self.worst = told["worst"] and tuple(told["worst"])
        self.permitted_width = numpy.array(told["permitted_width"], float)
        self.causes, self.chance, self.power = told["causes"], told.get("chance"), told.get("power")
        self.offsets = {one["name"]: {key: value for key, value in one.items() if key != "name"}
                        for one in joint.get("offsets", [])}
        for offset in self.offsets.values():
            offset["interval"] = offset["interval"] and tuple(offset["interval"])
        self.nearer_alternatives = joint.get("nearer_alternatives", [])

    @property
    def passed(self):
        return self.outcome == "passed"

    def __bool__(self):
        return self.passed

    def __repr__(self):
        return self.text


def truth(scene, view, reconstruction="N", *, half_width=False):
    """The mean of the visible surfaces' albedo over each pixel, in linear light: float32 (height, width, 3).

    reconstruction: "N" (texels are squares), "B" (bilinear), "G" (bilinear, under a Gaussian), "GN", "M" (bilinear,
    under Mitchell's filter: values may leave 0 to 1) or "BH" (bilinear, under the Blackman-Harris filter). See
    docs/area-integral.md. With half_width=True a tuple: the truth, and half the 95 % confidence interval of each
    pixel's worst channel, or the integral's bound; float32 (height, width). Raises ValueError.
    """
    mean, half = _zproof.truth(scene, view, reconstruction)
    return (mean, half) if half_width else mean


def paint(method, scene, view, *, batch=1 << 16):
    """The picture that a texture filter of one's own makes of a view: float32 (height, width, 3), linear light.

    method(coordinates, jacobian, levels) -> colours is called with at most `batch` pixels of one texture at a time:
    coordinates: float64 (n, 2), u and v of the pixels' centres in texels of level 0, whose texel (0, 0) covers [0, 1).
    jacobian: float64 (n, 2, 2), [[du/dx, du/dy], [dv/dx, dv/dy]] in texels per pixel.
    levels: the box mip chain, float32 (rows, columns, 3) each, linear light; level 0 is the texture.
    colours: (n, 3), linear light. What lies beyond an edge is the method's to decide: textures of Scene() repeat.

    Which surface a pixel shows is decided in exact geometry, as for zproof's own methods. Raises ValueError.
    """
    picture, textures = _zproof.filter_task(scene, view)
    flat = picture.reshape(-1, 3)
    for pixels, coordinates, jacobian, levels in textures:
        for first in range(0, len(pixels), batch):
            part = slice(first, first + batch)
            colours = numpy.asarray(method(coordinates[part], jacobian[part], levels))
            if colours.shape != (len(pixels[part]), 3):
                raise ValueError(f"the method gave {colours.shape} for {len(pixels[part])} pixels; expected "
                                 f"({len(pixels[part])}, 3)")
            flat[pixels[part]] *= colours
    return picture.astype(numpy.float32)


def run(methods, scene, view=None, *, own=None, pictures=None, claims=None, precision=None, truth="N", size=None, flicker=2,
        folder=None):
    """A study: methods and pictures of one's own, held against the truth.

    methods: a list of names with settings, ["nearest", "trilinear-gl:bias=0.5"] (`zproof filters list`).
    scene: a Scene with uv and texture, then with a view; or the name of a filter scene or a model file, then with the
    name of a view or None for all.
    own: {name: a method of one's own, as paint() takes it}, of a Scene and a view. They stand beside the methods as
    pictures do, and may have claims.
    pictures: {name: float32 (height, width, 3)}, linear light, of one view. truth: as in truth().
    claims: {name of a picture: the method that it claims to be of}; `precision`, as in check(), is promised of them.
    size: (width, height) of named scenes. flicker: further views, each a fraction of a pixel on.
    folder: where to keep the study; None: nowhere.

    Without truth and flicker it is the study that `zproof filters run` makes. Returns a Table. Raises ValueError for arguments that are not usable, RuntimeError with the program's words.
    """
    if isinstance(methods, str):
        raise TypeError(f"methods is the text {methods!r}; expected a list of names, [{methods!r}]")
    study = _Study(folder)
    with tempfile.TemporaryDirectory() as scratch:
        words = ["filters", "run", *_scene_words(scene, view, size, scratch)]
        words += ["--methods", ",".join(methods), "--truth", truth, "--flicker", str(flicker), "-o", study.folder]
        if not isinstance(pictures or {}, dict):
            raise TypeError(f"pictures is a {type(pictures).__name__}; expected a dict of names and arrays")
        for name, picture in {**(pictures or {}), **_painted(own or {}, pictures or {}, scene, view)}.items():
            words += ["--picture", f"{name}={_picture_file(picture, scratch, name)}"]
        for name, method in (claims or {}).items():
            words += ["--claim", f"{name}={method}"]
        if precision is not None:
            words += ["--precision", precision]
        _program([*words, "--quiet"], {0})
    with open(study.file("filters.json"), encoding="utf-8") as text:
        study.views = json.load(text)["views"]
    table = _table(study.file("filters.csv"))
    table.folder = None if folder is None else study.folder
    table.outside = _pixels_outside(study.views)
    table._study = study
    return table


def check(picture, method, scene, view, *, precision=None, size=None):
    """Does a picture compute its method's own definition?

    picture: float32 (height, width, 3), linear light, of that view. method: a name with settings. scene, view: as in
    run(). precision: what the filter promises ("gpu", "gpu,lod_bits=6", docs/joint-conformance.md); None: as exact as
    zproof's own filters.

    Returns a Check. Raises ValueError, and RuntimeError with the program's words.
    """
    with tempfile.TemporaryDirectory() as scratch:
        words = ["filters", "check", method, *_scene_words(scene, view, size, scratch)]
        words += ["--picture", _picture_file(picture, scratch, "picture")]
        if precision is not None:
            words += ["--precision", precision]
        told = json.loads(_program([*words, "--json"], {0, 1, 3}).stdout)
        return Check(told["pictures"][0])


def _painted(own, pictures, scene, view):
    if own and not (isinstance(scene, _zproof.Scene) and isinstance(view, _zproof.View)):
        raise ValueError("own: a method of one's own expects a zproof.Scene and a zproof.View")
    for name in own.keys() & pictures.keys():
        raise ValueError(f"own: {name!r} is the name of a picture, too")
    return {name: paint(method, scene, view) for name, method in own.items()}


def _scene_words(scene, view, size, scratch):
    if isinstance(scene, _zproof.Scene):
        if not isinstance(view, _zproof.View):
            raise ValueError(f"view is a {type(view).__name__}; expected a zproof.View beside a zproof.Scene")
        _zproof.save_scene(scene, [view], scratch)
        return [os.path.join(scratch, f"{scene.name}.view.json")]
    words = [os.fspath(scene)]
    if view is not None:
        words += ["--view", view]
    if size is not None:
        words += ["--width", str(size[0]), "--height", str(size[1])]
    return words


def _picture_file(picture, scratch, name):
    if not re.fullmatch(r"[A-Za-z0-9_.-]+", name):
        raise ValueError(f"picture {name!r}: expected a name of letters, digits, '-', '_', '.'")
    file = os.path.join(scratch, f"{name}.exr")
    _zproof.save_picture(file, picture)
    return file


def _program(words, expected):
    program = os.environ.get("ZPROOF_PROGRAM") or "zproof"
    try:
        done = subprocess.run([program, *words], capture_output=True, text=True, check=False)
    except FileNotFoundError:
        raise RuntimeError(f"{program} is not found; install zproof, or name its file in ZPROOF_PROGRAM") from None
    if done.returncode not in expected or not done.stdout:
        last = done.stderr.strip() or done.stdout.strip()
        raise RuntimeError(f"zproof {words[0]} {words[1]}: exit status {done.returncode}: {last}")
    return done


def _pixels_outside(views):
    return {(view["scene"], view["view"], method["method"]): method["claim"]["pixels_outside"]
            for view in views for method in view["methods"] if "claim" in method}


def _table(file):
    """A row for each scene, view, method, truth and region; a column for each metric. Costs and flicker are of the
    pixels that show a texture; `pixels` tells of how many the errors are."""
    with open(file, newline="", encoding="utf-8") as text:
        values = list(csv.DictReader(line for line in text if not line.startswith("#")))
    rows = {}
    for value in values:
        key = tuple(value[column] for column in _KEY)
        row = rows.setdefault(key, {name: value[name] for name in ("pixels", "truth_half_width")})
        row[value["metric"]] = value["value"]
    metrics = list(dict.fromkeys(metric for row in rows.values() for metric in row))
    table = Table()
    for i, column in enumerate(_KEY):
        table[column] = numpy.array([key[i] for key in rows], dtype=int if column in _WHOLE_NUMBERS else None)
    for metric in metrics:
        values_of_metric = [float(row.get(metric) or "nan") for row in rows.values()]
        table[metric] = numpy.array(values_of_metric, dtype=int if metric == "pixels" else float)
    return table
