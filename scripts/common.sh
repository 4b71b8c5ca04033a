# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
# shellcheck shell=bash disable=SC2034
#
# Sourced by the other scripts: what they need from the machine, and how they
# build. Leaves the shell in the project's top folder.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly build_packages=(libdeal.ii-dev libsuitesparse-dev libopenblas0-serial libpng-dev libboost-program-options-dev cmake g++ ninja-build lld mold git)
readonly test_packages=(numdiff perl python3 python3-scipy)
readonly plot_packages=(python3 python3-matplotlib)
# (What cpack takes to find the libraries that a package depends on.)
readonly package_packages=(file dpkg-dev)
# (Other versions format differently. Newer systems have none of this one.)
readonly clang_format=clang-format-14
# (Nor this one, the only one that has been tried, with what it needs of OpenMP.)
readonly clang=clang++-14 clang_packages=(clang-14 libomp-14-dev)

# (nproc would take the next variable for its answer.)
n_processors=$(env -u OMP_NUM_THREADS nproc)
readonly n_processors

# One thread per MPI rank.
export OMP_NUM_THREADS=1

# On one machine, Open MPI need not look for fast networks, which takes 0.2 s at
# each start and, with libfabric (ofi), a second at each end, nor for slow ones, of
# which version 5 complains.
export OMPI_MCA_pml=${OMPI_MCA_pml:-ob1} OMPI_MCA_btl=${OMPI_MCA_btl:-^tcp,ofi}

# (Of a sanitizer build. MPI never frees some memory; deal.II's own library knows
# nothing of the marks beyond the end of a vector.)
export ASAN_OPTIONS=detect_leaks=0:detect_container_overflow=0:max_allocation_size_mb=1600
export UBSAN_OPTIONS=print_stacktrace=1

# Open MPI refuses to start as root, which is who one is in a container.
if [ "$(id -u)" -eq 0 ]; then
  export OMPI_MCA_ess_singleton_isolated=1 OMPI_MCA_sharedfp=^sm
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi

fail()
{
  echo "$(basename "$0"): $*" >&2
  exit 1
}

# run_as_root COMMAND [ARGUMENT ...]
run_as_root()
{
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    fail "this needs root, and there is no sudo: $*"
  fi
}

# install_missing PACKAGE ...
# Installs those Debian packages that are not there yet; without any, it does
# not touch the network.
install_missing()
{
  if ! command -v dpkg-query >/dev/null; then
    echo "Not a Debian system: I take it that the equivalents of these packages are installed: $*"
    return
  fi
  local package missing=()
  for package in "$@"; do
    dpkg-query --show --showformat '${db:Status-Status}\n' "$package" 2>/dev/null |
      grep -qx installed || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0

  echo "Installing ${missing[*]}"
  run_as_root apt-get update -q
  run_as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}"
}

# is_available PACKAGE
is_available()
{
  dpkg-query --show "$1" >/dev/null 2>&1 || [ -n "$(apt-cache search --names-only "^$1\$" 2>/dev/null)" ]
}

# set_up SOURCE FOLDER [CMAKE_OPTION ...]
# With Ninja, if FOLDER is a new one. (Every test of deal.II's kind asks the build
# system whether its program is up to date, which takes make seconds.)
set_up()
{
  local source=$1 folder=$2
  shift 2
  [ -e "$folder/CMakeCache.txt" ] || set -- -G Ninja "$@"
  cmake -S "$source" -B "$folder" "$@"
}

# configure TYPE [CMAKE_OPTION ...]
# Sets up build/release, build/debug or build/sanitize; TYPE is Release, Debug, or
# Sanitize: Debug with sanitizers. A new build/debug is compiled by clang, in half of the
# time that GCC takes, where this system has it and the environment names no other CXX.
configure()
{
  local type=$1 options=(-DCMAKE_BUILD_TYPE="$1")
  shift
  if [ "$type" = Sanitize ]; then
    options=(-DCMAKE_BUILD_TYPE=Debug -DSANITIZE=ON)
  elif [ "$type" = Debug ] && [ ! -e build/debug/CMakeCache.txt ] && [ -z "${CXX:-}" ] && is_available "${clang_packages[0]}"; then
    install_missing "${clang_packages[@]}"
    options+=(-DCMAKE_CXX_COMPILER="$clang")
  fi
  set_up . "build/${type,,}" "${options[@]}" "$@"
}

# build TYPE [CMAKE_OPTION ...]
# Configures and compiles.
build()
{
  configure "$@"
  cmake --build "build/${1,,}" --parallel "$n_processors"
}

# on_ranks NUMBER COMMAND [ARGUMENT ...]
on_ranks()
{
  mpirun --oversubscribe -np "$@"
}
