#!/usr/bin/env python3
"""Where two versions of Embree show something else: reference_frames.py FOLDER FOLDER

Each folder is what `zproof run --reference-cache FOLDER` left, of the same views. Prints how many pixels have another id,
how many have the same id at another depth, and by how much at most. Exit status 1 where any differ, 3 where views are
missing in one.
"""
import pathlib
import sys

import numpy


def frames(folder):
    """Ids and depths by what was traced: scene and camera, without who traced them."""
    kept = {}
    for path in pathlib.Path(folder).glob("*.frame"):
        _, key, size, _, planes = path.read_bytes().split(b"\n", 4)
        width, height = (int(side) for side in size.split(b" x "))
        pixels = width * height
        ids = numpy.frombuffer(planes, "<u4", pixels)
        depths = numpy.frombuffer(planes, "<f4", pixels, 4 * pixels)
        kept[key.split(b" Embree ")[0]] = path, width, ids, depths
    return kept


def main(before, after):
    one, other = frames(before), frames(after)
    if not one or one.keys() != other.keys():
        print(f"{len(one)} and {len(other)} views, {len(one.keys() & other.keys())} of them the same", file=sys.stderr)
        return 3
    pixels = other_id = other_depth = 0
    largest = 0.0
    for key, (path, width, ids, depths) in one.items():
        _, _, ids_after, depths_after = other[key]
        pixels += ids.size
        parted = ids != ids_after
        moved = ~parted & (depths.view("<u4") != depths_after.view("<u4"))
        other_id += int(parted.sum())
        other_depth += int(moved.sum())
        if moved.any():
            largest = max(largest, float(numpy.max(numpy.abs(depths_after[moved] / depths[moved].astype("f8") - 1))))
        for pixel in numpy.flatnonzero(parted)[:10]:
            print(f"{path.name[:12]}  ({pixel % width}, {pixel // width})  {ids[pixel]} {ids_after[pixel]}")
    print(f"{len(one)} views, {pixels} pixels: {other_id} with another id, {other_depth} with another depth "
          f"(by {largest:.3g} of it at most)")
    return 1 if other_id or other_depth else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
