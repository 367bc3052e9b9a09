#!/bin/sh
# Makes the Debian packages and the relocatable archive from build/release into build/release/packages,
# and checks them: lintian without an error or warning, no library under the GPL in the archive, which
# then runs from a folder with another name and without the build tree's libraries.
# Utilities/try-packages.sh installs the packages in a clean system.
set -eu
cd "$(dirname "$0")/.."
packages=$PWD/build/release/packages

for tool in lintian patchelf; do
  command -v $tool >/dev/null || { echo "$tool is missing: apt-get install lintian patchelf" >&2; exit 1; }
done
Utilities/build.sh
rm -rf "$packages"
echo "== Debian packages"
(cd build/release && cpack -G DEB >"$PWD/cpack.log" 2>&1) || { tail -20 build/release/cpack.log >&2; exit 1; }
rm -rf "$packages/_CPack_Packages"
lintian --allow-root --fail-on error,warning "$packages"/*.deb
echo "== Archive"
version=$(build/release/bin/palpate --version | cut -d' ' -f2)
archive=$packages/palpate-$version-linux-$(uname -m).tar.gz
/usr/bin/python3 Utilities/archive.py build/release "$archive"
code=0
/usr/bin/python3 Utilities/licences.py "${archive%.tar.gz}" >"$packages/licences.txt" || code=$?
cat "$packages/licences.txt"
[ $code -eq 0 ] || exit $code
moved=$(mktemp -d)
trap 'rm -rf "$moved"' EXIT
mv "${archive%.tar.gz}" "$moved/else where"
"$moved/else where/bin/palpate" --version
"$moved/else where/bin/palpate-viewer" --version
"$moved/else where/lib/palpate/slicer-cli/PalpateMesh" --xml >/dev/null
ls -lh "$packages"
