#!/usr/bin/env bash
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# scripts/compare_with_step42.sh [CASE[=CYCLES] ...] [--ranks N]
#
# Runs this program and deal.II's tutorial program step-42 in turn on the same
# cases, and prints what they found and what it took, side by side. The cases
# are uniform_q1, adaptive_q1, uniform_q2 and adaptive_q2, by default all of
# them; CYCLES is the number of meshes. At the end, how long each takes to a
# contact force of a given accuracy. Installs and builds what is missing.

case ${1:-} in
  -h | --help)
    sed -n '5,11s/^# \{0,1\}//p' "$0"
    exit
    ;;
esac

# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

# Some systems are set up to install packages without their documentation.
copy_step42()
{
  local target=$1 examples=/usr/share/doc/libdeal.ii-doc/examples/step-42
  [ -d "$examples" ] ||
    fail "$examples is missing although the package libdeal.ii-doc is installed; does dpkg leave out documentation (path-exclude)?"
  mkdir -p "$target"
  cp "$examples"/* "$target"
  find "$target" -maxdepth 1 -name '*.gz' -exec gunzip --force {} +
}

install_missing "${build_packages[@]}" libdeal.ii-doc python3
build Release

folder=build/step-42
[ -r "$folder/step-42.cc" ] || copy_step42 "$folder"
set_up "$folder" "$folder/build" -DCMAKE_BUILD_TYPE=Release
cmake --build "$folder/build"

scripts/command.py compare_with_step42 build/release/elasto_plastic_contact "$folder/build/step-42" "$@"
