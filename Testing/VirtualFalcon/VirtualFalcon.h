#pragma once

#include "VirtualFalconBoard.h"
#include "VirtualFalconFaults.h"
#include "VirtualFtdiChip.h"
#include "VirtualMechanism.h"

#include <cstddef>
#include <cstdint>

namespace palpate::test
{
/// A simulated Falcon: chip, boot loader, running firmware, mechanism and a hand on it, as seen
/// from USB. It does not depend on a USB library; a front end (an injected FalconLink, usbfs calls,
/// umockdev) passes control requests and bulk packets. Written from the facts about the device; it
/// shares no code with the driver.
///
/// Time (ns, any origin) is an argument of each call and must not decrease. The same calls give the
/// same bits. Not thread-safe: front ends lock it.
class VirtualFalcon
{
public:
  static constexpr std::uint16_t VendorId = 0x0403;
  static constexpr std::uint16_t ProductId = 0xCB48;
  static constexpr std::uint8_t EndpointOut = 0x02;
  static constexpr std::uint8_t EndpointIn = 0x81;
  static constexpr std::size_t PacketSize = 64;
  static constexpr std::int64_t Never = VirtualFtdiChip::Never;
  /// Result of a control request that stalls.
  static constexpr int Stall = -1;
  static constexpr int NoDevice = -2;

  explicit VirtualFalcon(const VirtualMechanismSettings& settings = {});

  /// bmRequestType 0x40, no data: 0, Stall or NoDevice.
  int ControlOut(std::uint8_t request, std::uint16_t value, std::uint16_t index, std::int64_t now);
  /// bmRequestType 0xC0: number of bytes answered, Stall or NoDevice.
  int ControlIn(std::uint8_t request, std::uint16_t value, std::uint16_t index, std::uint8_t* bytes,
                std::size_t capacity, std::int64_t now);
  /// Returns false if unplugged. Any number of bytes; USB packets are not modelled here.
  bool BulkOut(const std::uint8_t* bytes, std::size_t count, std::int64_t now);
  /// The next IN packet (at most 64 bytes, starting with two of status) that is due by `now`; 0:
  /// none. Call until there is none.
  std::size_t BulkIn(std::uint8_t* packet, std::int64_t now);
  /// Time to call BulkIn again; there may still be no packet. Never if unplugged.
  std::int64_t NextDue(std::int64_t now);

  /// Whether the board keeps its own supply when the USB cable is unplugged. If it does, the
  /// firmware keeps running and holds the last torque, which is the worst case; otherwise firmware,
  /// homing and torque are lost.
  enum class Supply
  {
    Lost,
    Kept
  };
  void Unplug(std::int64_t now, Supply supply = Supply::Lost);
  /// Does nothing if plugged in.
  void Plug(std::int64_t now);
  /// As if another program had loaded the firmware.
  void StartLoaded() { this->Brain.StartLoaded(); }
  bool IsPluggedIn() const { return this->Plugged; }

  /// Takes effect at the next call.
  VirtualFalconFaults Faults;

  /// The mechanism with the hand, as of the last call.
  VirtualMechanism& Mechanism() { return this->Body; }
  const VirtualFalconBoard& Board() const { return this->Brain; }
  const VirtualFtdiChip& Chip() const { return this->Serial; }

private:
  void AdvanceTo(std::int64_t now);

  VirtualFtdiChip Serial;
  VirtualMechanism Body;
  VirtualFalconBoard Brain;
  bool Plugged = true;
};
} // namespace palpate::test
