#!/usr/bin/env bash
# Which commit cmake/zproof_commit.cmake finds: in a clone, with changes, in the tree of git archive, below another
# project, and without git.
#   commit_test.sh SOURCE_FOLDER
set -euo pipefail
source=$1
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cd "$place"
export GIT_CONFIG_GLOBAL=/dev/null GIT_CEILING_DIRECTORIES=$place

# expect WORDS FOLDER: what a build in that folder is told.
expect() {
    cmake -DSOURCE="$place/$2" -DTEMPLATE="$source/program/commit.cpp.in" -DOUTPUT="$place/commit.cpp" \
        -P "$source/cmake/zproof_commit.cmake" >log 2>&1 || { cat log >&2; exit 1; }
    grep -qF "return \"$1\";" commit.cpp || { echo "commit_test: $2: not '$1' but: $(cat commit.cpp)" >&2; exit 1; }
}

mkdir -p clone/cmake
cp "$source/.gitattributes" clone
cp "$source/cmake/commit.txt" clone/cmake
expect unknown clone

cd clone
git init -q
git add .
git -c user.name=a -c user.email=a@b commit -q -m one
commit=$(git rev-parse HEAD | cut -c 1-12)
cd ..
expect "$commit" clone
touch -d 2020-01-01 commit.cpp
touch clone/untracked
expect "$commit" clone
[ "$(date -r commit.cpp +%Y)" = 2020 ] || { echo "commit_test: the file was written in vain" >&2; exit 1; }
echo >>clone/.gitattributes
expect "$commit, changed" clone
git -C clone checkout -q .

mkdir archive clone/vendored
git -C clone archive HEAD | tar -x -C archive
expect "$commit" archive
cp -r archive clone/vendored/zproof
cp clone/cmake/commit.txt clone/vendored/zproof/cmake
expect unknown clone/vendored/zproof

mkdir empty_path
for program in cmake grep cat; do ln -s "$(command -v $program)" empty_path; done
PATH=$place/empty_path expect unknown clone
