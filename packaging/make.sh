#!/usr/bin/env bash
# Makes the packages of a build whose target zproof_packaged is up to date (./dev package sees to that):
#   make.sh BUILD_FOLDER FOLDER
# leaves zproof_VERSION_ARCH.deb, libzproof-dev_VERSION_ARCH.deb, python3-zproof_VERSION_ARCH.deb (where the module was built)
# and zproof-VERSION-linux-ARCH.tar.gz in FOLDER. VERSION names the system that they are built for: 0.2.0-debian12.
set -euo pipefail
[ $# = 2 ] || { sed -n '2,5p' "$0" >&2; exit 2; }
build=$(realpath "$1")
folder=$(realpath -m "$2")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

quietly() { "$@" >"$scratch/log" 2>&1 || { cat "$scratch/log" >&2; echo "make.sh: $1 failed" >&2; exit 3; }; }

(cd "$build" && quietly cpack -G DEB -B "$scratch/debian")
program=$(echo "$scratch"/debian/zproof_*.deb)
version=$(dpkg-deb -f "$program" Version)
name=zproof-$version-linux-$(dpkg-deb -f "$program" Architecture)

quietly cmake --install "$build" --component zproof --prefix "$scratch/$name" --strip
needed=$(dpkg-deb -f "$program" Depends | sed 's/ *([^)]*)//g; s/,//g' | fold -s -w 90 | sed 's/ *$/ \\/; 1!s/^/        /; $s/ \\$//')
cat >"$scratch/$name/INSTALL" <<END
$("$scratch/$name/bin/zproof" --version)

Unpack this folder anywhere; the program is bin/zproof, and it may be moved with its folder only. It is built for
$(. /etc/os-release && echo "$NAME $VERSION_ID") and needs these packages of it:

    apt-get install --no-install-recommends \\
        $needed

POV-Ray, OpenGL and Vulkan are further references where they are there: povray, libgl1-mesa-dri, mesa-vulkan-drivers.
bin/zproof doctor tells what is installed. The pages are in share/doc/zproof.
END

mkdir -p "$folder"
tar -C "$scratch" --sort=name --owner=0 --group=0 --numeric-owner --mode=go-w -czf "$folder/$name.tar.gz" "$name"
cp "$scratch"/debian/*.deb "$folder"
