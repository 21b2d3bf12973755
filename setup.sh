#!/usr/bin/env bash
# Sets everything up on Debian 12 (or a relative of it): installs the packages that are missing, builds, and, if asked, tests.
#
#   ./setup.sh            what is needed to plan: packages, and build/bin/plan
#   ./setup.sh --tamp     the same with task and motion planning: plan refine (more packages, and a longer build)
#   ./setup.sh --test     the same, and what the tests need; then builds and runs all of them
#   ./setup.sh --packages [--all]    only the packages (--all: also those for tests, clang, fuzzing and benchmarks)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

plan_packages=(g++ cmake ninja-build ccache libboost-dev libcli11-dev nlohmann-json3-dev)
tamp_packages=(libeigen3-dev libfcl-dev liboctomap-dev libompl-dev liburdfdom-dev libassimp-dev libtinyxml2-dev
               libyaml-cpp-dev libboost-serialization-dev libboost-filesystem-dev libboost-system-dev)
test_packages=(libgtest-dev librapidcheck-dev libssl-dev libpng-dev liborocos-kdl-dev)
# Programs that may be there from elsewhere: the viewer's packages come by npm, and its tests look at it in chromium.
type npm >/dev/null 2>&1 || tamp_packages+=(npm)
type chromium >/dev/null 2>&1 || test_packages+=(chromium)
other_packages=(clang libclang-rt-14-dev libbenchmark-dev python3)

mode=plan
all=false
tamp=false
for argument in "$@"; do
    case $argument in
        --tamp) tamp=true ;;
        --test) mode="test" ;;
        --packages) mode=packages ;;
        --all) all=true ;;
        -h | --help) sed -n '2,7s/^# \{0,1\}//p' "$0"; exit 0 ;;
        *) echo "setup.sh: unknown option '$argument' (try --help)" >&2; exit 2 ;;
    esac
done

packages=("${plan_packages[@]}")
if [ $mode = test ] || $all; then packages+=("${test_packages[@]}" "${tamp_packages[@]}"); fi
if $tamp && [ $mode = plan ]; then packages+=("${tamp_packages[@]}"); fi
if $all; then packages+=("${other_packages[@]}"); fi

install_packages() {
    local missing=()
    local status
    for package in "$@"; do
        status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
        [ "$status" = installed ] || missing+=("$package")
    done
    [ ${#missing[@]} -gt 0 ] || return 0
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then as_root=(sudo); fi
    if ! type apt-get "${as_root[@]}" >/dev/null 2>&1; then
        echo "setup.sh: please install these (Debian's names): ${missing[*]}" >&2
        exit 1
    fi
    echo "setup.sh: installing ${missing[*]}" >&2
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq </dev/null
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -qq --no-install-recommends "${missing[@]}" </dev/null >/dev/null
}

configure() {
    local log
    log=$(mktemp)
    if ! cmake --preset release "$@" >"$log" 2>&1; then
        cat "$log" >&2
        rm -f "$log"
        exit 1
    fi
    rm -f "$log"
}

install_packages "${packages[@]}"
[ $mode != packages ] || exit 0

# The progress of the build is for people; a result on standard output stays clean.
if [ $mode = plan ]; then
    # A build folder that has tests keeps them; a new one is set up for the command alone.
    options=()
    [ -f build/CMakeCache.txt ] || options+=(-DPRAXIS_BUILD_TESTS=OFF)
    targets=(plan)
    if $tamp; then
        options+=(-DPRAXIS_BUILD_TAMP=ON)
        targets+=(plan-refine)
    fi
    configure "${options[@]}"
    cmake --build build --target "${targets[@]}" >&2
else
    configure -DPRAXIS_BUILD_TESTS=ON
    cmake --build build >&2
    ctest --test-dir build --output-on-failure --parallel "$(nproc)" </dev/null
fi
