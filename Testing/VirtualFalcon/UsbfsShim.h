#pragma once

#include "UsbfsFalcon.h"

namespace palpate::test
{
/// usbfs within the test's own process. A program that links UsbfsShim.cxx overrides ioctl, close,
/// read and lseek, so that libusb's calls for a descriptor from here reach a virtual Falcon; all
/// others go to libc. So the real libusb, opened from a descriptor (libusb_wrap_sys_device), needs
/// neither hardware nor privileges nor a preloaded library.
///
/// A descriptor is the writing end of a pipe with one slot, so that poll behaves as on usbfs:
/// writable while there is something to reap, broken once the device is unplugged.
class UsbfsShim
{
public:
  /// Keeps the address.
  explicit UsbfsShim(UsbfsFalcon& falcon) : Falcon(falcon) {}

  /// Like open() of the device's node; -1 and errno on failure. The caller closes the descriptor.
  int Open();

private:
  UsbfsFalcon& Falcon;
};
} // namespace palpate::test
