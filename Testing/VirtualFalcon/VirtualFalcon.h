#pragma once

#include "VirtualFalconBoard.h"
#include "VirtualFalconFaults.h"
#include "VirtualFtdiChip.h"
#include "VirtualMechanism.h"

#include <cstddef>
#include <cstdint>

namespace palpate::test
{
/// A Falcon that is computed: chip, boot loader, running firmware, mechanism and a hand on it, as
/// USB sees them. It knows no USB library; whoever stands in front of it (an injected FalconLink,
/// usbfs calls, umockdev) hands on control requests and bulk packets. Written from the facts about
/// the device, not from the driver: it shares no code with it.
///
/// Time (ns, any origin) comes with each call and never falls. The same calls give the same bits.
/// Not for two threads at once: a front locks it.
class VirtualFalcon
{
public:
  static constexpr std::uint16_t VendorId = 0x0403;
  static constexpr std::uint16_t ProductId = 0xCB48;
  static constexpr std::uint8_t EndpointOut = 0x02;
  static constexpr std::uint8_t EndpointIn = 0x81;
  static constexpr std::size_t PacketSize = 64;
  static constexpr std::int64_t Never = VirtualFtdiChip::Never;
  /// What a control request answers where it answers no length.
  static constexpr int Stall = -1;
  static constexpr int NoDevice = -2;

  explicit VirtualFalcon(const VirtualMechanismSettings& settings = {});

  /// bmRequestType 0x40, no data: 0, Stall or NoDevice.
  int ControlOut(std::uint8_t request, std::uint16_t value, std::uint16_t index, std::int64_t now);
  /// bmRequestType 0xC0: how many bytes it answered, Stall or NoDevice.
  int ControlIn(std::uint8_t request, std::uint16_t value, std::uint16_t index, std::uint8_t* bytes,
                std::size_t capacity, std::int64_t now);
  /// False where it is unplugged. Any number of bytes; USB's packets do not show here.
  bool BulkOut(const std::uint8_t* bytes, std::size_t count, std::int64_t now);
  /// The next IN packet (at most 64 bytes, two of status first) that is due by `now`; 0: none. Ask
  /// again until there is none.
  std::size_t BulkIn(std::uint8_t* packet, std::int64_t now);
  /// Ask BulkIn again then; there may still be none. Never where it is unplugged.
  std::int64_t NextDue(std::int64_t now);

  /// Whether the board keeps its own supply when the USB cable comes out. With it the firmware runs
  /// on and holds the last torque, which is the worst case; without, firmware, home and torque are
  /// lost.
  enum class Supply
  {
    Lost,
    Kept
  };
  void Unplug(std::int64_t now, Supply supply = Supply::Lost);
  /// Nothing where it is plugged in.
  void Plug(std::int64_t now);
  /// As if another program had loaded the firmware.
  void StartLoaded() { this->Brain.StartLoaded(); }
  bool IsPluggedIn() const { return this->Plugged; }

  /// In effect from the next call on.
  VirtualFalconFaults Faults;

  /// What the hand does and feels; as of the last call.
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
