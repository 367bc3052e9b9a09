#!/bin/sh
# Installs the packages of build/release/packages (Utilities/packages.sh) into a clean Debian 12, and runs the README's
# demonstration there, a Python script, and a program that is built with the libraries. As root, with
# mmdebstrap and Debian's archive in reach; takes some minutes and 3 GB.
#   Utilities/try-packages.sh [FOLDER]    keeps the system in FOLDER, for a look
set -eu
cd "$(dirname "$0")/.."
packages=$PWD/build/release/packages
root=${1:-$(mktemp -d)/debian}
[ -e "$packages"/palpate_*.deb ] || { echo "There are no packages: run Utilities/packages.sh" >&2; exit 1; }

if [ ! -d "$root/etc" ]; then
  echo "== Debian 12 in $root"
  mmdebstrap --variant=minbase --quiet bookworm "$root"
fi
inside() {
  chroot "$root" env LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive sh -euc "$1"
}
end() {
  umount "$root/proc" "$root/dev" 2>/dev/null || true
  [ -n "${kept:-}" ] || rm -rf --one-file-system "$root"
}
kept=${1:-}
trap end EXIT
mount -t proc proc "$root/proc"
mount --bind /dev "$root/dev"
rm -rf "$root/try"
mkdir -p "$root/try/Utilities"
cp "$packages"/*.deb "$root/try"
cp Utilities/demo.sh "$root/try/Utilities"
cp -r Testing/Install/Consumer "$root/try/consumer"

echo "== python3-palpate, without VTK"
mkdir "$root/try/examples"
cp Documentation/Python/*.py "$root/try/examples"
inside "apt-get update -qq
  apt-get install -qq -y --no-install-recommends /try/libpalpate1_*.deb /try/python3-palpate_*.deb >/try/python.log 2>&1 ||
    { tail -20 /try/python.log; exit 1; }
  if ls /usr/lib/*/libvtk* 2>/dev/null; then echo 'VTK was installed'; exit 1; fi
  cd /try/examples && for example in *.py; do python3 -B \$example || [ \$? -eq 77 ]; done"
echo "== palpate, palpate-viewer, python3-palpate-vtk"
inside "
  apt-get install -qq -y --no-install-recommends /try/palpate_*.deb /try/palpate-viewer_*.deb \
    /try/python3-palpate-vtk_*.deb mricron-data xvfb xauth libgl1-mesa-dri >/try/install.log 2>&1 ||
    { tail -20 /try/install.log; exit 1; }"
echo "== The demonstration"
inside "cd /try && Utilities/demo.sh /usr/bin"
inside "test -s /try/demo-output/report.html && test -s /try/demo-output/viewer.png"
echo "== Python, the modules of 3D Slicer, MIME type"
inside "python3 -c 'from palpate import vtkSegmentationSurface; print(vtkSegmentationSurface().GetClassName())'
  /usr/lib/palpate/slicer-cli/PalpateFit --xml | head -3
  test -s /usr/share/man/man1/palpate.1.gz || echo 'manual pages are left out here'
  test -s /usr/share/mime/packages/palpate.xml"
echo "== libpalpate-dev"
inside "apt-get install -qq -y --no-install-recommends /try/libpalpate-dev_*.deb g++ cmake make >/try/dev.log 2>&1 ||
    { tail -20 /try/dev.log; exit 1; }
  cmake -S /try/consumer -B /try/consumer-build -DCMAKE_BUILD_TYPE=Release >/try/cmake.log 2>&1 ||
    { tail -20 /try/cmake.log; exit 1; }
  cmake --build /try/consumer-build >/try/build.log 2>&1 || { tail -20 /try/build.log; exit 1; }
  /try/consumer-build/consumer"
echo "== Removal"
inside "apt-get purge -qq -y palpate palpate-viewer python3-palpate python3-palpate-vtk libpalpate-dev libpalpate1 >/dev/null 2>&1
  ! ls /usr/bin/palpate* /usr/lib/libPalpate* /usr/lib/libpalpate* 2>/dev/null"
echo "== Every package works in a clean Debian 12."
