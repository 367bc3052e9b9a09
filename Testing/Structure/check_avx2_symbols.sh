#!/bin/sh
# Fails if an object compiled for AVX2 defines a weak symbol that another object may define too: the
# linker keeps one of them, which an older processor would then run. Functions with Avx2 in their name,
# of a class or of Eigen in its renamed namespace, are unique to the object.
#   check_avx2_symbols.sh OBJECTS...
set -eu
found=0
for object in "$@"; do
  case $object in
    *Avx2.cxx.o | */MomentKernel.cxx.o | */TriangleKernel.cxx.o | */NearestKernel.cxx.o | */InsideKernel.cxx.o | */RayKernel.cxx.o) ;;
    *) continue ;;
  esac
  found=$((found + 1))
  shared=$(nm --defined-only --demangle "$object" | grep -E ' [WVu] ' | grep -v -e Avx2 -e ' DW.ref' || true)
  if [ -n "$shared" ]; then
    echo "$object shares functions with objects for older processors:" >&2
    echo "$shared" >&2
    exit 1
  fi
done
if [ "$found" -eq 0 ]; then
  echo "no object for AVX2 among: $*" >&2
  exit 1
fi
echo "$found objects for AVX2 share no function."
