#!/usr/bin/env bash
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# scripts/fuzz.sh [NUMBER [SEED]]
#
# Builds with sanitizers and lets every reader of the program (parameter files,
# command line, expressions, histories, meshes, images, height matrices, tables,
# checkpoints) read NUMBER damaged inputs, 5000 unless told; always the same
# ones, unless SEED is another number than 1. It stops at the first that is
# neither accepted nor refused with a message, and keeps it.

case ${1:-} in
  -h | --help)
    sed -n '5,11s/^# \{0,1\}//p' "$0"
    exit
    ;;
esac

# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

install_missing "${build_packages[@]}" "${test_packages[@]}"
configure Sanitize -DENABLE_TESTING=ON
cmake --build build/sanitize --parallel "$n_processors" --target tests.fuzz.debug

folder=build/sanitize/fuzz
mkdir -p "$folder"
cd "$folder"
../tests/fuzz.debug/fuzz.debug "${1:-5000}" "${2:-1}" ||
  fail "the input that has done it is $folder/input (or, of a checkpoint, in $folder/checkpoint)"
