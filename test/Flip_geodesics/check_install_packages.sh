#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-3.0-or-later
#
#   check_install_packages.sh INSTALL_PACKAGES.SH
#
# Runs the function with programs in the place of dpkg and apt-get: one package is missing, and each command of apt-get
# finds a lock taken twice. It waits, says so, and installs; another error it passes on at once.

set -euo pipefail

script=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
mkdir bin

fake() { printf '#!/bin/sh\n%s\n' "$2" > "bin/$1" && chmod +x "bin/$1"; }
fake dpkg '[ "$2" = there ] && echo "Status: install ok installed"'
fake id 'echo 0'
fake sleep 'echo "$1" >> slept'
fake apt-get 'echo "$*" >> calls
[ "$(grep -c -- "$3" calls)" -gt 2 ] && exit 0
echo "E: $(cat reason). It is held by process 17 (apt-get)" >&2
exit 100'

fail() { echo "check_install_packages: $*" >&2; cat output errors calls >&2; exit 1; }
run() { rm -f calls slept; PATH=$work/bin:$PATH bash -euc "source '$script'; install_packages there missing" > output 2> errors; }

echo 'Could not get lock /var/lib/apt/lists/lock' > reason
run || fail "it does not wait for the lock"
[ "$(grep -c update calls)" -eq 3 ] && [ "$(grep -c 'install .* missing$' calls)" -eq 3 ] || fail "it asks otherwise"
[ "$(wc -l < slept)" -eq 4 ] || fail "it does not sleep in between"
[ "$(grep -c 'waiting for it' output)" -eq 2 ] && ! [ -s errors ] || fail "it does not say once that it waits"
grep -q -- '-o DPkg::Lock::Timeout=' calls || fail "it does not have apt wait for dpkg"

echo 'Unable to locate package missing' > reason
if run; then fail "an error is success"; fi
[ "$(wc -l < calls)" -eq 1 ] && grep -q 'Unable to locate' errors || fail "it does not pass the error on"

rm -f calls
PATH=$work/bin:$PATH bash -euc "source '$script'; install_packages --no-install there missing" > output 2> errors ||
  fail "a package that is missing is an error although none is to be installed"
! [ -e calls ] || fail "it installs although it must not"
grep -q 'apt-get install .* missing$' output && ! grep -q 'install .* there' output || fail "it does not print the command"
PATH=$work/bin:$PATH bash -euc "source '$script'; install_packages there" > output 2> errors
! [ -s output ] && ! [ -e calls ] || fail "it does something although everything is installed"
