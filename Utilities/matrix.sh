#!/bin/sh
# Compiles Palpate with warnings as errors and runs its tests on other systems, each made for it, and prints a line of
# Documentation/Evidence/Systems.md for each. As root, with mmdebstrap and Debian's archive in reach; a row takes half an hour to an hour and 8 GB.
#   Utilities/matrix.sh [-k FOLDER] [-c] [-t REGEX] ROW…
# Rows: 12, 13, unstable: that Debian with its GCC; 12-clang, 13-clang, unstable-clang: with its Clang; 13-arm64: the kernels for arm64, compiled on
# Debian 13 and run by qemu. -k keeps the systems in FOLDER, where a second run goes on; -c only compiles; -t runs only tests of these names.
set -eu
cd "$(dirname "$0")/.."
. Utilities/debian.sh
keep=
compiles_only=
tests=.
while getopts k:ct: option; do
  case $option in
  k) keep=$OPTARG ;;
  c) compiles_only=yes ;;
  t) tests=$OPTARG ;;
  *) exit 2 ;;
  esac
done
shift $((OPTIND - 1))
[ $# -gt 0 ] || { sed -n '2,7s/^# \{0,1\}//p' "$0" >&2; exit 2; }
base=${keep:-$(mktemp -d)}
mkdir -p "$base"
end() {
  close_systems
  [ -n "$keep" ] || rm -rf --one-file-system "$base"
}
trap end EXIT

# What a build and its tests need: not tools for the format and the documentation, whose output depends on their version, and not the benchmarks'.
packages=$(grep -v '^#' Utilities/packages.txt |
  grep -vE '^(clang-format|clang-tidy|doxygen|valgrind|snakemake|python3-matplotlib|lib(gsl|sharp|benchmark)-dev)$' |
  paste -sd,)
kernel_packages=ccache,cmake,ninja-build,pkg-config,libeigen3-dev,libboost-dev,nlohmann-json3-dev,python3

# The row's suite, packages and options of CMake and mmdebstrap.
describe() {
  suite=
  options="-DPALPATE_BUILD_BENCHMARKS=OFF"
  wanted=$packages
  system_options=
  case $1 in
  12*) suite=bookworm ;;
  13*) suite=trixie ;;
  unstable*) suite=sid ;;
  esac
  case $1 in
  12 | 13 | unstable) ;;
  12-clang | 13-clang | unstable-clang)
    wanted=$wanted,clang
    options="$options -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++"
    ;;
  13-arm64)
    wanted=$kernel_packages,crossbuild-essential-arm64,qemu-user,libblas-dev:arm64,libopenblas0-pthread:arm64,libgtest-dev:arm64,libstdc++6:arm64
    system_options=--architectures=amd64,arm64
    options="$options -DPALPATE_USE_VTK=OFF -DPALPATE_WRAP_PYTHON=OFF -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64"
    options="$options -DCMAKE_C_COMPILER=aarch64-linux-gnu-gcc -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++"
    options="$options -DCMAKE_LIBRARY_ARCHITECTURE=aarch64-linux-gnu -DCMAKE_CROSSCOMPILING_EMULATOR=/usr/bin/qemu-aarch64"
    ;;
  *) echo "There is no row $1." >&2 && exit 2 ;;
  esac
}

# The versions of a row's compiler and libraries, for the table.
versions() {
  inside "$1" "cd /source/build/release
    compiler=\$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' CMakeCache.txt)
    \$compiler --version | sed -n '1s/ (.*) / /p;1s/ version / /p' | sort -u | head -1
    dpkg-query --show --showformat='\${source:Package} \${source:Upstream-Version}\n' libvtk9-dev libinsighttoolkit5-dev qtbase5-dev \
      qt6-base-dev libeigen3-dev 2>/dev/null | sort -u" | paste -sd, | sed 's/,/, /g'
}

for row in "$@"; do
  root=$base/$row
  describe "$row"
  # shellcheck disable=SC2086 # a list of words
  make_system "$suite" "$root" "$wanted" $system_options
  copy_source "$root"
  echo "== $row: build"
  result="compiles without warnings"
  inside "$root" "cd /source && cmake --preset release --log-level=WARNING -Wno-dev $options >/configure.log 2>&1 || { cat /configure.log; exit 1; }
    cmake --build build/release -- -k 0 >/build.log 2>&1" || result="**does not compile**"
  passed="not run"
  if [ "$result" = "compiles without warnings" ] && [ -z "$compiles_only" ]; then
    echo "== $row: tests"
    inside "$root" "cd /source && set -- ctest --preset release -R '$tests'
      ! command -v xvfb-run >/dev/null || set -- xvfb-run -a -s '-screen 0 1280x1024x24 -noreset' \"\$@\"
      \"\$@\" >/tests.log 2>&1" || true
    passed=$(sed -n 's/^\(.*\) tests passed, \(.*\) tests failed out of \(.*\)$/\2 of \3 failed/p' "$root/tests.log")
    sed -n '/following tests FAILED/,$p' "$root/tests.log"
  fi
  grep -A 12 '^FAILED' "$root/build.log" | head -60 || true
  echo "| $(date +%F) | $row | $(versions "$root") | $result | $passed |"
done
