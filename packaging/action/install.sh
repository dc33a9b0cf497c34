#!/usr/bin/env bash
# Installs zproof from its Debian package, with what else is named:
#   PACKAGE=zproof.deb install.sh [DEBIAN_PACKAGE]...
# PACKAGE is a file, as a shell pattern too, or an address. Where it is empty, it is the package for this system of the
# release of this version of $REPOSITORY (owner/name) on $GITHUB_SERVER_URL. Where a pattern fits several, it is the one for
# this system. $PACKAGE_SHA256, where it is set, is its SHA-256: another file is refused, and nothing of it installed.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
package=${PACKAGE:-}

die() { echo "install zproof: $*" >&2; exit 3; }
as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi; }
apt() { as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 "$@"; }

# This system in the word that packages have in their names (cmake/zproof_package.cmake): debian12.
os_release=${OS_RELEASE:-/etc/os-release}
system=$(. "$os_release" && echo "${ID:-}${VERSION_ID:-}") || die "$os_release does not tell which system this is"
systems='debian12 debian13 ubuntu24.04'

if [ -z "$package" ]; then
    [[ " $systems " == *" $system "* ]] ||
        die "no package for $system; expected 'runs-on: ubuntu-24.04', or 'container: debian:12' or debian:13"
    [ -n "${REPOSITORY:-}" ] || die "no package: expected a .deb file or its address (input 'package')"
    version=$(sed -n 's/^project(zproof VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
    releases=${GITHUB_SERVER_URL:-https://github.com}/$REPOSITORY/releases/download
    package=$releases/v$version/zproof_$version-${system}_$(dpkg --print-architecture).deb
fi

if [[ $package == *://* ]]; then
    folder=$(mktemp -d)
    trap 'rm -rf "$folder"' EXIT
    chmod 755 "$folder"  # apt reads it as a user of its own
    file=$folder/zproof.deb
    command -v curl >/dev/null || { apt update && apt install -y --no-install-recommends ca-certificates curl; }
    curl -fsSL --retry 3 -o "$file" "$package" || die "$package: not there; expected the address of a .deb"
else
    files=$(compgen -G "$package") || die "$package: no such file; expected a .deb"
    if [ "$(wc -l <<<"$files")" != 1 ]; then
        files=$(grep -F -e "-${system}_" <<<"$files") || die "$package: fits several files, none of them for $system"
        [ "$(wc -l <<<"$files")" = 1 ] || die "$package: fits several files for $system; expected one .deb"
    fi
    file=$(realpath "$files")
fi
sum=$(sha256sum "$file" | cut -d ' ' -f 1)
[ -z "${PACKAGE_SHA256:-}" ] || [ "$sum" = "${PACKAGE_SHA256,,}" ] ||
    die "$package: its SHA-256 is $sum; expected $PACKAGE_SHA256"
apt update
apt install -y --no-install-recommends "$file" "$@" ||
    die "apt-get failed; this system is $system, and the package's name tells for which it is built: ${package##*/}"
zproof --version
