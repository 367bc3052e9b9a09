#!/bin/sh
# Installs the Debian packages of Utilities/packages.txt that are missing. If none is missing it
# changes nothing and needs no network.
#   Utilities/install-dependencies.sh [demo]    with "demo" only what the programs and the demonstration need
set -eu
here=$(cd "$(dirname "$0")" && pwd)
demo=${1:-}

# missing_of FROM TO: those of the list between two of its headings.
missing_of() {
  # shellcheck disable=SC2013 # a word a line
  for package in $(sed -n "$1,$2{/^#/!p}" "$here/packages.txt"); do
    state=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$state" = installed ] || printf ' %s' "$package"
  done
}

if [ "$demo" = demo ]; then
  missing=$(missing_of 1 '/^# For Python, tests/')
  judges=
else
  missing=$(missing_of 1 '/^# Judges/')
  judges=$(missing_of '/^# Judges/' '$')
fi

if [ -z "$missing$judges" ]; then
  echo "== Packages: all are installed."
  exit 0
fi

echo "== Packages: installing$missing$judges"
as_root=
if [ "$(id -u)" -ne 0 ]; then
  as_root=sudo
  if ! command -v sudo >/dev/null; then
    echo "Installing packages needs root: run this as root, or install sudo." >&2
    [ -z "$missing" ] # judges alone are not necessary
    exit
  fi
fi
$as_root apt-get update -qq || [ -z "$missing" ]
# install PACKAGE…
install() {
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends -qq "$@"
}
# shellcheck disable=SC2086 # lists of words
[ -z "$missing" ] || install $missing
# shellcheck disable=SC2086
[ -z "$judges" ] || install $judges || echo "== Packages: without$judges; tests that need them skip."
