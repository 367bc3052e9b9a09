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
/// A request (URB) that was submitted. What came of it waits here until it is reaped, since nobody
/// may write to a program's memory at another time.
struct UsbfsRequest
{
  usbdevfs_urb* Urb = nullptr;
  void* Address = nullptr; ///< what the program calls it by
  int Outcome = 0;         ///< 0 or an errno, negative
  std::vector<std::uint8_t> Received;
  int Length = 0; ///< bytes that were carried

  bool IsRead() const { return (this->Urb->endpoint & 0x80U) != 0; }
};

/// One open file of the device's node.
struct UsbfsFile
{
  std::function<void(bool)> ShowWork; ///< told whether there is something to reap
  std::function<void()> ShowGone;     ///< told once where the device is unplugged
  std::deque<UsbfsRequest> Waiting;
  std::deque<UsbfsRequest> Finished;
  bool HasClaim = false;
  bool IsGone = false;
};

/// The kernel's usbfs in front of a virtual Falcon, in real time: claims, requests (URBs) that are
/// submitted, finished by the device, reaped and discarded. How programs get here is the front's
/// business (UsbfsShim, FalconTestBed). All functions may be called from any thread; what answers a
/// request answers 0 or an errno, negative.
///
/// Source: Linux, Documentation/driver-api/usb/usb.rst, and what libusb 1.0.26 asks for.
class UsbfsFalcon
{
public:
  /// How a program sees that the cable was pulled.
  enum class Unplugging
  {
    AbortsReads, ///< reads that wait end with an error, as the kernel does it
    RefusesNext  ///< reads that wait end well, and what is submitted next is refused
  };

  /// Keeps the address of the model, which must outlive it and is used through WithFalcon alone
  /// from now on.
  explicit UsbfsFalcon(VirtualFalcon& falcon, FalconDescriptors descriptors = {});
  ~UsbfsFalcon();
  UsbfsFalcon(const UsbfsFalcon&) = delete;
  UsbfsFalcon& operator=(const UsbfsFalcon&) = delete;

  /// Null while the device is unplugged. The functions must not call back.
  UsbfsFile* OpenFile(std::function<void(bool)> showWork, std::function<void()> showGone);
  /// Drops what was submitted and not reaped, and the claim.
  void CloseFile(UsbfsFile* file);

  /// `address` is what the program calls the request by; `urb` and its buffer have to stay where
  /// they are until it was reaped, and are written to by Reap alone.
  int Submit(UsbfsFile& file, usbdevfs_urb& urb, void* address);
  /// -EAGAIN where nothing has finished.
  int Reap(UsbfsFile& file, void*& address);
  int Discard(UsbfsFile& file, const void* address);
  /// Every other request; `argument` is its structure.
  int Answer(UsbfsFile& file, unsigned long request, void* argument);

  void Unplug(Unplugging how = Unplugging::AbortsReads,
              VirtualFalcon::Supply supply = VirtualFalcon::Supply::Lost);
  void Plug();
  /// Writes wait, as where a device takes no data, until this is called with false.
  void HoldWrites(bool hold);
  /// So many reads fail, one after the other, as on a bad cable.
  void FailReads(int count);
  /// The same of writes; what they carry does not reach the device.
  void FailWrites(int count);
  /// What is discarded is not given back, as by a kernel that hangs.
  void KeepDiscarded(bool keep);
  /// A driver of the kernel has the interface; it lets go when it is told to.
  void BindDriver(const std::string& name);
  /// As the kernel does for a process that was killed: what it had claimed is free again, and what
  /// it had submitted is gone. A front that does not notice the end of its clients calls this.
  void ReleaseClaims();
  /// Requests that were submitted and neither finished nor discarded.
  std::size_t WaitingCount();
  std::size_t WaitingWrites();
  std::size_t FileCount();

  /// Calls `use(VirtualFalcon&)` while nobody else uses the model.
  template <typename Use>
  auto WithFalcon(Use&& use)
  {
    const std::lock_guard<std::mutex> lock(this->Access);
    return use(this->Falcon);
  }
  const FalconDescriptors& Descriptors() const { return this->Texts; }

private:
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
  std::mutex Access; // of all below and of the model
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
