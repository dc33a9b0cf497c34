"""The stubs (.pyi) have the names, parameters and types of the module itself."""
import ast
import importlib
import inspect
import pathlib
import re

import numpy as np
import pytest

import zproof
from zproof import _zproof, filters, judging

PACKAGE = pathlib.Path(__file__).resolve().parents[1] / "zproof"
MODULES = {"__init__": zproof, "_zproof": _zproof, "filters": filters, "judging": judging}
SPECIAL = {"__init__", "__bool__", "__len__", "_repr_html_"}  # methods that a stub has beside the public ones


def stub(name):
    return ast.parse((PACKAGE / f"{name}.pyi").read_text(encoding="utf-8"))


# --- what a stub says ---

def stub_names(body):
    """{public name: its node} of a module or a class; of overloads the last."""
    names = {}
    for node in body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            names[node.name] = node
        elif isinstance(node, ast.AnnAssign):
            names[node.target.id] = node
        elif isinstance(node, ast.ImportFrom):
            names.update({alias.asname: node for alias in node.names if alias.asname})
    return {name: node for name, node in names.items() if not name.startswith("_") or name in SPECIAL}


def decorators(node):
    return {decorator.id for decorator in node.decorator_list}


def stub_parameters(node):
    """[(name, is keyword only, default as text or None)]; self is left out."""
    a = node.args
    positional = [*a.posonlyargs, *a.args]
    defaults = [None] * (len(positional) - len(a.defaults)) + list(a.defaults)
    found = [(p.arg, False, d) for p, d in zip(positional, defaults)]
    found += [(p.arg, True, d) for p, d in zip(a.kwonlyargs, a.kw_defaults)]
    found += [("**" + a.kwarg.arg, True, None)] if a.kwarg else []
    return [(name, kind, None if d is None else ast.unparse(d)) for name, kind, d in found if name != "self"]


# --- what the module has ---

def bound_parameters(function):
    """The same of a function of the extension, whose docstring begins with its signature."""
    signature = re.match(r"\w+\((.*)\) -> .*", function.__doc__.splitlines()[0])[1]
    found = stub_parameters(ast.parse(f"def f({signature.replace('inf', '...')}): ...").body[0])
    return [parameter for parameter in found if parameter[0] != "self"]


def python_parameters(function):
    found = []
    for p in inspect.signature(function).parameters.values():
        name = "**" + p.name if p.kind is p.VAR_KEYWORD else p.name
        is_keyword = p.kind in (p.KEYWORD_ONLY, p.VAR_KEYWORD)
        found.append((name, is_keyword, None if p.default is p.empty else repr(p.default)))
    return [parameter for parameter in found if parameter[0] != "self"]


def module_parameters(function):
    is_python = inspect.isfunction(function)
    return python_parameters(function) if is_python else bound_parameters(function)


def module_names(module):
    if module is zproof:
        return {name for name in module.__all__ if not name.startswith("_")}
    own = {name for name, value in vars(module).items() if not inspect.ismodule(value)}
    return {name for name in own if not name.startswith("_")}


def class_names(cls):
    return {name for name in vars(cls) if not name.startswith("_") or name in SPECIAL}


# --- they agree ---

def test_every_module_of_the_package_is_public_or_named_here():
    others = {"notebook", "pytest_plugin"}  # notebook: what classes show; the plugin: a fixture
    assert {file.stem for file in PACKAGE.glob("*.py")} - others == set(MODULES) - {"_zproof"}
    assert {file.stem for file in PACKAGE.glob("*.pyi")} == set(MODULES)
    assert (PACKAGE / "py.typed").is_file()


@pytest.mark.parametrize("name", MODULES)
def test_names(name):
    assert set(stub_names(stub(name).body)) == module_names(MODULES[name])


def test_the_package_has_what_the_stub_takes_from_elsewhere():
    for node in stub("__init__").body:
        if isinstance(node, ast.ImportFrom):
            for alias in node.names:
                home = importlib.import_module(node.module)
                assert getattr(zproof, alias.asname) is getattr(home, alias.name)


FUNCTIONS = [(name, function) for name, module in MODULES.items() if name != "__init__"
             for function in stub_names(stub(name).body)
             if callable(getattr(module, function)) and not inspect.isclass(getattr(module, function))]
CLASSES = [(name, cls) for name, module in MODULES.items() if name != "__init__"
           for cls in stub_names(stub(name).body) if inspect.isclass(getattr(module, cls))]


@pytest.mark.parametrize("module, function", FUNCTIONS)
def test_parameters(module, function):
    for node in stub(module).body:  # each overload
        if isinstance(node, ast.FunctionDef) and node.name == function:
            said, has = stub_parameters(node), module_parameters(getattr(MODULES[module], function))
            if "overload" in decorators(node):  # Literal[True] has no default
                said, has = [[parameter[:2] for parameter in found] for found in (said, has)]
            assert said == has


CHECKED = {"outcome": "passed", "text": "", "outside": 0, "pixels": 1, "undecided": 0, "slack": 0, "worst": None,
           "permitted_width": [0, 0, 0], "causes": []}  # as zproof filters check --json prints it


@pytest.mark.parametrize("module, cls", CLASSES)
def test_members(module, cls):
    node, real = stub_names(stub(module).body)[cls], getattr(MODULES[module], cls)
    said = stub_names(node.body)
    if "__init__" not in said:  # made by zproof alone
        assert module == "_zproof" or cls == "Table" or issubclass(real, Exception)
    has = class_names(real) - ({"__init__"} - set(said))
    instance_values = set(vars(filters.Check(CHECKED))) if cls == "Check" else set()
    assert set(said) == has | instance_values
    for name, member in said.items():
        if isinstance(member, ast.AnnAssign):
            continue
        found = inspect.getattr_static(real, name)
        assert isinstance(found, property) == ("property" in decorators(member)), name
        assert isinstance(found, staticmethod) == ("staticmethod" in decorators(member)), name
        if not isinstance(found, property) and name not in ("__bool__", "__len__", "_repr_html_"):
            assert stub_parameters(member) == module_parameters(getattr(real, name)), name


# --- types, of a verdict and all that hangs on it ---

def is_of(value, annotation):
    """Has the value the type that the stub says? annotation: a node of the stub."""
    if isinstance(annotation, ast.BinOp):
        return is_of(value, annotation.left) or is_of(value, annotation.right)
    if isinstance(annotation, ast.Constant):
        return value is annotation.value
    if isinstance(annotation, ast.Name):
        known = {"int": int, "float": float, "bool": bool, "str": str, **vars(_zproof)}
        return type(value) is known[annotation.id]  # bool is no int here
    kind, parts = annotation.value.id, annotation.slice
    if kind == "Final":
        return is_of(value, parts)
    parts = parts.elts if isinstance(parts, ast.Tuple) else [parts]
    if kind == "NDArray":
        return isinstance(value, np.ndarray) and value.dtype.type is getattr(np, parts[0].attr)
    if kind == "list":
        return isinstance(value, list) and all(is_of(v, parts[0]) for v in value)
    if kind == "dict":
        pairs = value.items() if isinstance(value, dict) else [(None, None)]
        return all(is_of(k, parts[0]) and is_of(v, parts[1]) for k, v in pairs)
    if kind == "tuple":
        if ast.unparse(parts[-1]) == "...":
            return isinstance(value, tuple) and all(is_of(v, parts[0]) for v in value)
        return isinstance(value, tuple) and len(value) == len(parts) and all(map(is_of, value, parts))
    raise AssertionError(f"a type that this test does not know: {ast.unparse(annotation)}")


@pytest.fixture(scope="module")
def objects():
    """One of each class, and where no defect is, another verdict."""
    scene = zproof.load("coplanar", (40, 30))
    view = scene.views["ahead"]
    frame = zproof.trace(scene, view)
    right = zproof.judge(scene, view, id=frame.id, depth=frame.depth, precision="embree")
    wrong = zproof.judge(scene, view, id=np.roll(frame.id, 3), depth=frame.depth, precision="embree")
    y, x = (int(i) for i in np.argwhere(frame.id != zproof.BACKGROUND_ID)[0])
    story = wrong.explain(x, y)
    assert right.worst is None and story.triangles
    return {"Scene": [scene], "View": [view], "Frame": [frame], "Verdict": [right, wrong],
            "Finding": [wrong.worst], "Explanation": [story], "NearTriangle": story.triangles,
            "Diagnosis": [wrong.diagnosis]}


def test_types_of_properties(objects):
    tried = 0
    for cls, node in stub_names(stub("_zproof").body).items():
        for name, member in stub_names(node.body).items() if isinstance(node, ast.ClassDef) else ():
            if "property" in decorators(member):
                for instance in objects[cls]:
                    value = getattr(instance, name)
                    assert is_of(value, member.returns), f"{cls}.{name}: {type(value)}, {value!r}"
                    tried += 1
    assert tried > 50


def test_types_of_what_functions_return(objects):
    (scene,), (view,), (frame,) = objects["Scene"], objects["View"], objects["Frame"]
    verdict = objects["Verdict"][1]
    ids_and_depth = {"id": frame.id, "depth": frame.depth, "precision": "embree"}
    returned = {
        ("judging", "judge"): judging.judge(scene, view, **ids_and_depth),
        ("judging", "assert_proven"): judging.assert_proven(scene, view, **ids_and_depth),
        ("judging", "summary"): judging.summary(verdict),
        ("judging", "story_of_worst"): judging.story_of_worst(verdict),
        ("judging", "failure_text"): judging.failure_text(verdict),
        ("judging", "precision_word"): judging.precision_word({"kind": "raster", "subpixel_bits": 4}),
        ("_zproof", "render"): zproof.render(scene, view),
        ("_zproof", "is_defect"): _zproof.is_defect(0),
        ("_zproof", "truth"): _zproof.truth(scene, view, "B"),
    }
    for (module, function), value in returned.items():
        assert is_of(value, stub_names(stub(module).body)[function].returns), function


def test_types_of_constants():
    nodes = stub_names(stub("_zproof").body)
    for name in ("BACKGROUND_ID", "CLASS_NAMES", "CLASS_COLOURS"):
        assert is_of(getattr(zproof, name), nodes[name].annotation), name
