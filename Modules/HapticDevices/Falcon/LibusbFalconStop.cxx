#include "LibusbFalconStop.h"

#include "FalconBoot.h"
#include "FalconPackets.h"
#include "LibusbFalcons.h"

#include <chrono>
#include <thread>

namespace palpate
{
namespace
{
constexpr unsigned StopDeadline = 250; // ms, per request and per packet
constexpr int Repeats = 3;
constexpr std::chrono::milliseconds Interval(2);

bool Control(libusb_device_handle& handle, const FtdiRequest& request)
{
  constexpr int VendorOut =
      int{LIBUSB_ENDPOINT_OUT} | int{LIBUSB_REQUEST_TYPE_VENDOR} | int{LIBUSB_RECIPIENT_DEVICE};
  return libusb_control_transfer(&handle, VendorOut, request.Request, request.Value, request.Index,
                                 nullptr, 0, StopDeadline) >= 0;
}

bool Send(libusb_device_handle& handle, FalconPacket packet)
{
  constexpr unsigned char EndpointOut = 0x02;
  int sent = 0;
  return libusb_bulk_transfer(&handle, EndpointOut, packet.data(), static_cast<int>(packet.size()),
                              &sent, StopDeadline) == LIBUSB_SUCCESS;
}
} // namespace

Status StopFalcon(const std::string& busPath)
{
  LibusbContext context;
  LibusbHandle handle;
  Status status = MakeLibusbContext(context);
  status = status.IsOk() ? OpenFalcon(*context, busPath, handle) : status;
  if (!status.IsOk())
  {
    return status;
  }
  bool isHeard = true;
  for (const FtdiRequest& request : FalconBoot::RunMode())
  {
    isHeard = isHeard && Control(*handle, request);
  }
  FalconRequest stop;
  stop.IsHoming = true;
  for (int n = 0; n < Repeats && isHeard; ++n)
  {
    isHeard = Send(*handle, Encoded(stop));
    std::this_thread::sleep_for(Interval);
  }
  return isHeard ? Status::Success()
                 : Status::Failure("The Falcon takes no data: unplug it and its power supply.");
}
} // namespace palpate
