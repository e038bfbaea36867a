# SPDX-License-Identifier: LGPL-3.0-or-later
#
# For examples/run.sh and test/run.sh, which read this file with `source`.

# apt_get(arguments...): apt-get as root, without questions. While another package manager is at work it waits, up to ten
# minutes: for the lock of dpkg by apt's own option, for those of lists and archives, which that does not cover, by trying
# again.
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

# missing_packages(package...): prints those that are not installed, on one line.
missing_packages() {
  local package missing=()
  for package in "$@"; do
    dpkg -s "$package" 2> /dev/null | grep -q '^Status: install ok installed' || missing+=("$package")
  done
  echo "${missing[*]}"
}

# install_packages([--no-install] package...): installs the Debian packages that are missing, as root or by sudo, and
# prints the command first. With --no-install it prints the command and continues with what is installed, as it does on a
# system without Debian packages. Without the rights to install it prints the command and ends the script.
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
    # Without a terminal sudo must not ask for a password.
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
