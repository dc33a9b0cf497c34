#!/usr/bin/env bash
# What docs/packages.md promises, kept: zproof is installed, or unpacked from its Debian packages, and somebody's project
# finds it, links it, and gets its tests from zproof_add_scene_test. pip: what docs/python.md promises of a venv.
#   packages_test.sh installed|unpacked|subfolder|pip BUILD_FOLDER SOURCE_FOLDER
set -euo pipefail
way=$1 build=$(realpath "$2") source=$(realpath "$3")
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cd "$place"

die() { echo "packages_test: $*" >&2; exit 1; }
quietly() { "$@" >log 2>&1 || { cat log >&2; die "$1 failed"; }; }

# expect_status STATUS COMMAND...
expect_status() {
    local expected=$1 status=0
    shift
    "$@" >log 2>&1 || status=$?
    [ $status = "$expected" ] || { cat log >&2; die "status $status, not $expected: $*"; }
}

configure_consumer() { quietly cmake -S "$source/tests/examples/consumer" -B consumer -G Ninja "$@"; }

# The tests of the consumer: what is right passes, what is wrong fails and leaves its evidence.
try_tests() {
    expect_status 0 ctest --test-dir consumer -R '^(every_room|judge_your_frame|guard_band|own_rasterizer)$' --no-tests=error
    expect_status 8 ctest --test-dir consumer -R '^boaster$' --no-tests=error
    expect_status 8 ctest --test-dir consumer -R '^no_such_scene$' --no-tests=error
    for file in zproof/guard_band/report.html zproof/own_rasterizer/junit.xml proof/report.html; do
        [ -s "consumer/$file" ] || die "consumer/$file was not written"
    done
    [ "$(ctest --test-dir consumer -N -L rays | grep -c 'Test *#')" = 1 ] || die "the label names another number of tests"
    [ "$(ctest --test-dir consumer -N -L zproof | grep -c 'Test *#')" = 4 ] || die "not every scene test has the label zproof"
}

# The tarball runs wherever it is unpacked, finds its image module there, and says what it needs.
try_tarball() {
    mkdir 'some where'
    tar -C 'some where' -xzf packages/zproof-*-linux-*.tar.gz
    mv 'some where'/zproof-* 'some where/else'
    quietly 'some where/else/bin/zproof' run guard_band --width 64 --height 40 --oracle none --pictures --evidence all
    [ -s zproof-out/report.html ] || die "the tarball's program wrote no report"
    for package in libembree libopenimageio libtbb; do
        grep -q "^        .*$package" 'some where/else/INSTALL' || die "INSTALL does not name $package"
    done
    [ -z "$(find 'some where/else' -perm /022 ! -type l)" ] || die "the tarball has files that everybody may write"
    ! grep -rqlF "$build" 'some where/else/bin' 'some where/else/lib' || die "the tarball names the build folder"
    mv 'some where/else/lib' 'some where/lib'
    expect_status 3 'some where/else/bin/zproof' run guard_band --width 64 --height 40 --oracle none --evidence all -o lost
    grep -q 'libopenimageio' log || die "a missing image module is not named"
}

# try_python PYTHON...: the module works where it is installed, reads images, and has its plugin.
try_python() {
    quietly "$@" - <<'END'
import importlib.metadata, numpy, zproof
scene = zproof.load("guard_band", size=(64, 40))
view, = list(scene.views.values())[:1]
frame = zproof.render(scene, view)
verdict = zproof.assert_proven(scene, view, id=frame.id, depth=frame.depth, precision="opengl")
verdict.save("python-report")
assert any(e.value == "zproof.pytest_plugin" for e in importlib.metadata.entry_points(group="pytest11"))
assert importlib.metadata.version("zproof") == zproof.__version__
END
    [ -s python-report/report.html ] || die "the Python module wrote no report"
}

# A Python that looks below PREFIX.
try_python_below() {
    try_python env PYTHONPATH="$1/lib/python3/dist-packages" ZPROOF_PROGRAM="$1/bin/zproof" /usr/bin/python3
}

# In a venv pip brings the module and the program, without the network. A wheel comes first; both builds are in one folder, so
# that zproof is compiled once.
try_pip() {
    local python packages library
    export PIP_NO_INDEX=1
    python=$(sed -n 's/^PYTHON_EXECUTABLE:[A-Z]*=//p' "$build/CMakeCache.txt")
    quietly "$python" -m venv --system-site-packages venv
    quietly venv/bin/python -m build --wheel --no-isolation --config-setting=build-dir="$build/pip" -o wheels "$source"
    [ -n "$(compgen -G 'wheels/zproof-*-cp3*-linux_*.whl')" ] || die "no wheel among $(ls wheels)"
    quietly venv/bin/pip install --no-build-isolation --config-settings=build-dir="$build/pip" "$source"
    packages=$(realpath venv/lib/python3*/site-packages)
    [ "$(venv/bin/python -c 'import zproof; print(zproof.__file__)')" = "$packages/zproof/__init__.py" ] ||
        die "the module is not that of the venv"
    try_python venv/bin/python
    quietly venv/bin/zproof run guard_band --width 64 --height 40 --oracle none --pictures --evidence all
    [ -s zproof-out/report.html ] || die "the program of the venv wrote no report"
    for library in libembree libOpenImageIO libtbb; do
        grep -q "^$library.*\.so\." "$packages"/zproof-*.dist-info/libraries.txt || die "the wheel does not name $library"
    done
    quietly venv/bin/pip uninstall -y zproof
    [ -z "$(find venv -name '*zproof*')" ] || die "pip left $(find venv -name '*zproof*')"
}

case $way in
    installed)
        quietly cmake --install "$build" --prefix "$place/prefix"
        try_python_below "$place/prefix"
        configure_consumer -DCMAKE_PREFIX_PATH="$place/prefix"
        quietly cmake --build consumer
        try_tests
        ;;
    unpacked)
        "$source/packaging/make.sh" "$build" packages
        # The name under which the Action looks for it (packaging/action/install.sh).
        version=$(sed -n 's/^project(zproof VERSION \([0-9.]*\).*/\1/p' "$source/CMakeLists.txt")
        system=$(. /etc/os-release && echo "$ID${VERSION_ID:-}")
        name=zproof_$version-${system}_$(dpkg --print-architecture).deb
        [ -f "packages/$name" ] || die "no $name among $(ls packages)"
        for package in packages/*.deb; do quietly dpkg -x "$package" root; done
        root/usr/bin/zproof --version
        if git -C "$source" rev-parse --git-dir >/dev/null 2>&1; then
            commit=$(root/usr/bin/zproof --version | sed -n 's/.*(commit \([0-9a-f]*\)[,;].*/\1/p')
            git -C "$source" cat-file -e "$commit^{commit}" || die "--version names no commit of this repository"
        fi
        try_tarball
        try_python_below root/usr
        "$source/tests/examples/container_test.sh" "$source" packages
        man -l root/usr/share/man/man1/zproof.1.gz | grep -q 'zproof filters check' || die "the manual page says too little"
        for script in bash-completion/completions/zproof fish/vendor_completions.d/zproof.fish \
            zsh/vendor-completions/_zproof; do
            grep -q 'made by: zproof completion' "root/usr/share/$script" || die "$script is not in the package"
        done
        export PKG_CONFIG_PATH
        PKG_CONFIG_PATH=$(echo root/usr/lib*/pkgconfig root/usr/lib/*/pkgconfig | tr ' ' :)
        # shellcheck disable=SC2046
        quietly g++ -O1 "$source/examples/raycaster/raycaster.cpp" -o raycaster $(pkg-config --cflags --libs zproof)
        quietly root/usr/bin/zproof run guard_band --width 64 --height 40 --oracle none \
            --renderer "$place/raycaster {scene} {camera} {out}" --precision ray,arithmetic=float64
        quietly cmake -S "$source/examples/raycaster" -B example -G Ninja -DCMAKE_PREFIX_PATH="$place/root/usr"
        ;;
    subfolder)
        configure_consumer -DZPROOF_SOURCE="$source"
        ctest --test-dir consumer -N >tests
        grep -q own_rasterizer tests || die "the consumer has no test"
        grep -q HousePlan tests && die "the consumer was given zproof's own tests"
        if [ "${4:-}" = build ]; then
            quietly cmake --build consumer
            try_tests
        fi
        ;;
    pip) try_pip ;;
    *) die "no such way: $way" ;;
esac
