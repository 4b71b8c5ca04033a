#!/usr/bin/env bash
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# scripts/run.sh [FILE.prm] [RANKS]
#
# Installs what is missing, builds the program, runs one case (default: a sphere
# pressed into a block, on two ranks) and draws what there is to be seen of the result,
# in a folder of its own below output/.

case ${1:-} in
  -h | --help)
    sed -n '5,9s/^# \{0,1\}//p' "$0"
    exit
    ;;
esac

invocation_folder=$PWD
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case_file=$(realpath -m "parameter_files/sphere_3d.prm")
if [ $# -ge 1 ]; then
  case_file=$(cd "$invocation_folder" && realpath -m "$1")
fi
n_ranks=${2:-2}

[ -r "$case_file" ] || fail "there is no readable file '$case_file'"
[[ $n_ranks =~ ^[1-9][0-9]*$ ]] || fail "the number of ranks must be a positive integer, not '$n_ranks'"

install_missing "${build_packages[@]}" "${plot_packages[@]}"
build Release -DENABLE_TESTING=OFF

scripts/command.py run "$case_file" "$n_ranks"
