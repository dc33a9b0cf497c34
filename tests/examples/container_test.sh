#!/usr/bin/env bash
# The Containerfile. Where podman is at hand and has Debian's image, it is built and run; its lines are read everywhere.
#   container_test.sh SOURCE_FOLDER PACKAGES_FOLDER
# PACKAGES_FOLDER is what packaging/make.sh made.
set -euo pipefail
source=$1 packages=$2
die() { echo "container_test: $*" >&2; exit 1; }

# A line of the file is an instruction; one that ends with \ goes on.
mapfile -t lines < <(sed -e :a -e '/\\$/{N;s/\\\n *//;ta' -e '}' "$source/Containerfile" | grep -v '^#' | grep .)
user=root
for line in "${lines[@]}"; do
    rest=${line#* }
    case $line in
        'FROM debian:12-slim' | 'WORKDIR /work' | 'ENTRYPOINT ["zproof"]') ;;
        RUN\ *apt-get\ install*)
            for word in $(sed 's/.*apt-get install -y --no-install-recommends \([^&]*\) &&.*/\1/' <<<"$rest"); do
                if [[ $word == /packages/* ]]; then
                    [ "$(compgen -G "$packages/${word#/packages/}" | wc -l)" = 1 ] || die "$word: not one package"
                else
                    apt-cache show "$word" >/dev/null 2>&1 || die "Debian has no package $word"
                fi
            done
            ;;
        RUN\ *useradd\ *) user=$(sed 's/.*useradd --create-home \([a-z]*\) .*/\1/' <<<"$rest") ;;
        USER\ *) [ "$rest" = "$user" ] && [ "$user" != root ] || die "$line: not a user that was made before" ;;
        *) die "an instruction that this test does not know: $line" ;;
    esac
done
[[ "${lines[*]}" == *"USER $user"*ENTRYPOINT* ]] || die "the program runs as root"

if command -v podman >/dev/null && podman image exists debian:12-slim; then
    podman build -q -t zproof-test -f "$source/Containerfile" "$packages"
    podman run --rm zproof-test run room --oracle none --width 64 --height 36
    podman rmi -f zproof-test >/dev/null
fi
