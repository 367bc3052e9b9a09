#!/bin/sh
# Builds the plugin for ParaView in a clean Debian 12, against its ParaView 5.11, installs it there, and drives it by pvpython on Debian's
# brain atlas (Applications/ParaView/drive.py). As root, with mmdebstrap and Debian's archive in reach; takes a
# quarter of an hour and 6 GB.
#   Utilities/try-paraview.sh [FOLDER]    keeps the system in FOLDER, for a look and a faster second run
set -eu
cd "$(dirname "$0")/.."
. Utilities/debian.sh
root=${1:-$(mktemp -d)/debian}
kept=${1:-}
# ParaView's package names libraries whose development files it does not depend on.
packages=build-essential,ccache,cmake,ninja-build,pkg-config,paraview-dev,python3-paraview,python3-numpy
packages=$packages,mpi-default-dev,libgl-dev,libopengl-dev,libglew-dev,libutfcpp-dev,libfreetype-dev,libpugixml-dev
packages=$packages,libprotobuf-dev,protobuf-compiler,libxt-dev,libxcursor-dev,libdouble-conversion-dev,liblz4-dev,liblzma-dev
packages=$packages,libexpat1-dev,libjpeg-dev,libtiff-dev,libxml2-dev,libpython3-dev,qtbase5-dev,libqt5svg5-dev,qttools5-dev
packages=$packages,libcgns-dev,libnetcdf-dev,libgl2ps-dev,libogg-dev,libtheora-dev,libjsoncpp-dev,libsqlite3-dev,libproj-dev,libhpdf-dev
packages=$packages,libinsighttoolkit5-dev,libdcmtk-dev,libopenjp2-7-dev,libeigen3-dev,libboost-dev,libblas-dev,libopenblas0-pthread
packages=$packages,nlohmann-json3-dev,zlib1g-dev,libx11-dev,xvfb,xauth,libgl1-mesa-dri,mricron-data

end() {
  close_systems
  [ -n "$kept" ] || rm -rf --one-file-system "$root"
}
trap end EXIT
make_system bookworm "$root" "$packages"
copy_source "$root"
echo "== Build"
inside "$root" "cd /source
  cmake --preset release --log-level=WARNING -Wno-dev -DPALPATE_BUILD_PARAVIEW=ON -DCMAKE_INSTALL_PREFIX=/opt/palpate >/build.log 2>&1 ||
    { tail -20 /build.log; exit 1; }
  cmake --build build/release >>/build.log 2>&1 || { grep -A 20 FAILED /build.log | head -60; exit 1; }
  cmake --install build/release >/dev/null
  ls -l /opt/palpate/lib/paraview-5.11/plugins/Palpate/Palpate.so"
echo "== pvpython"
inside "$root" "rm -rf /out && mkdir /out && cp /source/Testing/Integration/Version-0.1.0/model.json /out
  cd /out && xvfb-run -a -s '-screen 0 1280x1024x24 -noreset' pvpython /source/Applications/ParaView/drive.py \
    /opt/palpate/lib/paraview-5.11/plugins/Palpate/Palpate.so /usr/share/mricron/templates /out/model.json /out"
echo "== The plugin works in Debian 12's ParaView; its pictures: $root/out"
