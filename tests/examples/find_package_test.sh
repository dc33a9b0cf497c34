#!/usr/bin/env bash
# What examples/raycaster promises: installed libraries are found, a program links them, and zproof proves it.
#   find_package_test.sh BUILD_FOLDER SOURCE_FOLDER
set -euo pipefail
build=$1 source=$2
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

cmake --install "$build" --prefix "$place/prefix" >"$place/install.log"
cmake -S "$source/examples/raycaster" -B "$place/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_PREFIX_PATH="$place/prefix"
cmake --build "$place/build"
cd "$place"
prefix/bin/zproof run t_junctions oblique --width 64 --height 40 --oracle none \
    --renderer "$place/build/raycaster {scene} {camera} {out}" --precision ray,arithmetic=float64
