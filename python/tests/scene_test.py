"""Scenes and views: what is refused, and whether a camera by OpenCV's conventions sees what OpenCV's formula
says."""

import numpy as np
import pytest

import zproof
from small_scenes import PRECISION, layers, random_mesh, traced, view

TRIANGLE = (np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], np.float32), np.array([[0, 1, 2]], np.uint32))


def refused(call, *words):
    with pytest.raises(ValueError) as raised:
        call()
    said = str(raised.value)
    assert "\n" not in said and len(said) < 300, said
    for word in words:
        assert word in said, said


# ---- scenes ----


def test_a_scene_holds_what_it_was_given():
    positions, triangles = random_mesh(1)
    scene = zproof.Scene(positions, triangles, name="mine")
    assert (scene.positions == positions).all() and (scene.triangles == triangles).all()
    assert (scene.vertex_count, scene.triangle_count) == (len(positions), len(triangles))
    assert scene.name == "mine" and scene.views == {} and scene.notes == []
    assert "mine" in repr(scene) and str(len(triangles)) in repr(scene)


@pytest.mark.parametrize("index", [3, 4, 2**31, 2**32 - 1])
def test_an_index_beyond_the_positions_is_refused(index):
    positions, triangles = TRIANGLE
    wrong = np.concatenate([triangles, triangles])
    wrong[1, 2] = index
    refused(lambda: zproof.Scene(positions, wrong), "triangle 1", str(index), "there are 3")


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 1.1e11, -3e38])
@pytest.mark.parametrize("place", [(0, 0), (1, 2), (2, 1)])
def test_a_position_that_is_not_judged_is_refused(value, place):
    positions = TRIANGLE[0].copy()
    positions[place] = value
    refused(lambda: zproof.Scene(positions, TRIANGLE[1], name="mine"), f"vertex {place[0]}", "mine", "1e+11")


def test_a_position_that_is_just_judged_is_taken():
    positions = TRIANGLE[0].copy()
    positions[2, 1] = 0.999e11
    assert zproof.Scene(positions, TRIANGLE[1]).positions[2, 1] == np.float32(0.999e11)


def test_a_scene_of_nothing_shows_background():
    nothing = zproof.Scene(np.zeros((0, 3), np.float32), np.zeros((0, 3), np.uint32))
    assert nothing.triangle_count == 0 and nothing.positions.shape == nothing.triangles.shape == (0, 3)
    ids, depths = traced(nothing, view())
    assert (ids == zproof.BACKGROUND_ID).all() and np.isposinf(depths).all()
    assert zproof.judge(nothing, view(), id=ids, depth=depths, precision=PRECISION).proven


def test_a_texture_needs_uv():
    texture = np.zeros((2, 2, 4), np.uint8)
    refused(lambda: zproof.Scene(*TRIANGLE, texture=texture), "texture", "uv")
    assert zproof.Scene(*TRIANGLE, uv=np.zeros((3, 2), np.float32), texture=texture).triangle_count == 1


@pytest.mark.parametrize("shape", [(0, 0, 4), (0, 3, 4), (3, 0, 4), (2**32 + 1, 0, 4)])
def test_a_texture_of_nothing_is_refused(shape):
    uv = np.zeros((3, 2), np.float32)
    refused(lambda: zproof.Scene(*TRIANGLE, uv=uv, texture=np.zeros(shape, np.uint8)), "texture")


@pytest.mark.parametrize("name", ["", "a/b", "../a", "a b", ".", "\0",
    "a\nb"])
def test_a_name_that_is_no_file_s_is_refused(name):
    refused(lambda: zproof.Scene(*TRIANGLE, name=name), "scene: ")


# ---- files ----


@pytest.mark.parametrize("file, words", [("missing.glb", "no such file"), ("", ""),
                                         ("no-scene-of-the-suite", ""),
                                         ("/dev/null", ""), (".", "")])
def test_what_cannot_be_loaded_is_refused_by_name(file, words):
    refused(lambda: zproof.load(file), words)


@pytest.mark.parametrize("name, content", [
    ("a.glb", b"glTF\x02\0\0\0\xff\xff\xff\xff"), ("a.gltf", b"{"), ("a.gltf", b"[]"),
    ("a.ply", b"ply\nformat ascii 1.0\n"),
    ("a.ply", b"ply\nformat ascii 1.0\nelement vertex 99999999999\nproperty float x\nend_header\n"),
    ("a.obj", b"v 0 0 0\nf 1 2 3\n"), ("a.obj", b"v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), ("a.json", b"{}"),
    ("a.glb", b""), ("a.stl", b"solid\n")])
def test_a_broken_file_is_refused_by_name(tmp_path, name, content):
    (tmp_path / name).write_bytes(content)
    refused(lambda: zproof.load(tmp_path / name), name)


def test_a_path_of_bytes_is_a_path(tmp_path):
    (tmp_path / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    assert zproof.load(bytes(tmp_path / "a.obj")).triangle_count == 1


def test_a_loaded_file_has_its_triangles_and_views(tmp_path):
    (tmp_path / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.5\nf 1 2 3\nf 2 4 3\n")
    scene = zproof.load(tmp_path / "a.obj", size=(40, 30))
    assert scene.positions.tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0.5]]
    assert scene.triangles.tolist() == [[0, 1, 2], [1, 3, 2]]
    assert [(name, v.size, v.shape) for name, v in scene.views.items()] == [("frame-all", (40, 30), (30, 40))]


def test_a_scene_of_the_suite_is_loaded_by_its_name():
    scene = zproof.load("near_plane", size=(80, 45))
    assert list(scene.views) == ["ahead", "aside"]
    assert all(name == seen.name and seen.size == (80, 45) for name, seen in scene.views.items())


@pytest.mark.parametrize("size", [(0, 5), (5, 0), (-1, 5), (32769, 1), (2**31 - 1, 2**31 - 1)])
def test_a_view_of_a_size_that_is_not_judged_is_refused(size):
    refused(lambda: view(*size), f"{size[0]} x {size[1]}")


@pytest.mark.parametrize("size", [(0, 5), (5, 0), (-1, 5), (1, 32769), (2**31 - 1, 2**31 - 1)])
def test_a_scene_of_a_size_that_is_not_judged_is_refused(size):
    refused(lambda: zproof.load("near_plane", size=size))


# ---- views ----


PLACED = {"eye": (0, 0, 3), "target": (0, 0, 0), "yfov": 1.0, "near": 0.1, "size": (64, 48)}


@pytest.mark.parametrize("name, value", [
    ("eye", (0, 0)), ("eye", (0, 0, 0, 0)), ("eye", "abc"), ("eye", None), ("eye", (0, np.nan, 1)),
    ("eye", (0, 0, 1e300)),
    ("eye", (0, 0, 3j)), ("eye", (0, 0, 10**400)), ("eye", (0, 0, 0)), ("target", (0, 0, np.inf)),
    ("target", [[0, 0, 0]]),
    ("up", (0, 0, 0)), ("up", (0, 0, 5)), ("up", (np.nan, 0, 0)), ("yfov", 0.0), ("yfov", -1.0),
    ("yfov", np.pi),
    ("yfov", np.nan), ("near", 0.0), ("near", -1.0), ("near", np.nan), ("near", np.inf), ("far", 0.1),
    ("far", np.nan),
    ("far", -np.inf), ("name", ""), ("name", "a b"), ("name", "a/b"), ("name", "a\0")])
def test_a_perspective_of_wrong_numbers_is_refused(name, value):
    refused(lambda: zproof.View.perspective(**{**PLACED, name: value}))


@pytest.mark.parametrize("changed", [{"height": 0.0}, {"height": -1.0}, {"height": np.nan}, {"far": np.inf},
                                     {"far": 0.05}])
def test_a_parallel_projection_of_wrong_numbers_is_refused(changed):
    placed = {**PLACED, "height": 2.0, "far": 9.0}
    del placed["yfov"]
    assert not zproof.View.orthographic(**placed).is_perspective
    refused(lambda: zproof.View.orthographic(**{**placed, **changed}))
    refused(lambda: zproof.View.orthographic(**placed).opencv, "parallel")


def test_numbers_of_any_kind_place_a_view():
    same = [zproof.View.perspective(**{**PLACED, "eye": eye, "yfov": yfov,
                                       "size": size}).camera_from_world.tolist()
            for eye, yfov, size in [((0, 0, 3), 1, (64, 48)),
                                    (np.array([0, 0, 3], np.float16), np.float32(1), [64, 48]),
                                    ([0.0, 0, np.int8(3)], np.float64(1), np.array([64, 48]))]]
    assert same[0] == same[1] == same[2]


def test_matrices_project_as_the_tracer_sees():
    seen = zproof.View.perspective(eye=(0.3, 0.2, 4), target=(0.1, 0, 0), yfov=0.6, near=0.1, far=50,
                                   size=(90, 70))
    positions, triangles = random_mesh(5, triangles=60)
    frame = zproof.trace(zproof.Scene(positions, triangles), seen)
    in_camera = np.column_stack([positions, np.ones(len(positions))]) @ seen.camera_from_world.T
    clip = in_camera @ seen.clip_from_camera.T
    ndc = clip[:, :2] / clip[:, 3:]
    pixels = np.column_stack([(ndc[:, 0] + 1) / 2 * 90 - 0.5, (1 - ndc[:, 1]) / 2 * 70 - 0.5])
    assert_seen(frame, pixels, -in_camera[:, 2], triangles)


# ---- OpenCV ----


def random_rotation(drawn):
    q, r = np.linalg.qr(drawn.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q


def random_camera(drawn):
    """(K, R, t, size)."""
    width, height = drawn.integers(40, 120, 2)
    fx, fy = drawn.uniform(50, 150, 2)
    K = np.array([[fx, 0, drawn.uniform(0.2, 0.8) * width], [0, fy, drawn.uniform(0.2, 0.8) * height],
                  [0, 0, 1]])
    return K, random_rotation(drawn), drawn.uniform(-20, 20, 3), (int(width), int(height))


def mesh_before(drawn, K, R, t, size, triangles=30):
    """Triangles whose corners lie at pixels in and around the image, 2 to 9 units before the camera."""
    centres = drawn.uniform([0, 0], size, (triangles, 1, 2))
    pixels = centres + drawn.uniform(-15, 15, (triangles, 3, 2))
    depths = drawn.uniform(2, 9, (triangles, 1)) + drawn.uniform(-0.3, 0.3, (triangles, 3))
    rays = np.concatenate([pixels, np.ones((triangles, 3, 1))], -1) @ np.linalg.inv(K).T
    in_camera = depths[..., None] * rays
    world = ((in_camera - t) @ R).reshape(-1, 3)  # R^T (p - t), by rows
    return world.astype(np.float32), np.arange(3 * triangles, dtype=np.uint32).reshape(-1, 3)


def opencv_projection(points, K, R, t):
    """(pixels, depths), by the formula of OpenCV's documentation: s [u v 1]^T = K (R p + t)."""
    in_camera = points.astype(float) @ R.T + t
    homogeneous = in_camera @ K.T
    return homogeneous[:, :2] / homogeneous[:, 2:], in_camera[:, 2]


def assert_seen(frame, pixels, depths, triangles, margin=0.02):
    """The frame shows the nearest triangle and its depth wherever no edge is within `margin` pixels of a
    centre. The centre of pixel (x, y) is at (x, y)."""
    height, width = frame.id.shape
    y, x = np.mgrid[0:height, 0:width]
    nearest = np.full((height, width), np.inf)
    owner = np.full((height, width), zproof.BACKGROUND_ID, np.int64)
    certain = np.ones((height, width), bool)
    for number, corners in enumerate(triangles):
        (ax, ay), (bx, by), (cx, cy) = pixels[corners]
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        if abs(area) < 1e-3:
            certain &= False
            continue
        edges = [((px - x) * (qy - y) - (py - y) * (qx - x)) / area for (px, py), (qx, qy) in
                 [((bx, by), (cx, cy)), ((cx, cy), (ax, ay)), ((ax, ay), (bx, by))]]
        lengths = [np.hypot(cx - bx, cy - by), np.hypot(ax - cx, ay - cy), np.hypot(bx - ax, by - ay)]
        distance = np.min([edge * abs(area) / length for edge, length in zip(edges, lengths)], 0)
        certain &= np.abs(distance) > margin
        depth = 1 / sum(edge / z for edge, z in zip(edges, depths[corners]))
        nearer = (distance > 0) & (depth < nearest)
        certain &= ~((distance > 0) & (np.abs(depth - nearest) < 1e-3))
        nearest[nearer], owner[nearer] = depth[nearer], number
    seen = certain & (owner != zproof.BACKGROUND_ID)
    assert certain.mean() > 0.5 and seen.mean() > 0.1, "the scene shows too little to be a test"
    assert (frame.id[certain] == owner[certain]).all()
    assert np.allclose(frame.depth[seen], nearest[seen], rtol=2e-5, atol=0)


@pytest.mark.parametrize("seed", range(20))
def test_a_camera_of_opencv_sees_what_its_formula_says(seed):
    drawn = np.random.default_rng(seed)
    K, R, t, size = random_camera(drawn)
    positions, triangles = mesh_before(drawn, K, R, t, size)
    seen = zproof.View.from_opencv(K, R, t, size, near=0.01, far=1000)
    frame = zproof.trace(zproof.Scene(positions, triangles), seen)
    assert frame.id.shape == (size[1], size[0])
    assert_seen(frame, *opencv_projection(positions, K, R, t), triangles)


@pytest.mark.parametrize("seed", range(5))
def test_what_a_view_says_of_itself_is_the_camera_that_it_was_given(seed):
    K, R, t, size = random_camera(np.random.default_rng(seed))
    seen = zproof.View.from_opencv(K, R.astype(np.float32), t, size, near=0.01, far=1000, name="mine")
    K2, R2, t2 = seen.opencv
    assert np.allclose(K2, K, rtol=1e-12) and np.allclose(R2, R, atol=1e-6) and np.allclose(t2, t, atol=1e-4)
    assert np.allclose(R2 @ R2.T, np.eye(3), atol=1e-14)
    eye = -R2.T @ t2
    assert np.allclose(eye, eye.astype(np.float32), rtol=1e-13, atol=1e-13), "the eye is a float32"
    assert (seen.name, seen.size, seen.near, seen.far) == ("mine", size, 0.01, 1000)
    assert seen.is_perspective
    again = zproof.View.from_opencv(K2, R2, t2, size, near=0.01, far=1000)
    assert np.allclose(again.camera_from_world, seen.camera_from_world, atol=1e-12)


CAMERA = {"K": np.array([[50, 0, 32], [0, 50, 24], [0, 0, 1.0]]), "R": np.eye(3), "t": np.zeros(3),
          "size": (64, 48),
          "near": 0.1, "far": 10}


def with_K(*changes):
    K = CAMERA["K"].copy()
    for place, value in changes:
        K[place] = value
    return {"K": K}


@pytest.mark.parametrize("changed, words", [
    (with_K(((0, 1), 1e-9)), "skew"), (with_K(((1, 0), 1)), "K"), (with_K(((2, 2), 2)), "K"),
    (with_K(((2, 0), 0.1)), "K"),
    (with_K(((0, 0), 0)), "fx, fy > 0"), (with_K(((1, 1), -50)), "fx, fy > 0"),
    (with_K(((0, 2), np.nan)), "K"),
    (with_K(((0, 2), np.inf)), "K"), ({"K": np.eye(4)}, "K is"), ({"K": "x"}, "K holds"),
    ({"K": None}, "K holds"),
    ({"R": 2 * np.eye(3)}, "no rotation"), ({"R": -np.eye(3)}, "no rotation"),
    ({"R": np.diag([1, 1, -1])}, "no rotation"),
    ({"R": np.eye(3) + 1e-4}, "no rotation"), ({"R": np.full((3, 3), np.nan)}, "no rotation"),
    ({"R": np.zeros(3)}, "R is"),
    ({"R": np.eye(4)}, "R is"), ({"t": np.zeros(4)}, "t is"), ({"t": np.full(3, 1e300)}, "eye"),
    ({"t": [0, np.nan, 0]}, "eye"),
    ({"t": None}, "t holds"), ({"near": 0}, "near"), ({"near": 20}, "far"), ({"far": np.nan}, "far"),
    ({"size": (0, 4)}, "0 x 4"),
    ({"name": "a b"}, "name")])
def test_a_camera_of_opencv_that_is_none_is_refused(changed, words):
    zproof.View.from_opencv(**CAMERA)
    refused(lambda: zproof.View.from_opencv(**{**CAMERA, **changed}), words)


@pytest.mark.parametrize("t", [np.array([[1], [2], [3.0]]), [[1, 2, 3]], (1, 2, 3),
                               np.array([1, 2, 3], np.float32)])
def test_t_may_be_a_column_or_a_row(t):
    seen = zproof.View.from_opencv(**{**CAMERA, "t": t})
    assert np.allclose(seen.opencv[2], [1, 2, 3])


def test_a_rotation_of_float32_is_taken_and_made_one():
    drawn = np.random.default_rng(3)
    for _ in range(100):
        R = random_rotation(drawn).astype(np.float32)
        taken = zproof.View.from_opencv(**{**CAMERA, "R": R}).opencv[1]
        assert np.abs(taken - R).max() < 1e-6


def test_layers_are_seen_as_they_are_described():
    ids, depths = traced(layers(), view())
    assert set(np.unique(ids)) == {0, 1, zproof.BACKGROUND_ID}
    assert np.allclose(depths[ids < 2], 3)


# ---- what is not there is told in one line ----


def told(call):
    with pytest.raises((TypeError, ValueError, KeyError)) as raised:
        call()
    said = str(raised.value)
    assert "\n" not in said and len(said) < 300, said
    return said


def test_a_view_that_is_none_is_told_with_those_that_are():
    room = zproof.load("room", size=(40, 30))
    assert told(lambda: room.views["dor"]) == (
        "\"'dor' is no view of the scene; expected one of: door, floor; did you mean 'door'?\"")
    assert "mean" not in told(lambda: room.views[3]) and room.views.get("dor") is None
    example = "view is a str; expected a zproof.View, such as scene.views['floor']"
    ids = np.zeros((30, 40), np.uint32)
    for take in (zproof.trace, zproof.render,
                 lambda scene, view: zproof.judge(scene, view, id=ids, precision="opengl")):
        assert told(lambda: take(room, "flor")) == example
        said = told(lambda: take("room", room.views["door"]))
        assert said.startswith("scene is a str; expected a zproof.Scene"), said
    bare = zproof.Scene(np.zeros((3, 3), np.float32), np.zeros((1, 3), np.uint32))
    assert told(lambda: zproof.trace(bare, None)) == "view is a NoneType; expected a zproof.View"


def test_what_opencv_has_not_is_asked_for():
    parts = np.eye(3), np.eye(3), np.zeros(3), (40, 30)
    assert told(lambda: zproof.View.from_opencv(*parts)).startswith("near is missing; expected ")
    assert zproof.View.from_opencv(*parts, near=1).far == np.inf


def test_unknown_ids_are_told_with_the_known():
    room = zproof.load("room", size=(40, 30))
    ids = np.zeros((30, 40), np.uint32)
    said = told(lambda: zproof.judge(room, room.views["door"], id=ids, precision="opengl", ids="materiel"))
    assert said.startswith("judge: ids materiel: no such file; expected triangle, none, "), said
    assert said.endswith("; did you mean 'material'?"), said
