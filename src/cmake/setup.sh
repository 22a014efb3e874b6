# For demos/run and tests/run to source: installs what is missing and builds. Not a program of its own.

scree_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scree_libraries=(libbullet-dev libbullet-extras-dev libeigen3-dev libassimp-dev zlib1g-dev libqhull-dev nlohmann-json3-dev
    libcli11-dev libxxhash-dev catch2)

fail() {
    echo "scree: $*" >&2
    exit 1
}

# Prints those of the packages that are not installed.
missing_packages() {
    local package
    for package in "$@"; do
        [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || echo "$package"
    done
}

# Prints the packages of the build tools that are not there, however they came.
missing_tools() {
    command -v c++ >/dev/null || echo g++
    command -v cmake >/dev/null || echo cmake
    command -v ninja >/dev/null || command -v make >/dev/null || echo ninja-build
}

# Runs a command with its output in a log, and shows the log's end only when the command fails.
logged() {
    local what=$1 log=$2
    shift 2
    mkdir -p "$(dirname "$log")"
    echo "scree: $what"
    if ! "$@" >"$log" 2>&1; then
        tail -n 40 "$log" >&2
        echo "scree: $what failed, all of its output is in $log" >&2
        return 1
    fi
}

# Installs the given packages as root or with sudo. Asks for neither when nothing is missing.
install_packages() {
    local missing=("$@") log
    ((${#missing[@]})) || return 0
    command -v apt-get >/dev/null || fail "missing packages and no apt-get to install them: ${missing[*]}"
    local as_root=()
    if ((EUID != 0)); then
        command -v sudo >/dev/null || fail "neither root nor sudo to install the missing packages: ${missing[*]}"
        as_root=(sudo)
        [[ -t 0 ]] || as_root+=(-n)
        "${as_root[@]}" true 2>/dev/null || fail "sudo refused to install the missing packages: ${missing[*]}"
    fi
    as_root+=(env DEBIAN_FRONTEND=noninteractive)
    log=$(mktemp)
    echo "scree: installing ${missing[*]}"
    # A package list that cannot be renewed may still serve.
    "${as_root[@]}" apt-get update >"$log" 2>&1 || true
    if ! "${as_root[@]}" apt-get install -y -o DPkg::Lock::Timeout=300 --no-install-recommends "${missing[@]}" \
        >>"$log" 2>&1; then
        fail "apt-get could not install ${missing[*]}: $(grep '^E:' "$log" | head -n 1)"
    fi
    rm -f "$log"
}

# Installs what a build needs, and any packages named besides.
install_requirements() {
    local needed
    mapfile -t needed < <(missing_tools)
    if command -v dpkg-query >/dev/null; then
        mapfile -t -O "${#needed[@]}" needed < <(missing_packages "${scree_libraries[@]}" "$@")
    fi
    install_packages "${needed[@]}"
}

# As many jobs as cores, but no more than there is memory for.
parallel_jobs() {
    local cores memory
    cores=$(nproc)
    memory=$(awk '/MemAvailable/ {print int($2 / 1500000)}' /proc/meminfo 2>/dev/null || echo "$cores")
    if ((memory < 1)); then memory=1; fi
    echo $((cores < memory ? cores : memory))
}

# build <preset> [<target>...]: configures and builds in build/<preset>.
build() {
    local preset=$1 folder=$scree_root/build/$1 targets=()
    shift
    if (($#)); then targets=(--target "$@"); fi
    if command -v ninja >/dev/null; then export CMAKE_GENERATOR=${CMAKE_GENERATOR:-Ninja}; fi
    export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(parallel_jobs)}
    (cd "$scree_root" && logged "configuring ($preset)" "$folder/configure.log" cmake --preset "$preset") || return 1
    logged "building ($preset)" "$folder/build.log" cmake --build "$folder" "${targets[@]}"
}
