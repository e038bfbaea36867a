# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Functions for examples/run.sh and test/run.sh, which read this file with `source`.

# apt_get(arguments...): runs apt-get as root, without questions. If another package manager is running, waits for up to
# ten minutes: for the lock of dpkg by an option of apt, and for the locks of lists and archives by trying again.
apt_get() {
  local attempt log
  log=$(mktemp)
  for attempt in {1..120}; do
    if "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -o DPkg::Lock::Timeout=600 "$@" \
      < /dev/null 2> "$log"; then
      cat "$log" >&2
      rm -f "$log"
      return
    fi
    grep -q 'Could not get lock' "$log" || break
    if [ "$attempt" -eq 1 ]; then
      echo "Another package manager is running; waiting for it for up to ten minutes."
    fi
    sleep 5
  done
  cat "$log" >&2
  rm -f "$log"
  return 1
}

# missing_packages(package...): prints the packages that are not installed, on one line.
missing_packages() {
  local package missing=()
  for package in "$@"; do
    dpkg -s "$package" 2> /dev/null | grep -q '^Status: install ok installed' || missing+=("$package")
  done
  echo "${missing[*]}"
}

# install_packages([--no-install] package...): prints the command that installs the missing Debian packages, and runs it
# as root or by sudo. With --no-install, the command is only printed, and the script continues. On systems without
# Debian packages, nothing is installed, and the script continues. If the user is not allowed to install packages, the
# command is printed, and the script ends.
install_packages() {
  local may_install=1 missing
  if [ "${1-}" = --no-install ]; then
    may_install=0
    shift
  fi
  if ! command -v dpkg > /dev/null; then
    echo "This system has no Debian packages; continuing with what is installed."
    return
  fi
  missing=$(missing_packages "$@")
  if [ -z "$missing" ]; then
    return
  fi
  local command="apt-get update && apt-get install -y --no-install-recommends $missing"
  if [ $may_install -eq 0 ]; then
    echo "Packages are missing; this command installs them as root: $command"
    return
  fi
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    as_root=(sudo)
    # Without a terminal, sudo must not ask for a password.
    [ -t 0 ] || as_root=(sudo -n)
    if ! "${as_root[@]}" true 2> /dev/null; then
      echo "Packages are missing. Install them with this command and start again:" >&2
      echo "su -c '$command'" >&2
      exit 1
    fi
  fi
  echo "== installing: $command"
  apt_get update -q
  # shellcheck disable=SC2086 # one argument per package
  apt_get install -y -q --no-install-recommends $missing
}
