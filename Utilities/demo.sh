#!/bin/sh
# Installs what is missing, builds, and runs the main job on real MR data that Debian ships: some
# structures of the Colin 27 head, fitted, measured and drawn into demo-output/. With a folder of
# installed programs as its argument (/usr/bin) it installs and builds nothing.
set -eu
cd "$(dirname "$0")/.."
templates=/usr/share/mricron/templates
output=demo-output

programs=${1:-build/release/bin}
if [ $# -eq 0 ]; then
  Utilities/install-dependencies.sh demo
  # Without tests, benchmarks and Python: some of their packages may be installed and others not.
  # Utilities/test.sh adds them to the same folder.
  Utilities/build.sh --preset demo
fi

echo "== Demonstration: twelve structures of $templates/aal.nii.gz, as spherical-harmonic models"
set -- fit "$templates/aal.nii.gz" --volume "$templates/ch2.nii.gz" --output "$output" --label \
  Hippocampus_L,Hippocampus_R,Caudate_L,Caudate_R,\
Thalamus_L,Thalamus_R,Pallidum_L,Pallidum_R,Amygdala_L,Amygdala_R,Cerebelum_9_L,Cerebelum_9_R
echo "$programs/palpate $*"
"$programs/palpate" "$@"
# These draw with OpenGL, which needs an X server.
palpate=$programs/palpate
[ -n "${DISPLAY:-}" ] || palpate="xvfb-run -a $palpate"
set -- render "$output"/aal_*/model.vtp --volume "$templates/ch2.nii.gz" --slices sagittal,axial \
  --size 900x700 --output "$output/structures.png"
echo "$palpate render $output/aal_*/model.vtp --volume … --output $output/structures.png"
$palpate "$@"
set -- render "$output/aal_77_Thalamus_L/model.vtp" --array DistanceToSurface \
  --output "$output/thalamus-error.png"
echo "$palpate $*"
$palpate "$@"

# With a screen: a window with the same head; without one: a screenshot of it.
viewer=$programs/palpate-viewer
if [ -x "$viewer" ] && [ -n "${DISPLAY:-}" ]; then
  echo "$viewer --demo &"
  "$viewer" --demo &
elif [ -x "$viewer" ]; then
  echo "xvfb-run -a $viewer --demo --screenshot $output/viewer.png"
  xvfb-run -a "$viewer" --demo --screenshot "$output/viewer.png"
fi

cat <<END

== Done. In $output/:
END
ls "$output"
cat <<END

How to go on:
  open $output/report.html in a browser (it needs no network), and the images
  $programs/palpate-viewer --demo   the same head in a window, to see and to touch
  $programs/palpate fit $templates/aal.nii.gz --json
                                            all 116 structures
  $programs/palpate --help          every command, with examples
  $programs/palpate fit --help      every setting of the fit
  $programs/palpate info FILE...    what is in your own files
END
