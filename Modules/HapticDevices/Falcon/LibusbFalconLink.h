#pragma once

#include "FalconGuard.h"
#include "FalconLink.h"
#include "LibusbFalcons.h"
#include "LibusbTraffic.h"

#include <functional>
#include <memory>
#include <string>

namespace palpate
{
/// The cable to a real Falcon, by libusb. Each Open starts from scratch, so a device that was
/// unplugged and plugged in again can be opened by the same object. A FalconGuard runs while it is
/// open, except with a given descriptor.
class LibusbFalconLink final : public FalconLink
{
public:
  /// Returns a descriptor of an opened usbfs node, which the link closes, or -1.
  using DescriptorSource = std::function<int()>;

  /// `which` as for MakeLink.
  explicit LibusbFalconLink(std::string which);
  /// For devices that are opened elsewhere, by a broker or a test.
  explicit LibusbFalconLink(DescriptorSource source);
  ~LibusbFalconLink() override { this->LibusbFalconLink::Close(); }

  Status Open() override;
  void Close() noexcept override;
  Status Control(FtdiRequest request) override;
  bool Send(const std::uint8_t* bytes, std::size_t count) noexcept override;
  void ArmStop(const std::uint8_t* bytes, std::size_t count) noexcept override;
  bool SendStop() noexcept override;
  std::size_t Receive(std::uint8_t* bytes, std::size_t capacity) noexcept override;
  bool ClearToSend() const noexcept override;
  bool IsGone() const noexcept override;
  std::string Caution() const override;

private:
  Status OpenHandle();

  FalconGuard Guard;
  std::string BusPath; // the guard's last one
  std::string Which;
  DescriptorSource Source;
  int Descriptor = -1;
  // In this order, so that each is destroyed before its dependencies.
  LibusbContext Context;
  LibusbHandle Handle;
  std::unique_ptr<LibusbTraffic> Traffic;
};
} // namespace palpate
