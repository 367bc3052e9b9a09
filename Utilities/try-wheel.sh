#!/bin/sh
# Builds an sdist and, from it, a wheel in a clean Debian, which has scikit-build-core; installs the wheel into virtual environments without network and
# without the tools and libraries that built it, one without VTK and one with PyVista, and runs the examples of
# Documentation/Python there. As root, with mmdebstrap and Debian's archive in reach; takes some minutes and 3 GB.
#   Utilities/try-wheel.sh [-s SUITE] [FOLDER]    in trixie (Debian 13) unless SUITE says otherwise; leaves sdist and wheel in FOLDER
set -eu
cd "$(dirname "$0")/.."
. Utilities/debian.sh
suite=trixie
if [ "${1:-}" = -s ]; then
  suite=$2
  shift 2
fi
base=$(mktemp -d)
build=build-essential,cmake,ninja-build,pkg-config,libeigen3-dev,libboost-dev,nlohmann-json3-dev,libblas-dev,libusb-1.0-0-dev
build=$build,pybind11-dev,python3-pybind11,python3-dev,python3-build,python3-venv,python3-scikit-build-core,python3-pathspec
use=python3-venv,python3-numpy,libblas3,libusb-1.0-0

end() {
  close_systems
  rm -rf --one-file-system "$base"
}
trap end EXIT

# try_wheel NAME PACKAGES: the wheel in a virtual environment of a system with these packages. A script that exits with 77 was skipped.
try_wheel() {
  make_system "$suite" "$base/$1" "$2"
  mkdir "$base/$1/try"
  cp "$base"/build/dist/*.whl "$base/$1/try"
  cp -r Documentation/Python "$base/$1/try/examples"
  cp Testing/Python/test_arrays.py Testing/Python/test_without_vtk.py Testing/Python/test_stub.py "$base/$1/try"
  echo "== Wheel in a virtual environment: $1"
  inside_offline "$base/$1" "cd /try
    python3 -m venv --system-site-packages env
    env/bin/pip install --no-index --quiet *.whl
    for script in examples/*.py test_*.py; do env/bin/python \$script || [ \$? -eq 77 ]; done"
}

make_system "$suite" "$base/build" "$build"
copy_source "$base/build"
echo "== sdist and wheel"
inside_offline "$base/build" "cd /source && python3 -m build --no-isolation --outdir /dist >/build.log 2>&1 || { tail -40 /build.log; exit 1; }
  ls -l /dist"
try_wheel without-vtk "$use"
try_wheel with-pyvista "$use,python3-pyvista"
# The example is skipped where PyVista cannot be imported; here it must not be.
inside_offline "$base/with-pyvista" "cd /try && env/bin/python examples/with_pyvista.py"
[ $# -eq 0 ] || { mkdir -p "$1" && cp "$base"/build/dist/* "$1"; }
echo "== The wheel works in a clean Debian ($suite)."
