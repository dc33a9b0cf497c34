"""Texture studies: the table, and pictures of one's own in it."""
import os
import subprocess

import numpy as np
import pytest

import zproof
from zproof import filters


@pytest.fixture(scope="module")
def ground():
    xz = np.array([[-8, -8], [8, -8], [8, 8], [-8, 8]], np.float32)
    positions = np.stack([xz[:, 0], np.zeros(4, np.float32), xz[:, 1]], axis=1)
    texels = np.full((4, 4, 4), 255, np.uint8)
    texels[::2, ::2, :3] = texels[1::2, 1::2, :3] = 60
    scene = zproof.Scene(positions, np.array([[0, 1, 2], [0, 2, 3]], np.uint32), uv=xz / 2, texture=texels)
    view = zproof.View.perspective(eye=(0, 2, 9), target=(0, 0, 0), yfov=0.7, near=0.1, size=(48, 32))
    return scene, view


@pytest.fixture(scope="module")
def study(ground):
    pictures = {"exact": filters.truth(*ground), "grey": np.full((32, 48, 3), 0.25, np.float32)}
    return filters.run(["nearest", "ewa-true"], *ground, pictures=pictures)


def test_a_region_of_a_method_is_one_row(study):
    rows = list(zip(study["method"], study["region"]))
    assert len(rows) == len(set(rows)) == len(study)


def test_costs_stand_beside_errors(study):
    row = study.rows(method="nearest", region="all")
    assert len(row) == 1
    assert row["pixels"][0] == 48 * 32
    assert row["texels"][0] == 1
    assert row["rmse"][0] > 0


def test_the_truth_has_no_error_but_its_rounding_to_float32(study):
    assert study.rows(method="exact", region="all")["max"][0] <= 2**-25


def test_rmse_is_that_of_the_pixels(ground, study):
    truth = filters.truth(*ground)
    assert study.rows(method="grey", region="all")["rmse"][0] == pytest.approx(
        np.sqrt(np.mean((0.25 - truth.astype(float)) ** 2)), rel=1e-6)


def test_rows_of_nothing(study):
    assert len(study.rows(region="nowhere")) == 0


def test_bilinear_truth_of_one_colour_is_that_colour(ground):
    scene, view = ground
    white = zproof.Scene(scene.positions, scene.triangles, uv=np.zeros((4, 2), np.float32),
                         texture=np.full((1, 1, 4), 255, np.uint8))
    truth, half_width = filters.truth(white, view, "B", half_width=True)
    assert np.all(truth[zproof.trace(white, view).id == zproof.BACKGROUND_ID] < 1)
    assert truth.max() == 1 and half_width.max() == 0


def test_study_stays_where_a_folder_is_named(ground, tmp_path):
    table = filters.run(["nearest"], *ground, folder=tmp_path / "study")
    assert table.folder == str(tmp_path / "study")
    assert (tmp_path / "study/filters.html").is_file()


def test_defaults_are_those_of_the_command(ground, study, tmp_path):
    assert set(study["truth"]) == {"N"}
    zproof._zproof.save_scene(ground[0], [ground[1]], str(tmp_path))
    named = dict(scene=str(tmp_path / f"{ground[0].name}.view.json"))
    words = [os.environ["ZPROOF_PROGRAM"], "filters", "run", named["scene"], "--methods", "nearest", "-q"]
    subprocess.run([*words, "-o", str(tmp_path / "typed")], check=True, capture_output=True)
    filters.run(["nearest"], **named, folder=tmp_path / "called")
    typed, called = ((tmp_path / name / "filters.csv").read_text().splitlines() for name in ("typed", "called"))
    timed = ("build_ms", "ns_per_sample")
    kept = [[line for line in lines if not line.startswith("#") and not any(word in line for word in timed)]
            for lines in (typed, called)]
    assert kept[0] == kept[1]
    assert any("flicker" in line for line in kept[0])


def test_pictures_and_errors_come_back_bit_for_bit(ground, study):
    truth = filters.truth(*ground)
    assert study.truth().dtype == np.float32
    assert np.array_equal(study.truth(), truth)
    assert np.array_equal(study.picture("grey"), np.full((32, 48, 3), 0.25, np.float32))
    assert np.array_equal(study.error("grey"), np.float32(0.25) - truth)
    part = study.rows(method="nearest", region="all")
    assert np.abs(part.error("nearest")).max() == pytest.approx(part["max"][0], abs=2**-24)


def test_a_picture_that_is_not_in_the_study(study):
    with pytest.raises(ValueError, match="expected one of nearest, ewa-true, exact, grey"):
        study.picture("nearst")
    with pytest.raises(ValueError, match="0 views fit"):
        study.truth(view="nowhere")
    with pytest.raises(ValueError, match="does not come from run"):
        filters.Table().truth()


def own_bilinear(coordinates, jacobian, levels):
    light = levels[0].astype(float)
    rows, columns, _ = light.shape
    low = np.floor(coordinates - 0.5)
    (s, t), (i, j) = (coordinates - 0.5 - low).T[..., None], low.astype(int).T

    def texel(di, dj):
        return light[(j + dj) % rows, (i + di) % columns]

    return (1 - t) * ((1 - s) * texel(0, 0) + s * texel(1, 0)) + t * ((1 - s) * texel(0, 1) + s * texel(1, 1))


def own_nearest_level(coordinates, jacobian, levels):
    """The nearest texel of the level that is nearest to the longer step."""
    lod = np.log2(np.maximum(np.linalg.norm(jacobian[..., 0], axis=1), np.linalg.norm(jacobian[..., 1], axis=1)))
    chosen = np.clip(np.ceil(lod + 0.5) - 1, 0, len(levels) - 1).astype(int)
    colours = np.empty((len(coordinates), 3))
    for level in np.unique(chosen):
        at, image = chosen == level, levels[level]
        i, j = np.floor(coordinates[at] / 2.0**level).astype(int).T
        colours[at] = image[j % image.shape[0], i % image.shape[1]]
    return colours


def test_methods_of_ones_own_are_ranked_and_held_to_their_claims(ground):
    study = filters.run(["bilinear"], *ground, own={"mine": own_bilinear, "levels": own_nearest_level},
                        claims={"mine": "bilinear", "levels": "mip-nearest-point"})
    assert np.abs(study.picture("mine") - study.picture("bilinear")).max() < 1e-6
    rmse = dict(zip(*(study.rows(region="interior")[column] for column in ("method", "rmse"))))
    assert rmse["mine"] == pytest.approx(rmse["bilinear"], rel=1e-5) and rmse["levels"] != rmse["mine"]
    assert set(study.outside.values()) == {0}
    assert sorted(name for _, _, name in study.outside) == ["levels", "mine"]
    assert filters.check(filters.paint(own_bilinear, *ground), "bilinear", *ground)
    assert not filters.check(filters.paint(own_nearest_level, *ground), "bilinear", *ground)


def test_batches_change_nothing(ground):
    sizes = []

    def counted(coordinates, jacobian, levels):
        sizes.append(len(coordinates))
        return own_bilinear(coordinates, jacobian, levels)

    whole, parts = filters.paint(own_bilinear, *ground), filters.paint(counted, *ground, batch=100)
    assert np.array_equal(whole, parts)
    assert max(sizes) == 100 and sum(sizes) == np.count_nonzero(
        zproof.trace(*ground).id != zproof.BACKGROUND_ID)


def test_methods_of_ones_own_that_are_refused(ground):
    with pytest.raises(ValueError, match=r"gave \(3,\) for"):
        filters.paint(lambda coordinates, jacobian, levels: np.zeros(3), *ground)
    with pytest.raises(ValueError, match="is the name of a picture, too"):
        filters.run(["nearest"], *ground, own={"a": own_bilinear}, pictures={"a": np.zeros((32, 48, 3), np.float32)})
    with pytest.raises(ValueError, match="expects a zproof.Scene"):
        filters.run(["nearest"], "worked", "phi-0", own={"a": own_bilinear})


def test_check_of_a_wrong_picture_tells_numbers(ground):
    grey = np.full((32, 48, 3), 0.25, np.float32)
    check = filters.check(grey, "nearest", *ground)
    assert not check and check.outcome == "failed"
    assert str(check).startswith("FAILED")
    assert 0 < check.outside <= check.pixels == 48 * 32
    assert f"{check.outside} of {check.pixels} pixels outside" in check.text
    assert check.slack > 1 and check.power is None
    x, y = check.worst
    assert 0 <= x < 48 and 0 <= y < 32


def test_check_of_the_methods_own_picture_tells_what_it_could_see(ground):
    own = filters.run(["trilinear-gl"], *ground, flicker=0).picture("trilinear-gl")
    check = filters.check(own, "trilinear-gl", *ground, precision="lod_bits=8")
    assert check and check.passed and check.outcome == "passed"
    assert check.outside == 0 and check.worst is None and check.slack <= 1
    assert check.permitted_width.shape == (3,) and 0 < check.permitted_width.max() < 0.1
    lod = check.offsets["LOD"]
    assert lod["interval"][0] <= 0 <= lod["interval"][1]
    assert lod["interval"][1] - lod["value"] == pytest.approx(lod["value"] - lod["interval"][0])
    assert lod["unit"] == "levels" and 2**-8 <= lod["promised"] < 2**-7 and not lod["leaves_promise"]
    assert check.power["would_refuse"] and not check.power["unproven"]


def test_check_that_proves_nothing_is_not_true(ground):
    own = filters.run(["bilinear"], *ground, flicker=0).picture("bilinear")
    check = filters.check(own, "bilinear", *ground, precision="weight_bits=0")
    assert not check and check.outcome == "nothing"
    assert check.outside == 0 and check.power["unproven"]
    assert all(offset["interval"] is None for offset in check.offsets.values())


def test_a_claim_is_counted(ground):
    grey = np.full((32, 48, 3), 0.25, np.float32)
    outside = filters.run(["nearest"], *ground, pictures={"grey": grey}, claims={"grey": "bilinear"}).outside
    [(key, pixels)] = outside.items()
    assert key[2] == "grey" and 0 < pixels <= 48 * 32
    lenient = filters.run(["nearest"], *ground, pictures={"grey": grey}, claims={"grey": "bilinear"},
                          precision="gpu,weight_bits=1").outside[key]
    assert lenient < pixels


@pytest.mark.parametrize("picture, message", [
    (np.zeros((32, 48, 3)), "picture is float64 (32, 48, 3); expected float32"),
    (np.zeros((32, 48), np.float32), "picture is float32 (32, 48); expected float32 (height, width, 3)"),
])
def test_pictures_that_are_refused(ground, picture, message):
    with pytest.raises(ValueError) as refused:
        filters.run(["nearest"], *ground, pictures={"mine": picture})
    assert message in str(refused.value)


def test_a_picture_of_another_size_is_refused_in_the_programs_words(ground):
    with pytest.raises(RuntimeError, match="exit status"):
        filters.run(["nearest"], *ground, pictures={"mine": np.zeros((3, 4, 3), np.float32)})


def test_an_unknown_method_is_refused_in_the_programs_words(ground):
    with pytest.raises(RuntimeError, match="nonesuch"):
        filters.run(["nonesuch"], *ground)


def test_a_program_that_is_not_there(ground, monkeypatch):
    monkeypatch.setenv("ZPROOF_PROGRAM", "/nowhere/zproof")
    with pytest.raises(RuntimeError, match="/nowhere/zproof is not found"):
        filters.run(["nearest"], *ground)


def test_unknown_reconstruction(ground):
    with pytest.raises(ValueError, match="expected one of N, B, G, GN, M, BH"):
        filters.truth(*ground, "X")
