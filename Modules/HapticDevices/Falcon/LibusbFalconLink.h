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
/// The cable to a real Falcon, by libusb. Each Open begins from nothing, so a device that was
/// unplugged and is back can be opened again by the same object. A FalconGuard is beside it while
/// it is open, but not where a descriptor was given.
class LibusbFalconLink final : public FalconLink
{
public:
  /// Gives a descriptor of an opened usbfs node, for the link to close, or -1.
  using DescriptorSource = std::function<int()>;

  /// `which` as MakeLink's.
  explicit LibusbFalconLink(std::string which);
  /// For devices that somebody else opens: a broker, a test.
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
  std::string BusPath; // that it was started for last
  std::string Which;
  DescriptorSource Source;
  int Descriptor = -1;
  // In this order, so that each is gone before what it uses.
  LibusbContext Context;
  LibusbHandle Handle;
  std::unique_ptr<LibusbTraffic> Traffic;
};
} // namespace palpate
