#!/bin/sh
# Lets ordinary users use a Falcon: installs its udev rule and has udev apply it.
#   sudo Utilities/install-udev-rule.sh
#   Utilities/install-udev-rule.sh FOLDER    only copies the rule there
set -eu
rule=70-palpate-falcon.rules
here=$(cd "$(dirname "$0")" && pwd)
folder=${1:-/etc/udev/rules.d}

if ! mkdir -p "$folder" 2>/dev/null || ! [ -w "$folder" ]; then
  echo "$folder is not writable: run this as root, sudo $0" >&2
  exit 1
fi
install -m 644 "$here/$rule" "$folder/$rule"
echo "== $folder/$rule is installed."
[ $# -eq 0 ] || exit 0

if command -v udevadm >/dev/null; then
  udevadm control --reload
  udevadm trigger --subsystem-match=usb --attr-match=idVendor=0403 --attr-match=idProduct=cb48
  echo "== It is in effect; if a Falcon is still refused, unplug it and plug it in again."
else
  echo "== udevadm is missing; the rule takes effect at the next start."
fi
