#!/usr/bin/env bash
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# scripts/test.sh [CMAKE_OPTION ...]
#
# Installs what is missing, builds the program with and without the checks of a
# Debug build, and runs all tests of both. Options are handed on to cmake, for
# example -DWARNINGS_AS_ERRORS=ON. The environment may restrict this:
# TEST_BUILDS="Release" to some build types, TEST_SELECTION=regex to some tests.
# TEST_BUILDS="Sanitize" runs the tests of Debug under sanitizers (doc/develop/long_tests.md).

case ${1:-} in
  -h | --help)
    sed -n '5,12s/^# \{0,1\}//p' "$0"
    exit
    ;;
esac

# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

install_missing "${build_packages[@]}" "${test_packages[@]}"

status=0
summaries=()
for type in ${TEST_BUILDS:-Debug Release}; do
  configure "$type" -DENABLE_TESTING=ON -DDEBUG_SYMBOLS="$([ "$type" = Sanitize ] && echo ON || echo OFF)" "$@"
  cmake --build "build/${type,,}" --parallel "$n_processors" --target all test_programs
  log=build/${type,,}/ctest.log
  (cd "build/${type,,}" && ctest --output-on-failure -j "$n_processors" -R "${TEST_SELECTION:-.}") 2>&1 | tee "$log" || status=1
  summaries+=("$type: $(grep -E 'tests passed|No tests were found' "$log" || echo 'ctest ended without a summary')")
done

printf '\n'
printf '%s\n' "${summaries[@]}"
exit $status
