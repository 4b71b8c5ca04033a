#!/usr/bin/env bash
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# scripts/test_system.sh SUITE [FOLDER]
#
# Installs a fresh Debian SUITE (bookworm, trixie, sid) into FOLDER, by default
# build/systems/SUITE, and runs scripts/run.sh and scripts/test.sh there, on a copy of
# the last commit. Then ten short cases run there and here, and a run that one of the
# two has begun is finished by the other. At last, the package is made there, and a
# plain user tries it in a second fresh system, FOLDER.user. Prints a table of what
# has come out. Needs root, debootstrap, 16 GB and, on two cores, two hours; a FOLDER
# that is there is used again. TEST_BUILDS and TEST_SELECTION are those of
# scripts/test.sh; TEST_PACKAGE=no leaves the package out, which saves half an hour.

case ${1:-} in
  -h | --help)
    sed -n '5,16s/^# \{0,1\}//p' "$0"
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
readonly user_root=$root.user
readonly checkout=/opt/elasto_plastic_contact
readonly kernel_folders=(proc sys dev dev/shm dev/pts)

# install_system FOLDER
# From the mirror of this system, or else from debootstrap's own.
install_system()
{
  local mirror
  if [ ! -x "$1/usr/bin/apt-get" ] || [ -d "$1/debootstrap" ]; then
    mapfile -t mirror < <(grep -rhoE 'https?://[^ ]+/debian/?( |$)' /etc/apt/sources.list /etc/apt/sources.list.d 2>/dev/null | head -n 1)
    debootstrap --variant=minbase "$suite" "$1" "${mirror[@]}"
  fi
  local folder
  for folder in "${kernel_folders[@]}"; do
    mountpoint -q "$1/$folder" || mount --bind "/$folder" "$1/$folder"
  done
  cp /etc/resolv.conf "$1/etc/"
}

# shellcheck disable=SC2317 # (called at the end, whatever it is)
unmount_kernel_folders()
{
  local folder
  for folder in {"$root","$user_root"}/{dev/pts,dev/shm,dev,sys,proc}; do
    ! mountpoint -q "$folder" || umount "$folder"
  done
}

# in_system FOLDER COMMAND [ARGUMENT ...]
in_system()
{
  local folder=$1
  shift
  chroot "$folder" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive ${http_proxy+"http_proxy=$http_proxy"} \
    ${TEST_BUILDS+"TEST_BUILDS=$TEST_BUILDS"} ${TEST_SELECTION+"TEST_SELECTION=$TEST_SELECTION"} \
    "$@"
}

# there COMMAND [ARGUMENT ...], in the copy of the last commit
there()
{
  in_system "$root" sh -c "cd $checkout && exec \"\$@\"" sh "$@"
}

version_there()
{
  # shellcheck disable=SC2016 # (dpkg's)
  there dpkg-query --show --showformat '${Version}' "$1" 2>/dev/null || echo none
}

# Three times in turn, so that times can be compared: the shortest of each case counts.
run_ten_cases()
{
  local n
  for n in 1 2 3; do
    scripts/command.py ten_cases >"$results/here.$n"
    there scripts/command.py ten_cases >"$results/there.$n"
  done
}

exchange_checkpoints()
{
  local exchanged=$checkout/build/exchanged
  rm -rf "${root:?}$exchanged"
  there scripts/command.py ten_cases --begin "$exchanged/there"
  scripts/command.py ten_cases --finish "$root$exchanged/there" >"$results/begun_there"
  scripts/command.py ten_cases --begin "$root$exchanged/here"
  there scripts/command.py ten_cases --finish "$exchanged/here" >"$results/begun_here"
}

# Makes the package there and installs it in a system without compilers, where a user
# who is not root runs a ready case in a folder of hers.
try_package()
{
  there scripts/package.sh &&
    install_system "$user_root" &&
    rm -f "$user_root"/opt/*.deb &&
    cp "$root$checkout"/build/package/*.deb "$user_root/opt/" &&
    in_system "$user_root" apt-get update -q &&
    in_system "$user_root" sh -c 'apt-get install -q -y --no-install-recommends --reinstall /opt/*.deb &&
      { id user >/dev/null 2>&1 || useradd --create-home user; } && rm -rf ~user/trial' &&
    in_system "$user_root" su - user -c 'mkdir trial && cd trial &&
      elasto_plastic_contact --list-cases &&
      elasto_plastic_contact indentation/sphere_axisymmetric.prm --output-directory sphere &&
      epc evaluate sphere && epc plot sphere && ls sphere'
}

# Lines: case; number here; relative difference there; shortest seconds here, there.
print_ten_cases()
{
  printf '%-28s %22s %12s %8s %8s\n' case number difference 's here' 's there'
  paste -d ';' "$results"/here.? "$results"/there.? | awk -F ';' '
    { here = $3; there = $12
      for (i = 6; i <= 9; i += 3) if ($i < here) here = $i
      for (i = 15; i <= 18; i += 3) if ($i < there) there = $i
      printf "%-28s %22.15g %12.1e %8s %8s\n", $1, $2, $11 / $2 - 1, here, there }'
  local begun whole
  whole=$(awk -F ';' '/resume/ { print $2 }' "$results/here.1")
  for begun in there here; do
    awk -F ';' -v whole="$whole" -v begun="$begun" '
      { printf "%-28s %22.15g %12.1e\n", "begun " begun ", finished " (begun == "here" ? "there" : "here"), $2, $2 / whole - 1 }' "$results/begun_$begun"
  done
}

install_missing "${build_packages[@]}" debootstrap git python3
git diff --quiet HEAD || fail "there are changes that no commit has: they would be here, but not there"
trap unmount_kernel_folders EXIT
install_system "$root"
[ -e "$root$checkout" ] || git clone --quiet . "$root$checkout"
git -C "$root$checkout" fetch --quiet "$PWD" HEAD
git -C "$root$checkout" reset --quiet --hard FETCH_HEAD
readonly results=build/test_system/$suite
mkdir -p "$results"

started=$SECONDS
there scripts/run.sh
seconds_of_run=$((SECONDS - started))
started=$SECONDS
tests=passed
there scripts/test.sh -DWARNINGS_AS_ERRORS=ON || tests=failed
seconds_of_tests=$((SECONDS - started))

build Release
run_ten_cases
exchange_checkpoints
package="not tried"
if [ "${TEST_PACKAGE:-yes}" != no ]; then
  package="works for a user who is not root"
  try_package || package=fails
fi

cat <<END

Debian $suite, $(date -I)
  deal.II:      $(version_there libdeal.ii-dev)
  compilers:    g++ $(version_there g++), clang $(version_there clang-14)
  Open MPI:     $(version_there openmpi-bin)
  CMake:        $(version_there cmake)
  run.sh:       $seconds_of_run s
  test.sh:      $seconds_of_tests s, $tests
$(there grep -h 'tests passed' -r build --include=ctest.log | sed 's/^/  /')
  package:      $package

END
print_ten_cases
[ "$tests" = passed ] && [ "$package" != fails ]
