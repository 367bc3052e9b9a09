#!/bin/sh
# Runs the tests from a fault to 0 N at a Falcon's board, and writes their table into
# Documentation/Safety.md.
set -eu
cd "$(dirname "$0")/.."

Utilities/build.sh
bin=build/release/bin
out=build/release/safety
mkdir -p "$out"
"$bin/FalconTests" --gtest_brief=1 --gtest_filter='*FalconStop*' --gtest_output="json:$out/virtual-time.json"
"$bin/FalconUsbTests" --gtest_brief=1 --gtest_filter='*StopOverUsb*' --gtest_output="json:$out/libusb.json"
"$bin/Inverse3Tests" --gtest_brief=1 --gtest_filter='*Inverse3Faults*' --gtest_repeat=50 \
  --gtest_output="json:$out/inverse3.json"
"$bin/VendorTests" --gtest_brief=1 --gtest_filter='*VendorFaults*' --gtest_repeat=50 \
  --gtest_output="json:$out/library.json"
umockdev-wrapper "$bin/FalconBusTests" --gtest_brief=1 --gtest_filter='FalconGuardOfLink*' \
  --gtest_output="json:$out/guard.json"
umockdev-wrapper "$bin/CliFalconTests" --gtest_brief=1 --gtest_filter='*CliFalconEnds*' \
  --gtest_output="json:$out/virtual-bus.json"
exec /usr/bin/python3 Utilities/safety.py "$out"/*.json
