#!/usr/bin/env bash
# Installs zproof from its Debian package, with what else is named:
#   PACKAGE=zproof.deb install.sh [DEBIAN_PACKAGE]...
# PACKAGE is a file, as a shell pattern too, or an address. Where it is empty, it is the release of this version of
# $REPOSITORY (owner/name) on $GITHUB_SERVER_URL.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
package=${PACKAGE:-}

die() { echo "install zproof: $*" >&2; exit 3; }
as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi; }
apt() { as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 "$@"; }

if [ -z "$package" ]; then
    [ -n "${REPOSITORY:-}" ] || die "no package: expected a .deb file or its address (input 'package')"
    version=$(sed -n 's/^project(zproof VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
    releases=${GITHUB_SERVER_URL:-https://github.com}/$REPOSITORY/releases/download
    package=$releases/v$version/zproof_${version}_$(dpkg --print-architecture).deb
fi

if [[ $package == *://* ]]; then
    folder=$(mktemp -d)
    trap 'rm -rf "$folder"' EXIT
    chmod 755 "$folder"  # apt reads it as a user of its own
    file=$folder/zproof.deb
    apt update
    apt install -y --no-install-recommends ca-certificates curl
    curl -fsSL --retry 3 -o "$file" "$package" || die "$package: not there; expected the address of a .deb"
else
    files=$(compgen -G "$package") || die "$package: no such file; expected a .deb"
    [ "$(wc -l <<<"$files")" = 1 ] || die "$package: fits several files; expected one .deb"
    file=$(realpath "$files")
    apt update
fi
apt install -y --no-install-recommends "$file" "$@" ||
    die "apt-get failed; the package is built for Debian 12: let the job run in 'container: debian:12'"
zproof --version
