#include "VirtualFalcon.h"

#include <algorithm>

namespace palpate::test
{
VirtualFalcon::VirtualFalcon(const VirtualMechanismSettings& settings) : Body(settings) {}

// Processes events on the wire and on the board in the order of time.
void VirtualFalcon::AdvanceTo(std::int64_t now)
{
  for (;;)
  {
    const std::int64_t wire = this->Serial.NextTransmitted();
    const std::int64_t board = this->Brain.NextEvent();
    if (std::min(wire, board) > now)
    {
      break;
    }
    this->Body.AdvanceTo(std::min(wire, board));
    VirtualFtdiChip::WireByte byte{};
    if (board <= wire)
    {
      this->Brain.Advance(board, this->Serial, this->Body, this->Faults);
    }
    else if (this->Serial.TakeTransmitted(now, byte))
    {
      this->Brain.Receive(byte, this->Serial, this->Body, this->Faults);
    }
    const std::uint64_t last = this->Faults.UnplugAtReply;
    if (this->Brain.WantsUnplug() || (last != 0 && this->Brain.Replies() >= last))
    {
      this->Unplug(now);
    }
  }
  this->Body.AdvanceTo(now);
}

int VirtualFalcon::ControlOut(std::uint8_t request, std::uint16_t value, std::uint16_t index,
                              std::int64_t now)
{
  this->AdvanceTo(now);
  if (!this->Plugged)
  {
    return NoDevice;
  }
  if (request == this->Faults.StalledRequest ||
      !this->Serial.ControlOut(request, value, index, now))
  {
    return Stall;
  }
  if (this->Faults.HasSupply)
  {
    this->Brain.SetDataTerminalReady(this->Serial.DataTerminalReady(), now, this->Serial);
  }
  return 0;
}

int VirtualFalcon::ControlIn(std::uint8_t request, std::uint16_t, std::uint16_t,
                             std::uint8_t* bytes, std::size_t capacity, std::int64_t now)
{
  this->AdvanceTo(now);
  if (!this->Plugged)
  {
    return NoDevice;
  }
  return request == this->Faults.StalledRequest ? Stall
                                                : this->Serial.ControlIn(request, bytes, capacity);
}

bool VirtualFalcon::BulkOut(const std::uint8_t* bytes, std::size_t count, std::int64_t now)
{
  this->AdvanceTo(now);
  if (this->Plugged)
  {
    this->Serial.Transmit(bytes, count, now);
  }
  return this->Plugged;
}

std::size_t VirtualFalcon::BulkIn(std::uint8_t* packet, std::int64_t now)
{
  this->AdvanceTo(now);
  return this->Plugged ? this->Serial.TakePacket(packet, now) : 0;
}

std::int64_t VirtualFalcon::NextDue(std::int64_t now)
{
  this->AdvanceTo(now);
  return this->Plugged ? std::min({this->Serial.NextPacket(), this->Serial.NextTransmitted(),
                                   this->Brain.NextEvent()})
                       : Never;
}

void VirtualFalcon::Unplug(std::int64_t now, Supply supply)
{
  this->Plugged = false;
  this->Serial = {};
  this->Body.AdvanceTo(now);
  if (supply == Supply::Lost)
  {
    this->Brain.PowerOff();
    this->Body.SetMotors({});
    this->Body.ForgetHome();
  }
}

void VirtualFalcon::Plug(std::int64_t now)
{
  this->AdvanceTo(now);
  if (!this->Plugged)
  {
    this->Serial = {};
    this->Plugged = true;
  }
}
} // namespace palpate::test
