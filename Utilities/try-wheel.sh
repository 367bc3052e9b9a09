#!/bin/sh
# Builds an sdist and, from it, a wheel in a clean Debian 13, which has scikit-build-core; installs the wheel into a virtual
# environment without network, without VTK and without the tools and libraries that built it, and runs the examples of
# Documentation/Python there. As root, with mmdebstrap and Debian's archive in reach; takes some minutes and 2 GB.
#   Utilities/try-wheel.sh [FOLDER]    leaves sdist and wheel in FOLDER
set -eu
cd "$(dirname "$0")/.."
base=$(mktemp -d)
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Label: Debian' | head -1)
build=build-essential,cmake,ninja-build,pkg-config,libeigen3-dev,nlohmann-json3-dev,libblas-dev,libusb-1.0-0-dev
build=$build,pybind11-dev,python3-pybind11,python3-dev,python3-build,python3-venv,python3-scikit-build-core,python3-pathspec
use=python3-venv,python3-numpy,libblas3,libusb-1.0-0

end() {
  umount "$base/build/proc" "$base/build/dev" "$base/use/proc" "$base/use/dev" 2>/dev/null || true
  rm -rf --one-file-system "$base"
}
trap end EXIT
# debian NAME PACKAGES: a system in $base/NAME
debian() {
  echo "== Debian 13: $1"
  mmdebstrap --variant=minbase --quiet --include="$2" trixie "$base/$1" "$mirror"
  mount -t proc proc "$base/$1/proc"
  mount --bind /dev "$base/$1/dev"
}
# inside NAME COMMANDS: without network
inside() {
  unshare --net chroot "$base/$1" env LC_ALL=C.UTF-8 sh -euxc "$2"
}

debian build "$build"
mkdir "$base/build/source"
tar -c --exclude=./build --exclude=./.git . | tar -x -C "$base/build/source"
echo "== sdist and wheel"
inside build "cd /source && python3 -m build --no-isolation --outdir /dist >/build.log 2>&1 || { tail -40 /build.log; exit 1; }
  ls -l /dist"

debian use "$use"
mkdir "$base/use/try"
cp "$base"/build/dist/*.whl "$base/use/try"
cp -r Documentation/Python "$base/use/try/examples"
cp Testing/Python/test_arrays.py Testing/Python/test_without_vtk.py Testing/Python/test_stub.py "$base/use/try"
echo "== Wheel in a virtual environment"
inside use "cd /try
  python3 -m venv --system-site-packages env
  env/bin/pip install --no-index --quiet *.whl
  for script in examples/*.py test_*.py; do env/bin/python \$script; done"
[ $# -eq 0 ] || { mkdir -p "$1" && cp "$base"/build/dist/* "$1"; }
echo "== The wheel works in a clean Debian 13."
