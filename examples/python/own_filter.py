#!/usr/bin/env python3
"""Texture filters of one's own in numpy, held against the exact mean over each pixel (docs/python.md).

A ground plane of arrays, its texture read bilinearly: at the centre of each pixel, and at 4 x 4 places of it.
Both stand beside zproof's own methods in one table, and are held to the definitions that they claim.
"""
import itertools
import sys

import numpy as np

import zproof

SIZE = (128, 96)
TEXELS = 64
PERIOD = 4.0  # scene units in which the texture repeats
PLANE = 60.0  # half the plane's side


def texture():
    """uint8 (TEXELS, TEXELS, 4), sRGB: tiles of two colours with a grain."""
    y, x = np.mgrid[:TEXELS, :TEXELS]
    is_dark = (x * 4 // TEXELS + y * 4 // TEXELS) % 2
    colours = np.array([[230, 214, 180, 255], [60, 84, 120, 255]])[is_dark]
    colours[..., :3] -= np.random.default_rng(1).integers(0, 40, (TEXELS, TEXELS, 1))
    return colours.astype(np.uint8)


def ground(texels):
    xz = PLANE * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], np.float32)
    positions = np.stack([xz[:, 0], np.zeros(4, np.float32), xz[:, 1]], axis=1)
    return zproof.Scene(positions, np.array([[0, 1, 2], [0, 2, 3]], np.uint32), uv=xz / np.float32(PERIOD),
                        texture=texels, name="ground")


def linear(texels):
    """Linear light of sRGB bytes, (height, width, 3), as the nearest float32 (docs/texture-filters.md)."""
    s = texels[..., :3] / 255
    return np.where(s <= 0.04045, s / 12.92, ((s + 0.055) / 1.055) ** 2.4).astype(np.float32)


def bilinear(light, u, v):
    """The four texels around each place, weighted by product; the texture repeats."""
    height, width, _ = light.shape
    x, y = u * width - 0.5, v * height - 0.5  # texel 0 has its centre at 1/2
    x0, y0 = np.floor(x), np.floor(y)
    i, j = x0.astype(int), y0.astype(int)

    def texel(di, dj):
        return light[(j + dj) % height, (i + di) % width]

    fx, fy = (x - x0)[..., None], (y - y0)[..., None]
    above, below = ((1 - fx) * texel(0, dj) + fx * texel(1, dj) for dj in (0, 1))
    return (1 - fy) * above + fy * below


def on_plane(view, dx, dy):
    """Where the rays that pass the pixels' centres by (dx, dy) px meet y = 0: x, z and camera depth."""
    K, R, t = view.opencv
    eye = -R.T @ t
    row, column = np.mgrid[:view.shape[0], :view.shape[1]]
    ahead = [(column + dx - K[0, 2]) / K[0, 0], (row + dy - K[1, 2]) / K[1, 1], np.ones(view.shape)]
    ray = np.stack(ahead, axis=-1) @ R
    along = -eye[1] / ray[..., 1]
    return eye[0] + along * ray[..., 0], eye[2] + along * ray[..., 2], along


def picture(view, light, places):
    """The mean over places x places samples, float32 (height, width, 3). A pixel whose centre sees
    no ground is black; of others all samples lie on the ground's plane, as those of zproof's methods do."""
    offsets = (np.arange(places) + 0.5) / places - 0.5  # from the pixel's centre
    samples = []
    for dx, dy in itertools.product(offsets, offsets):
        x, z, _ = on_plane(view, dx, dy)
        samples.append(bilinear(light, x / PERIOD, z / PERIOD))
    x, z, along = on_plane(view, 0, 0)
    is_ground = (along > view.near) & (np.abs(x) <= PLANE) & (np.abs(z) <= PLANE)
    return np.where(is_ground[..., None], np.mean(samples, axis=0), 0).astype(np.float32)


def main():
    texels = texture()
    scene, light = ground(texels), linear(texels)
    eye, target = (0.3, 2, 7), (0, 0.6, 0)
    view = zproof.View.perspective(eye=eye, target=target, yfov=0.8, near=0.1, far=200, size=SIZE)
    pictures = {"mine-centre": picture(view, light, 1), "mine-4x4": picture(view, light, 4)}

    truth = zproof.filters.truth(scene, view)
    for name, mine in pictures.items():
        print(f"{name}: rmse of all pixels {np.sqrt(np.mean((mine - truth) ** 2)):.5f}")

    methods = ["bilinear", "supersample-bilinear:n=4", "trilinear-gl", "aniso-vulkan", "ewa-true"]
    study = zproof.filters.run(methods, scene, view, pictures=pictures)
    interior = study.rows(region="interior")
    print("\nWhere one surface fills the pixel:")
    for i in np.argsort(interior["rmse"]):
        print(f"  {interior['method'][i]:26} rmse {interior['rmse'][i]:.5f}  flip {interior['flip'][i]:.4f}")

    print("\nDo they compute what they claim?")
    claims = [("mine-centre", "bilinear", True), ("mine-4x4", "supersample-bilinear:n=4", True),
              ("mine-4x4", "bilinear", False)]
    is_right = True
    for name, method, is_expected in claims:
        check = zproof.filters.check(pictures[name], method, scene, view)
        print(f"  {name} as {method}: {str(check).splitlines()[0]}")
        is_right = is_right and bool(check) == is_expected
    return 0 if is_right else 1


if __name__ == "__main__":
    sys.exit(main())
