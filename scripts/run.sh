#!/usr/bin/env bash
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# scripts/run.sh [CASE] [RANKS]
#
# Installs what is missing, builds the program, runs one case, a file or the name of a
# ready case (default: a sphere pressed into a block, on two ranks), and draws what
# there is to be seen of the result, in a folder of its own below output/.

case ${1:-} in
  -h | --help)
    sed -n '5,9s/^# \{0,1\}//p' "$0"
    exit
    ;;
esac

invocation_folder=$PWD
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case_name=${1:-sphere_3d}
# (a file of the caller's folder, which is no longer the current one)
for file in "$case_name" "$case_name.prm"; do
  if [[ $file != /* && -f $invocation_folder/$file ]]; then
    case_name=$invocation_folder/$file
    break
  fi
done
n_ranks=${2:-2}

[[ $n_ranks =~ ^[1-9][0-9]*$ ]] || fail "the number of ranks must be a positive integer, not '$n_ranks'"

install_missing "${build_packages[@]}" "${plot_packages[@]}"
build Release -DENABLE_TESTING=OFF

# (Not what the environment says, but what has just been built.)
scripts/command.py run --program build/release/elasto_plastic_contact "$case_name" "$n_ranks"
