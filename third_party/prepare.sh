# shellcheck shell=bash
# Sourced by run.sh and test.sh: the packages a build needs, and the build itself.
# Expects the current folder to be the root of the sources.

fail() {
    echo "gripscan: $*" >&2
    exit 2
}

# Names of the packages in third_party/packages.txt that are not installed.
missing_packages() {
    local wanted installed
    wanted=$(sed -e 's/#.*//' -e '/^[[:space:]]*$/d' third_party/packages.txt | sort)
    # shellcheck disable=SC2086  # one word a package
    installed=$(dpkg-query -W -f='${db:Status-Abbrev} ${Package}\n' $wanted 2>/dev/null |
        sed -n 's/^ii *//p' | sort -u)
    comm -23 <(echo "$wanted") <(echo "$installed")
}

install_packages() {
    command -v dpkg-query >/dev/null ||
        fail "this script installs Debian packages and there is no dpkg here;" \
            "install the counterparts of third_party/packages.txt and call cmake --preset release"
    local missing become_root=()
    missing=$(missing_packages)
    [[ -z $missing ]] && return
    if [[ $(id -u) -ne 0 ]]; then
        command -v sudo >/dev/null ||
            fail "packages are missing and there is no sudo; as root: apt-get install" $missing
        become_root=(sudo)
    fi
    echo "gripscan: installing" $missing
    local apt=("${become_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get
        -o DPkg::Lock::Timeout=600 -y -q)
    "${apt[@]}" update || fail "apt-get update failed; is there a network?"
    # shellcheck disable=SC2086
    "${apt[@]}" install --no-install-recommends $missing ||
        fail "apt-get could not install the packages above"
    missing=$(missing_packages)
    [[ -z $missing ]] || fail "still missing after the installation:" $missing
}

# build PRESET [TARGET...]: configures when needed, builds the targets (default: all).
build() {
    local preset=$1
    shift
    # Copies of the sources in different folders share what ccache knows.
    export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
    echo "gripscan: building ($preset)"
    cmake --preset "$preset" >"$(log_of "$preset")" 2>&1 || {
        cat "$(log_of "$preset")" >&2
        fail "cmake could not configure the build"
    }
    cmake --build "build/$preset" -j "$(nproc)" ${1:+--target "$@"} ||
        fail "the build failed; the first error is above"
}

log_of() {
    mkdir -p build
    echo "build/configure-$1.log"
}
