#pragma once

#include "FalconFinder.h"

#include <libusb.h>
#include <memory>
#include <string>
#include <vector>

namespace palpate
{
struct LibusbContextCloser
{
  void operator()(libusb_context* context) const noexcept { libusb_exit(context); }
};
/// Also releases the interface, so that the next program can claim it at once.
struct LibusbHandleCloser
{
  void operator()(libusb_device_handle* handle) const noexcept;
};
using LibusbContext = std::unique_ptr<libusb_context, LibusbContextCloser>;
using LibusbHandle = std::unique_ptr<libusb_device_handle, LibusbHandleCloser>;

/// A separate context, which tracks the devices plugged in from now on.
Status MakeLibusbContext(LibusbContext& context);

/// Every device with a Falcon's USB ids (0403:cb48), ordered by bus path. None is claimed; those
/// that this user may open are opened to read their serial number.
Status ListFalcons(libusb_context& context, std::vector<FalconListing>& listings);

/// Opens and claims the Falcon with this bus path or serial number; if `which` is empty, the first
/// usable one. A kernel driver is detached until it is closed again. On failure the message is
/// about the device that came closest.
Status OpenFalcon(libusb_context& context, const std::string& which, LibusbHandle& handle);
/// The same from a descriptor of an open usbfs node, which must stay open as long as the handle.
Status OpenFalcon(libusb_context& context, int descriptor, LibusbHandle& handle);
/// USB port of an open Falcon, as in ListFalcons.
std::string BusPathOf(libusb_device_handle& handle);
} // namespace palpate
