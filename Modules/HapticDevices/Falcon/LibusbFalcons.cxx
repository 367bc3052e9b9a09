#include "LibusbFalcons.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <thread>
#include <utility>

namespace palpate
{
namespace
{
constexpr int Vendor = 0x0403; // FTDI
constexpr int Product = 0xCB48;
constexpr int Interface = 0;

struct DeviceReleaser
{
  void operator()(libusb_device* device) const noexcept { libusb_unref_device(device); }
};

struct FalconOnBus
{
  std::unique_ptr<libusb_device, DeviceReleaser> Device;
  std::string BusPath;
};

std::string BusPathOf(libusb_device* device)
{
  std::array<std::uint8_t, 7> ports{}; // the maximum depth of USB 3
  const int depth = libusb_get_port_numbers(device, ports.data(), static_cast<int>(ports.size()));
  std::string path = std::to_string(libusb_get_bus_number(device));
  for (int n = 0; n < depth; ++n)
  {
    path += (n == 0 ? "-" : ".") + std::to_string(ports.at(static_cast<std::size_t>(n)));
  }
  return path;
}

bool IsFalcon(libusb_device* device)
{
  libusb_device_descriptor descriptor{};
  return libusb_get_device_descriptor(device, &descriptor) == LIBUSB_SUCCESS &&
         descriptor.idVendor == Vendor && descriptor.idProduct == Product;
}

Status FalconsOn(libusb_context& context, std::vector<FalconOnBus>& falcons)
{
  libusb_device** devices = nullptr;
  const ssize_t count = libusb_get_device_list(&context, &devices);
  if (count < 0)
  {
    return Status::Failure("The devices on USB cannot be listed (" +
                           std::string(libusb_strerror(static_cast<int>(count))) + ").");
  }
  for (ssize_t n = 0; n < count; ++n)
  {
    if (IsFalcon(devices[n]))
    {
      FalconOnBus& falcon = falcons.emplace_back();
      falcon.Device.reset(libusb_ref_device(devices[n]));
      falcon.BusPath = BusPathOf(devices[n]);
    }
  }
  libusb_free_device_list(devices, 1);
  std::sort(falcons.begin(), falcons.end(),
            [](const FalconOnBus& one, const FalconOnBus& other)
            { return one.BusPath < other.BusPath; });
  return Status::Success();
}

// "The Falcon" or "The Falcon at USB 1-2".
std::string Named(const std::string& busPath)
{
  return busPath.empty() ? "The Falcon" : "The Falcon at USB " + busPath;
}

// The driver of the interface, by Linux's name: "usbfs" is a program. Empty if there is none or it
// is unknown.
std::string DriverOf(const std::string& busPath)
{
  std::error_code unknown;
  const std::filesystem::path link =
      std::filesystem::read_symlink("/sys/bus/usb/devices/" + busPath + ":1.0/driver", unknown);
  return unknown ? "" : link.filename().string();
}

std::string BusyMessage(const std::string& busPath)
{
  const std::string driver = DriverOf(busPath);
  return driver.empty() || driver == "usbfs"
             ? Named(busPath) + " is used by another program: close that first."
             : Named(busPath) + " is held by the kernel's driver " + driver +
                   ", which does not let go: unload it by 'sudo modprobe -r " + driver + "'.";
}

std::string Message(int error, const std::string& busPath)
{
  switch (error)
  {
  case LIBUSB_ERROR_ACCESS:
    return Named(busPath) + " may not be used by this user: install its udev rule by 'sudo "
                            "Utilities/install-udev-rule.sh', then unplug it and plug it in again.";
  case LIBUSB_ERROR_BUSY:
    return BusyMessage(busPath);
  case LIBUSB_ERROR_NO_DEVICE:
    return Named(busPath) + " was unplugged: plug it in again.";
  default:
    return Named(busPath) + " cannot be opened (" + libusb_strerror(error) +
           "): unplug it and plug it in again.";
  }
}

std::string SerialOf(libusb_device_handle* handle)
{
  libusb_device_descriptor descriptor{};
  std::array<unsigned char, 128> text{}; // maximum length of a USB string
  if (libusb_get_device_descriptor(libusb_get_device(handle), &descriptor) != LIBUSB_SUCCESS ||
      descriptor.iSerialNumber == 0)
  {
    return "";
  }
  const int length = libusb_get_string_descriptor_ascii(handle, descriptor.iSerialNumber,
                                                        text.data(), static_cast<int>(text.size()));
  return {text.begin(), text.begin() + std::max(length, 0)};
}

// A FalconGuard briefly holds a device that was closed without 0 N, so claiming is retried.
Status Claim(libusb_device_handle* handle, const std::string& busPath)
{
  constexpr auto Patience = std::chrono::milliseconds(500);
  constexpr auto Nap = std::chrono::milliseconds(20);
  // Platforms that cannot detach drivers do not need it.
  static_cast<void>(libusb_set_auto_detach_kernel_driver(handle, 1));
  int error = libusb_claim_interface(handle, Interface);
  const auto end = std::chrono::steady_clock::now() + Patience;
  while (error == LIBUSB_ERROR_BUSY && std::chrono::steady_clock::now() < end)
  {
    std::this_thread::sleep_for(Nap);
    error = libusb_claim_interface(handle, Interface);
  }
  return error == LIBUSB_SUCCESS ? Status::Success() : Status::Failure(Message(error, busPath));
}

Status OpenAndClaim(const FalconOnBus& falcon, const std::string& serial, LibusbHandle& handle)
{
  libusb_device_handle* opened = nullptr;
  const int error = libusb_open(falcon.Device.get(), &opened);
  if (error != LIBUSB_SUCCESS)
  {
    return Status::Failure(Message(error, falcon.BusPath));
  }
  LibusbHandle owned(opened);
  if (!serial.empty() && SerialOf(opened) != serial)
  {
    return Status::Failure("There is no Falcon at USB or with serial number " + serial + ".");
  }
  Status status = Claim(opened, falcon.BusPath);
  if (status.IsOk())
  {
    handle = std::move(owned);
  }
  return status;
}

FalconListing Inspect(const FalconOnBus& falcon)
{
  FalconListing listing;
  listing.BusPath = falcon.BusPath;
  libusb_device_handle* opened = nullptr;
  const int error = libusb_open(falcon.Device.get(), &opened);
  if (error != LIBUSB_SUCCESS)
  {
    listing.Obstacle = Message(error, falcon.BusPath);
    return listing;
  }
  const LibusbHandle handle(opened);
  listing.Serial = SerialOf(opened);
  if (DriverOf(falcon.BusPath) == "usbfs")
  {
    listing.Obstacle = BusyMessage(falcon.BusPath);
  }
  return listing;
}
} // namespace

void LibusbHandleCloser::operator()(libusb_device_handle* handle) const noexcept
{
  // Fails harmlessly if the device is gone or was not claimed.
  static_cast<void>(libusb_release_interface(handle, Interface));
  libusb_close(handle);
}

Status MakeLibusbContext(LibusbContext& context)
{
  libusb_context* made = nullptr;
  const int error = libusb_init(&made);
  if (error != LIBUSB_SUCCESS)
  {
    return Status::Failure("USB cannot be used on this machine (" +
                           std::string(libusb_strerror(error)) +
                           "): is there a /dev/bus/usb that this user may read?");
  }
  context.reset(made);
  return Status::Success();
}

Status ListFalcons(libusb_context& context, std::vector<FalconListing>& listings)
{
  std::vector<FalconOnBus> falcons;
  Status status = FalconsOn(context, falcons);
  for (const FalconOnBus& falcon : falcons)
  {
    listings.push_back(Inspect(falcon));
  }
  return status;
}

Status OpenFalcon(libusb_context& context, const std::string& which, LibusbHandle& handle)
{
  std::vector<FalconOnBus> falcons;
  Status listed = FalconsOn(context, falcons);
  if (!listed.IsOk())
  {
    return listed;
  }
  if (falcons.empty())
  {
    return Status::Failure("There is no Falcon on USB (0403:cb48): plug in its cable and its power "
                           "supply.");
  }
  const auto named =
      std::find_if(falcons.begin(), falcons.end(),
                   [&which](const FalconOnBus& one) { return one.BusPath == which; });
  if (named != falcons.end())
  {
    return OpenAndClaim(*named, "", handle);
  }
  Status first = OpenAndClaim(falcons.front(), which, handle);
  for (std::size_t n = 1; n < falcons.size() && handle == nullptr; ++n)
  {
    static_cast<void>(OpenAndClaim(falcons[n], which, handle).IsOk());
  }
  return handle != nullptr ? Status::Success() : std::move(first);
}

std::string BusPathOf(libusb_device_handle& handle)
{
  return BusPathOf(libusb_get_device(&handle));
}

Status OpenFalcon(libusb_context& context, int descriptor, LibusbHandle& handle)
{
  libusb_device_handle* opened = nullptr;
  const int error = libusb_wrap_sys_device(&context, descriptor, &opened);
  if (error != LIBUSB_SUCCESS)
  {
    return Status::Failure(Message(error, ""));
  }
  LibusbHandle owned(opened);
  Status status = Claim(opened, "");
  if (status.IsOk())
  {
    handle = std::move(owned);
  }
  return status;
}
} // namespace palpate
