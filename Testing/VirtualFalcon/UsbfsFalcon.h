#pragma once

#include "FalconDescriptors.h"
#include "VirtualFalcon.h"

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <linux/usbdevice_fs.h>
#include <list>
#include <mutex>
#include <string>
#include <sys/ioctl.h>
#include <thread>
#include <vector>

namespace palpate::test
{
/// A submitted request (URB). Its result waits here until it is reaped, since a program's memory
/// must not be written at another time.
struct UsbfsRequest
{
  usbdevfs_urb* Urb = nullptr;
  void* Address = nullptr; ///< the program's identifier of the request
  int Outcome = 0;         ///< 0 or an errno, negative
  std::vector<std::uint8_t> Received;
  int Length = 0; ///< bytes transferred

  bool IsRead() const { return (this->Urb->endpoint & 0x80U) != 0; }
};

/// One open file of the device's node.
struct UsbfsFile
{
  std::function<void(bool)> ShowWork; ///< called with whether there is something to reap
  std::function<void()> ShowGone;     ///< called once when the device is unplugged
  std::deque<UsbfsRequest> Waiting;
  std::deque<UsbfsRequest> Finished;
  bool HasClaim = false;
  bool IsGone = false;
};

/// The kernel's usbfs in front of a virtual Falcon, in real time: claims, and requests (URBs) that
/// are submitted, finished by the device, reaped and discarded. Front ends (UsbfsShim,
/// FalconTestBed) connect programs to it. All functions may be called from any thread; functions
/// that answer a request return 0 or a negative errno.
///
/// Source: Linux, Documentation/driver-api/usb/usb.rst, and what libusb 1.0.26 asks for.
class UsbfsFalcon
{
public:
  /// Effect of unplugging for a program.
  enum class Unplugging
  {
    AbortsReads, ///< pending reads end with an error, as in the kernel
    RefusesNext  ///< pending reads end normally, and the next request is refused
  };

  /// Keeps the address of the model, which must outlive it and must from now on only be used
  /// through WithFalcon.
  explicit UsbfsFalcon(VirtualFalcon& falcon, FalconDescriptors descriptors = {});
  ~UsbfsFalcon();
  UsbfsFalcon(const UsbfsFalcon&) = delete;
  UsbfsFalcon& operator=(const UsbfsFalcon&) = delete;

  /// Null while the device is unplugged. The functions must not call back.
  UsbfsFile* OpenFile(std::function<void(bool)> showWork, std::function<void()> showGone);
  /// Drops requests that were not reaped, and the claim.
  void CloseFile(UsbfsFile* file);

  /// `address` is the program's identifier of the request; `urb` and its buffer must stay valid
  /// until it is reaped, and only Reap writes to them.
  int Submit(UsbfsFile& file, usbdevfs_urb& urb, void* address);
  /// -EAGAIN if no request has finished.
  int Reap(UsbfsFile& file, void*& address);
  int Discard(UsbfsFile& file, const void* address);
  /// Every other request; `argument` is its structure.
  int Answer(UsbfsFile& file, unsigned long request, void* argument);

  void Unplug(Unplugging how = Unplugging::AbortsReads,
              VirtualFalcon::Supply supply = VirtualFalcon::Supply::Lost);
  void Plug();
  /// Blocks writes, as if a device takes no data, until this is called with false.
  void HoldWrites(bool hold);
  /// Makes `count` consecutive reads fail, as on a bad cable.
  void FailReads(int count);
  /// The same for writes; their data does not reach the device.
  void FailWrites(int count);
  /// Does not return discarded requests, as in a kernel that hangs.
  void KeepDiscarded(bool keep);
  /// A kernel driver claims the interface; it releases it on request.
  void BindDriver(const std::string& name);
  /// As the kernel does for a killed process: releases its claim and drops its requests. For a
  /// front end that does not notice the end of its clients.
  void ReleaseClaims();
  /// Number of requests that were neither finished nor discarded.
  std::size_t WaitingCount();
  std::size_t WaitingWrites();
  std::size_t FileCount();

  /// Calls `use(VirtualFalcon&)` with exclusive access to the model as it is now: bytes that the
  /// chip has taken reach the board also if no program waits for replies any more.
  template <typename Use>
  auto WithFalcon(Use&& use)
  {
    const std::lock_guard<std::mutex> lock(this->Access);
    this->BringUpToDate();
    return use(this->Falcon);
  }
  const FalconDescriptors& Descriptors() const { return this->Texts; }

private:
  void BringUpToDate();
  void Serve();
  void Serve(UsbfsFile& file);
  void TakeAway(UsbfsFile& file, Unplugging how);
  void TakeReads(UsbfsFile& file, std::int64_t now);
  bool Fill(UsbfsRequest& read, std::int64_t now);
  void TakeWrites(UsbfsFile& file, std::int64_t now);
  int Control(const usbdevfs_ctrltransfer& setup, std::uint8_t* data);
  void FinishControl(UsbfsRequest& request);
  int Claim(UsbfsFile& file, bool detaches);

  VirtualFalcon& Falcon;
  FalconDescriptors Texts;
  std::mutex Access; // guards everything below and the model
  std::condition_variable Changed;
  std::list<UsbfsFile> Files;
  std::string Driver;
  bool HoldsWrites = false;
  bool KeepsDiscarded = false;
  int ReadFailures = 0; // still to come
  int WriteFailures = 0;
  bool IsEnding = false;
  std::thread Server;
};
} // namespace palpate::test
