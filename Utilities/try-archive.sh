#!/bin/sh
# Unpacks the archive of build/release/packages (Utilities/packages.sh) in a clean Debian 13, which has other versions of
# every library, and fits, draws and shows a phantom there. As root, with mmdebstrap and Debian's archive in reach.
set -eu
cd "$(dirname "$0")/.."
. Utilities/debian.sh
archive=$(ls "$PWD"/build/release/packages/palpate-*-linux-*.tar.gz)
root=$(mktemp -d)/debian
# Packages that the archive leaves to the system, and an X server.
system=libgl1,libopengl0,libegl1,libgl1-mesa-dri,libx11-xcb1,libxcb-glx0,libsm6,libice6,libfontconfig1,libdbus-1-3,libuuid1
end() {
  close_systems
  rm -rf --one-file-system "$root"
}
trap end EXIT
make_system trixie "$root" "$system,xvfb,xauth"
tar -xzf "$archive" -C "$root/opt"
inside "$root" "set -x; cd /tmp
  palpate=/opt/$(basename "$archive" .tar.gz)
  \$palpate/bin/palpate phantom --output body --spacing 2,2,3
  \$palpate/bin/palpate fit body/mask.nii.gz --volume body/volume.nii.gz --output out
  xvfb-run -a \$palpate/bin/palpate render out/model.vtp --output model.png
  xvfb-run -a \$palpate/bin/palpate-viewer body/volume.nii.gz body/mask.nii.gz --screenshot window.png
  \$palpate/lib/palpate/slicer-cli/PalpateMesh --output surface.vtp body/mask.nii.gz
  test -s out/report.html && test -s model.png && test -s window.png && test -s surface.vtp"
echo "== The archive works in a clean Debian 13."
