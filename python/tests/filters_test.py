"""Texture studies: the table, and pictures of one's own in it."""
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
    truth, half_width = filters.truth(white, view, half_width=True)
    assert np.all(truth[zproof.trace(white, view).id == zproof.BACKGROUND_ID] < 1)
    assert truth.max() == 1 and half_width.max() == 0


def test_study_stays_where_a_folder_is_named(ground, tmp_path):
    table = filters.run(["nearest"], *ground, folder=tmp_path / "study")
    assert table.folder == str(tmp_path / "study")
    assert (tmp_path / "study/filters.html").is_file()


def test_check_of_the_methods_own_picture(ground, tmp_path):
    grey = np.full((32, 48, 3), 0.25, np.float32)
    check = filters.check(grey, "nearest", *ground)
    assert not check
    assert str(check).startswith("FAILED") or "outside" in check.text


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
