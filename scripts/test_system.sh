#!/usr/bin/env bash
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# scripts/test_system.sh SUITE [FOLDER]
#
# Installs a fresh Debian SUITE (bookworm, trixie, sid) into FOLDER, by default
# build/systems/SUITE, and runs scripts/run.sh and scripts/test.sh there, on a copy
# of the last commit. Then ten short cases run there and here, and a table says how
# the two systems differ. Needs root, debootstrap, 8 GB and, on two cores, an hour; a
# FOLDER that is there is used again. TEST_BUILDS and TEST_SELECTION are those of
# scripts/test.sh.

case ${1:-} in
  -h | --help)
    sed -n '5,14s/^# \{0,1\}//p' "$0"
    exit
    ;;
esac

invocation_folder=$PWD
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

readonly suite=${1:-}
[ -n "$suite" ] || fail "which suite? scripts/test_system.sh bookworm|trixie|sid [FOLDER]"
[ "$(id -u)" -eq 0 ] || fail "only root may install a system into a folder"
if [ -n "${2:-}" ]; then
  root=$(cd "$invocation_folder" && realpath -m "$2")
else
  root=$PWD/build/systems/$suite
fi
readonly root
readonly checkout=/opt/elasto_plastic_contact

# From the mirror of this system, or else from debootstrap's own.
install_system()
{
  local mirror
  mapfile -t mirror < <(grep -rhoE 'https?://[^ ]+/debian/?( |$)' /etc/apt/sources.list /etc/apt/sources.list.d 2>/dev/null | head -n 1)
  debootstrap --variant=minbase "$suite" "$root" "${mirror[@]}"
}

mount_kernel_folders()
{
  local folder
  for folder in proc sys dev dev/shm; do
    mount --bind "/$folder" "$root/$folder"
  done
}

# shellcheck disable=SC2317 # (called at the end, whatever it is)
unmount_kernel_folders()
{
  local folder
  for folder in dev/shm dev sys proc; do
    ! mountpoint -q "$root/$folder" || umount "$root/$folder"
  done
}

# there COMMAND [ARGUMENT ...], in the copy of the last commit
there()
{
  chroot "$root" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
    ${http_proxy+"http_proxy=$http_proxy"} \
    ${TEST_BUILDS+"TEST_BUILDS=$TEST_BUILDS"} ${TEST_SELECTION+"TEST_SELECTION=$TEST_SELECTION"} \
    sh -c "cd $checkout && exec \"\$@\"" sh "$@"
}

version_there()
{
  # shellcheck disable=SC2016 # (dpkg's)
  there dpkg-query --show --showformat '${Version}' "$1" 2>/dev/null || echo none
}

install_missing "${build_packages[@]}" debootstrap git python3
if [ ! -x "$root/usr/bin/apt-get" ] || [ -d "$root/debootstrap" ]; then
  install_system
fi
trap unmount_kernel_folders EXIT
mount_kernel_folders
cp /etc/resolv.conf "$root/etc/"

rm -rf "${root:?}$checkout"
git clone --quiet . "$root$checkout"

started=$SECONDS
there scripts/run.sh
seconds_of_run=$((SECONDS - started))
started=$SECONDS
status=0
there scripts/test.sh -DWARNINGS_AS_ERRORS=ON || status=1
seconds_of_tests=$((SECONDS - started))

build Release
scripts/command.py ten_cases >build/ten_cases.csv
there scripts/command.py ten_cases >"build/ten_cases_$suite.csv"

cat <<END

Debian $suite, $(date -I)
  deal.II:      $(version_there libdeal.ii-dev)
  compiler:     $(version_there g++)
  Open MPI:     $(version_there openmpi-bin)
  CMake:        $(version_there cmake)
  run.sh:       $seconds_of_run s
  test.sh:      $seconds_of_tests s
$(there grep -h 'tests passed' -r build --include=ctest.log | sed 's/^/  /')

END
printf '%-24s %20s %12s %10s %10s\n' case number difference "s here" "s there"
paste -d ';' build/ten_cases.csv "build/ten_cases_$suite.csv" | awk -F ';' '
  { printf "%-24s %20.15g %12.1e %10s %10s\n", $1, $2, $5 / $2 - 1, $3, $6 }'
exit $status
