#!/bin/sh
# Installs the Debian packages of Utilities/packages.txt that are missing. If none is missing it
# changes nothing and needs no network.
#   Utilities/install-dependencies.sh [demo]    with "demo" only what the programs and the demonstration need
set -eu
here=$(cd "$(dirname "$0")" && pwd)
last='$'
[ "${1:-}" != demo ] || last='/^# For Python, tests/'

missing=
for package in $(sed -n "1,${last}{/^#/!p}" "$here/packages.txt"); do
  state=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$state" = installed ] || missing="$missing $package"
done

if [ -z "$missing" ]; then
  echo "== Packages: all are installed."
  exit 0
fi

echo "== Packages: installing$missing"
as_root=
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "Installing packages needs root: run this as root, or install sudo." >&2
    exit 1
  fi
  as_root=sudo
fi
$as_root apt-get update -qq
# shellcheck disable=SC2086 # a list of words
$as_root env DEBIAN_FRONTEND=noninteractive \
  apt-get install --yes --no-install-recommends -qq $missing
