"""Arrays of others: what is no C-contiguous array of the wanted dtype and shape gets one clear ValueError.
What is one is not copied."""

import ctypes
import gc
import os
import subprocess
import sys
import textwrap
import warnings
import weakref

import numpy as np
import pytest

import zproof
from small_scenes import HEIGHT, PRECISION, WIDTH, layers, traced, view

SHAPE = (HEIGHT, WIDTH)
_scene, _view = layers(), view()


def _judge(**arrays):
    return zproof.judge(_scene, _view, precision=PRECISION, **arrays)


def _scene_with(**changed):
    arrays = {"positions": np.zeros((3, 3), np.float32), "triangles": np.zeros((1, 3), np.uint32), **changed}
    return zproof.Scene(arrays.pop("positions"), arrays.pop("triangles"), **arrays)


# argument -> (a call that takes it, what is wanted of it)
_UV, _TEXTURE = np.zeros((3, 2), np.float32), np.zeros((4, 5, 4), np.uint8)
ARGUMENTS = {
    "id": (lambda a: _judge(id=a), np.zeros(SHAPE, np.uint32)),
    "depth": (lambda a: _judge(depth=a), np.ones(SHAPE, np.float32)),
    "positions": (lambda a: _scene_with(positions=a), np.zeros((3, 3), np.float32)),
    "triangles": (lambda a: _scene_with(triangles=a), np.zeros((4, 3), np.uint32)),
    "uv": (lambda a: _scene_with(uv=a), _UV),
    "texture": (lambda a: _scene_with(uv=_UV, texture=a), _TEXTURE),
    "picture": (lambda a: zproof.filters.check(a, "nearest", _scene, _view),
                np.zeros((*SHAPE, 3), np.float32)),
}
every_argument = pytest.mark.parametrize("name", ARGUMENTS)


def refused(name, value, *words):
    """The call's one line, which names the argument, what came and what is expected."""
    call, wanted = ARGUMENTS[name]
    with pytest.raises(ValueError) as raised:
        call(value)
    said = str(raised.value)
    assert said.startswith(f"{name} is "), said
    assert "\n" not in said and len(said) < 300, said
    assert f"expected {wanted.dtype} (" in said, said
    for word in words:
        assert word in said, said
    return said


def _shape_text(shape):
    return str(tuple(shape)).replace("L", "")


@every_argument
@pytest.mark.parametrize("dtype", ["bool", "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64",
                                   "uint64", "float16",
                                   "float32", "float64", "longdouble", "complex64", "M8[s]", "m8[s]", "S4",
                                   "U4", "V4", "O"])
def test_another_dtype_is_refused_and_the_right_one_named(name, dtype):
    wanted = ARGUMENTS[name][1]
    if np.dtype(dtype) == wanted.dtype:
        call, _ = ARGUMENTS[name]
        assert name == "picture" or call(wanted) is not None
        return
    refused(name, np.zeros(wanted.shape, dtype), str(np.dtype(dtype)), _shape_text(wanted.shape),
            f".astype(numpy.{wanted.dtype})")


@every_argument
def test_a_structured_dtype_is_refused(name):
    wanted = ARGUMENTS[name][1]
    refused(name, np.zeros(wanted.shape, [("a", wanted.dtype)]), "('a'")


@pytest.mark.parametrize("name", [n for n, (_, wanted) in ARGUMENTS.items() if wanted.itemsize > 1])
def test_the_other_byte_order_is_refused_as_such(name):
    wanted = ARGUMENTS[name][1]
    refused(name, wanted.astype(wanted.dtype.newbyteorder()), "its byte order is not this machine's",
            ".astype(")


def _other_shapes(shape):
    yield ()
    yield (0,)
    yield (int(np.prod(shape)),)
    yield (1, *shape)
    yield (*shape, 1)
    yield shape[:-1]
    yield (*shape[:-1], shape[-1] + 1)
    yield (*shape[:-1], 0)


@every_argument
def test_another_shape_is_refused_and_both_are_named(name):
    wanted = ARGUMENTS[name][1]
    for shape in _other_shapes(wanted.shape):
        refused(name, np.zeros(shape, wanted.dtype), str(wanted.dtype), _shape_text(shape))


@pytest.mark.parametrize("name", ["id", "depth"])
def test_rows_and_columns_are_not_exchanged(name):
    wanted = ARGUMENTS[name][1]
    refused(name, np.zeros((WIDTH, HEIGHT), wanted.dtype), f"({WIDTH}, {HEIGHT})",
            f"({HEIGHT}, {WIDTH}), the view's")


@every_argument
def test_a_huge_shape_that_takes_no_memory_is_refused(name):
    wanted = ARGUMENTS[name][1]
    one = np.zeros((1,) * wanted.ndim, wanted.dtype)
    for shape in [(2**40, 2**20), (2**31 + 1, 3), (2**33, 2, 4), (2**58, 1)]:
        refused(name, np.broadcast_to(np.zeros((), wanted.dtype), shape), _shape_text(shape))
    said = refused(name, np.broadcast_to(one, wanted.shape), "not C-contiguous", "numpy.ascontiguousarray()")
    assert "not aligned" not in said


@every_argument
def test_strides_other_than_by_rows_are_refused(name):
    wanted = ARGUMENTS[name][1]
    wider = np.zeros((*wanted.shape[:-1], 2 * wanted.shape[-1]), wanted.dtype)
    strided = {"every other": wider[..., ::2], "a part": wider[..., :wanted.shape[-1]],
               "from the end": wanted[::-1],
               "Fortran": np.asfortranarray(wanted), "transposed": np.ascontiguousarray(wanted.T).T}
    for array in strided.values():
        assert array.shape == wanted.shape and not array.flags.c_contiguous
        refused(name, array, "not C-contiguous", "numpy.ascontiguousarray() copies it")


@pytest.mark.parametrize("name", [n for n, (_, wanted) in ARGUMENTS.items() if wanted.itemsize > 1])
def test_an_address_that_is_not_aligned_is_refused(name):
    wanted = ARGUMENTS[name][1]
    array = np.zeros(wanted.nbytes + 1, np.uint8)[1:].view(wanted.dtype).reshape(wanted.shape)
    assert not array.flags.aligned
    refused(name, array, "not aligned", "numpy.ascontiguousarray() copies it")


@every_argument
@pytest.mark.parametrize("value", [0, 1.5, "words", b"bytes", [[0, 0, 0]], (1, 2), {}, object(), range(3), np,
                                   memoryview(b"1234")])
def test_what_is_no_array_is_refused_and_its_type_named(name, value):
    refused(name, value, f"is a {type(value).__name__}")


@every_argument
def test_a_scalar_of_numpy_is_refused(name):
    refused(name, ARGUMENTS[name][1].dtype.type(0), "()")


class Raises:
    def __init__(self, error):
        self.error = error

    def __array__(self, *_, **__):
        raise self.error


class Returns:
    def __init__(self, value):
        self.value = value

    def __array__(self, *_, **__):
        return self.value


@every_argument
@pytest.mark.parametrize("error", [TypeError("can't convert cuda:0 device type tensor to numpy"),
                                   RuntimeError("requires grad"),
                                   ValueError(), KeyError("k"), ZeroDivisionError()],
                         ids=lambda e: type(e).__name__)
def test_an_object_that_gives_no_array_is_refused_with_its_own_words(name, error):
    refused(name, Raises(error), "is a Raises that gives no array", str(error), ".detach().cpu()")


@every_argument
@pytest.mark.parametrize("value", [None, 5, "words", [1, 2], object()], ids=lambda v: type(v).__name__)
def test_an_object_whose_array_is_none_is_refused(name, value):
    refused(name, Returns(value), "is a Returns that gives no array")


@every_argument
def test_an_object_whose_array_is_another_is_refused_as_that(name):
    wanted = ARGUMENTS[name][1]
    refused(name, Returns(wanted.astype("complex128")), "complex128", ".astype(")
    refused(name, Returns(wanted[None]), _shape_text(wanted[None].shape))


@pytest.mark.parametrize("error", [KeyboardInterrupt, SystemExit, MemoryError])
def test_what_is_no_mistake_of_an_object_goes_on(error):
    with pytest.raises(error):
        _judge(id=Raises(error()))


class Tensor:
    """As torch's: DLPack, and not numpy's protocols."""

    def __init__(self, array, device_type=1):
        self._array, self._device_type = array, device_type  # 1: the processor's memory, 2: CUDA's

    def __dlpack__(self, **keys):
        capsule = self._array.__dlpack__(**keys)
        name_of, pointer = ctypes.pythonapi.PyCapsule_GetName, ctypes.pythonapi.PyCapsule_GetPointer
        name_of.restype, name_of.argtypes = ctypes.c_char_p, [ctypes.py_object]
        pointer.restype, pointer.argtypes = ctypes.c_void_p, [ctypes.py_object, ctypes.c_char_p]
        name = name_of(capsule)
        # numpy 2 asks for DLPack 1.0, where version, context, deleter and flags stand before DLTensor.
        before = {b"dltensor": 0, b"dltensor_versioned": 32}[name]
        device = pointer(capsule, name) + before + ctypes.sizeof(ctypes.c_void_p)  # behind `data`
        ctypes.c_int32.from_address(device).value = self._device_type
        return capsule

    def __dlpack_device__(self):
        return self._device_type, 0


@pytest.mark.parametrize("wrapped", [Tensor, Returns])
def test_a_tensor_is_judged_where_it_lies(wrapped):
    ids, depths = traced(_scene, _view)
    verdict = _judge(id=wrapped(ids), depth=wrapped(depths))
    assert verdict.proven
    assert verdict.id.ctypes.data == ids.ctypes.data
    assert verdict.depth.ctypes.data == depths.ctypes.data


def test_a_tensor_outlives_its_owner():
    ids, depths = traced(_scene, _view)
    verdict = _judge(id=Tensor(ids.copy()), depth=Tensor(depths.copy()))
    gc.collect()
    [np.full(SHAPE, 7, np.uint32) for _ in range(50)]  # takes the place of what was given back
    assert (verdict.id == ids).all() and (verdict.depth == depths).all()


@every_argument
def test_tensors_that_are_wrong_are_refused(name):
    wanted = ARGUMENTS[name][1]
    refused(name, Tensor(wanted.astype("int64")), "int64")
    refused(name, Tensor(wanted[None]), _shape_text(wanted[None].shape))
    refused(name, Tensor(np.asfortranarray(wanted)), "not C-contiguous")
    refused(name, Tensor(wanted.astype("O")), "is a Tensor that gives no array")
    refused(name, Tensor(5), "is a Tensor that gives no array")
    refused(name, Tensor(wanted, device_type=2), "is a Tensor that gives no array", ".detach().cpu()")


def test_subclasses_that_only_look_otherwise_are_judged():
    ids, depths = traced(_scene, _view)

    class Mine(np.ndarray):
        pass

    assert _judge(id=ids.view(Mine), depth=depths.view(Mine)).proven
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", PendingDeprecationWarning)  # numpy's word on its own class
        matrix = np.matrix(ids, copy=False)
    assert _judge(id=matrix).proven


def test_a_file_in_memory_is_judged_where_it_lies(tmp_path):
    ids, depths = traced(_scene, _view)
    np.save(tmp_path / "id.npy", ids)
    mapped = np.load(tmp_path / "id.npy", mmap_mode="r")
    verdict = _judge(id=mapped, depth=depths)
    assert verdict.proven and verdict.id.ctypes.data == mapped.ctypes.data


@pytest.mark.parametrize("name", ["id", "depth", "positions", "triangles"])
def test_a_masked_array_is_refused(name):
    wanted = ARGUMENTS[name][1]
    refused(name, np.ma.array(wanted, mask=np.ones(wanted.shape, bool)), "masked", ".filled(")


def test_read_only_arrays_are_judged():
    ids, depths = traced(_scene, _view)
    ids.flags.writeable = depths.flags.writeable = False
    verdict = _judge(id=ids, depth=depths)
    assert verdict.proven and verdict.id.ctypes.data == ids.ctypes.data
    frame = zproof.trace(_scene, _view)
    assert _judge(id=frame.id, depth=frame.depth).proven
    again = zproof.Scene(_scene.positions, _scene.triangles)
    assert (again.positions == _scene.positions).all()


def test_an_alias_of_the_dtype_is_the_dtype():
    ids, _ = traced(_scene, _view)
    for alias in (np.uintc, "I", "=u4", "u4", np.dtype("u4", metadata={"unit": "index"})):
        assert _judge(id=ids.astype(alias)).proven


NO_DEPTHS = [np.nan, -np.inf, -1, -1e-45, -3e38]


@pytest.mark.parametrize("value", NO_DEPTHS)
@pytest.mark.parametrize("place", ["surface", "background"])
def test_depths_that_are_none_are_judged_and_not_refused(value, place):
    ids, depths = traced(_scene, _view)
    y, x = (24, 30) if place == "surface" else (0, 0)
    assert (ids[y, x] == zproof.BACKGROUND_ID) == (place == "background")
    depths[y, x] = value
    verdict = _judge(id=ids, depth=depths)
    assert verdict.defects == 1
    assert (verdict.worst.x, verdict.worst.y) == (x, y)
    assert verdict.worst.class_name in ("invalid", "wrong_depth")
    if not np.isfinite(value) or place == "background":
        assert verdict.worst.class_name == "invalid"


def test_infinity_is_background_and_wrong_on_a_surface():
    ids, depths = traced(_scene, _view)
    depths[24, 30] = np.inf
    assert _judge(id=ids, depth=depths).worst.class_name == "wrong_depth"
    assert _judge(depth=depths).worst.class_name == "hole"


# ---- what is not copied, and what lives how long ----


def test_arrays_are_not_copied_on_the_way_in():
    ids, depths = traced(_scene, _view)
    verdict = _judge(id=ids, depth=depths)
    assert verdict.id.ctypes.data == ids.ctypes.data
    assert verdict.depth.ctypes.data == depths.ctypes.data


@pytest.mark.parametrize("name", ["id", "depth"])
def test_depth_alone_and_ids_alone_are_not_copied(name):
    array = dict(zip(("id", "depth"), traced(_scene, _view)))[name]
    assert getattr(_judge(**{name: array}), name).ctypes.data == array.ctypes.data


def _outputs():
    ids, depths = traced(_scene, _view)
    ids[0, 0] = 0
    verdict, frame = _judge(id=ids, depth=depths), zproof.trace(_scene, _view)
    return {"Frame.id": (frame, "id"), "Frame.depth": (frame, "depth"),
            "Verdict.classes": (verdict, "classes"),
            "Verdict.findings": (verdict, "findings"), "Verdict.id": (verdict, "id"),
            "Verdict.depth": (verdict, "depth"),
            "Scene.positions": (_scene, "positions"), "Scene.triangles": (_scene, "triangles")}


@pytest.mark.parametrize("name", _outputs())
def test_arrays_are_not_copied_on_the_way_out_and_are_read_only(name):
    owner, attribute = _outputs()[name]
    array = getattr(owner, attribute)
    assert len(array) > 0
    assert array.ctypes.data == getattr(owner, attribute).ctypes.data
    assert not array.flags.writeable and not array.flags.owndata and array.flags.c_contiguous
    with pytest.raises(ValueError):
        array[0] = array[0]
    with pytest.raises(ValueError):
        array.flags.writeable = True


@pytest.mark.parametrize("name", _outputs())
def test_an_array_outlives_its_owner(name):
    owner, attribute = _outputs()[name]
    if owner is _scene:
        owner = layers()
    array = getattr(owner, attribute)
    before = array.tobytes()
    del owner
    gc.collect()
    [np.full(array.nbytes, 255, np.uint8) for _ in range(50)]  # takes the place of what was given back
    assert array.tobytes() == before


def test_a_verdict_keeps_its_arrays_and_lets_them_go():
    ids, depths = traced(_scene, _view)
    of_ids, of_depths = weakref.ref(ids), weakref.ref(depths)
    verdict = _judge(id=ids, depth=depths)
    classes = verdict.classes
    del ids, depths
    gc.collect()
    assert of_ids() is not None and of_depths() is not None
    del verdict
    gc.collect()
    assert of_ids() is not None, "an array of the verdict is still there"
    del classes
    gc.collect()
    assert of_ids() is None and of_depths() is None


def test_a_verdict_outlives_scene_view_and_arrays():
    def judged():
        scene, seen_from = layers(), view(name="gone")
        ids, depths = traced(scene, seen_from)
        ids[24, 30] = 3
        return zproof.judge(scene, seen_from, id=ids, depth=depths, precision=PRECISION)

    verdict = judged()
    gc.collect()
    [np.full(SHAPE, 7, np.uint32) for _ in range(50)]
    assert verdict.counts == judged().counts
    assert "pixel (30, 24): hidden" in verdict.explain(30, 24).text
    assert verdict.scene.triangle_count == 4 and verdict.view.name == "gone"
    assert verdict.reference.id[24, 30] in (0, 1)


def test_a_refused_call_keeps_nothing():
    ids = np.zeros(SHAPE, np.uint32)
    of_ids = weakref.ref(ids)
    with pytest.raises(ValueError):
        _judge(id=ids, depth=np.zeros(5))
    del ids
    gc.collect()
    assert of_ids() is None


def test_a_scene_copies_its_arrays():
    positions, triangles = _scene.positions.copy(), _scene.triangles.copy()
    scene = zproof.Scene(positions, triangles)
    assert scene.positions.ctypes.data != positions.ctypes.data
    positions[:], triangles[:] = 9, 0
    assert (scene.positions == _scene.positions).all() and (scene.triangles == _scene.triangles).all()


def _status_of(program):
    """(exit status, what came out) of a Python of its own: what it does may end it."""
    setting = """
        import numpy as np, zproof
        from small_scenes import PRECISION, layers, traced, view
        scene, seen_from = layers(), view()
        ids, depths = traced(scene, seen_from)
        verdict = zproof.judge(scene, seen_from, id=ids, depth=depths, precision=PRECISION)
        nothing = zproof.Scene(np.zeros((0, 3), np.float32), np.zeros((0, 3), np.uint32))
        try:
            {program}
        except (ValueError, TypeError, RuntimeError) as error:
            print(type(error).__name__)
    """
    done = subprocess.run([sys.executable, "-c", textwrap.dedent(setting).format(program=program)],
                          cwd=os.path.dirname(__file__), capture_output=True, text=True, check=False)
    return done.returncode, done.stdout.strip()


@pytest.mark.parametrize("program", ["repr(zproof.Verdict.__new__(zproof.Verdict))",
                                     "zproof.save_all({'a': None}, '/nowhere/folder')",
                                     "high = zproof.load('near_plane', (1, 32769)); "
                                     "zproof.render(high, high.views['ahead'])"])
def test_what_would_crash_is_refused(program):
    status, said = _status_of(program)
    assert status == 0 and said in ("TypeError", "ValueError", "InputError")


def test_ids_in_a_scene_of_nothing_have_a_diagnosis():
    program = ("ids[:], depths[:], ids[5, 3] = zproof.BACKGROUND_ID, np.inf, 7; "
               "verdict = zproof.judge(nothing, seen_from, id=ids, depth=depths, precision='opengl'); "
               "print(verdict.diagnosis.defects)")
    assert _status_of(program) == (0, "1")


def test_objects_are_not_pickled():
    for program in ("__import__('pickle').dumps(verdict)", "__import__('copy').copy(scene)"):
        assert _status_of(program) == (0, "TypeError")
