#!/usr/bin/env bash
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# scripts/package.sh [CMAKE_OPTION ...]
#
# Installs what is missing and makes the Debian package
# build/package/elasto-plastic-contact_*.deb, for any x86-64 processor, and fast on
# those with AVX2 and AVX-512: the program is compiled three times, which takes half an
# hour on two cores (-DPACKAGE_PROCESSORS= : once). Options are handed on to cmake.

case ${1:-} in
  -h | --help)
    sed -n '5,10s/^# \{0,1\}//p' "$0"
    exit
    ;;
esac

# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

install_missing "${build_packages[@]}" "${plot_packages[@]}" "${package_packages[@]}"
set_up . build/package -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr -DENABLE_TESTING=OFF \
  -DNATIVE_OPTIMIZATION=OFF "-DPACKAGE_PROCESSORS=x86-64-v3;x86-64-v4" "$@"
cmake --build build/package --parallel "$n_processors"
rm -f build/package/elasto-plastic-contact_*.deb
(cd build/package && cpack -G DEB)
ls build/package/elasto-plastic-contact_*.deb
