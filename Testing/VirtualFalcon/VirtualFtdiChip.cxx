#include "VirtualFtdiChip.h"

#include <algorithm>
#include <cmath>

namespace palpate::test
{
namespace
{
constexpr std::size_t Payload = 62; // of a packet of 64 bytes
constexpr double BitsPerByte = 10.0;
} // namespace

bool VirtualFtdiChip::Matches(double baud, double other)
{
  return std::abs(baud - other) <= 0.03 * other;
}

bool VirtualFtdiChip::ControlOut(std::uint8_t request, std::uint16_t value, std::uint16_t index,
                                 std::int64_t now)
{
  switch (request)
  {
  case 0:
    this->Purge(value);
    return value <= 2;
  case 1:
    this->Dtr = (value & 0x0100U) != 0 ? (value & 0x01U) != 0 : this->Dtr;
    this->Rts = (value & 0x0200U) != 0 ? (value & 0x02U) != 0 : this->Rts;
    return true;
  case 2:
    return true;
  case 3:
    this->SetBaud(value, index);
    return true;
  case 4:
    return value == 0x0008;
  case 6:
    this->EventCharacter = (value & 0x0100U) != 0 ? value & 0xFF : -1;
    return true;
  case 9:
    this->Latency = 1'000'000LL * std::clamp<int>(value & 0xFF, 1, 255);
    this->LastPacket = std::max(this->LastPacket, now);
    return true;
  default:
    return false;
  }
}

int VirtualFtdiChip::ControlIn(std::uint8_t request, std::uint8_t* bytes,
                               std::size_t capacity) const
{
  if (request == 10 && capacity >= 1)
  {
    bytes[0] = static_cast<std::uint8_t>(this->Latency / 1'000'000);
    return 1;
  }
  if (request == 5 && capacity >= 2)
  {
    bytes[0] = this->ModemStatus();
    bytes[1] = 0x60;
    return 2;
  }
  return -1;
}

void VirtualFtdiChip::SetBaud(std::uint16_t value, std::uint16_t index)
{
  constexpr int eighthsOf[8] = {0, 4, 2, 1, 3, 5, 6, 7};
  const int whole = value & 0x3FFF;
  const int eighths = eighthsOf[(value >> 14U) | (index & 1U) << 2U];
  const double divisor = whole == 0 ? 1.0 : whole == 1 ? 1.5 : whole + eighths / 8.0;
  this->Rate = 3e6 / divisor;
}

void VirtualFtdiChip::Purge(std::uint16_t which)
{
  if (which != 2)
  {
    this->Outgoing.clear();
    this->WireFree = 0;
  }
  if (which != 1)
  {
    this->Incoming.clear();
  }
}

void VirtualFtdiChip::Transmit(const std::uint8_t* bytes, std::size_t count, std::int64_t now)
{
  const std::int64_t duration = std::llround(1e9 * BitsPerByte / this->Rate);
  for (std::size_t i = 0; i < count; ++i)
  {
    this->WireFree = std::max(this->WireFree, now) + duration;
    this->Outgoing.push_back({this->WireFree, this->Rate, bytes[i]});
  }
}

std::int64_t VirtualFtdiChip::NextTransmitted() const
{
  return this->Outgoing.empty() ? Never : this->Outgoing.front().Time;
}

bool VirtualFtdiChip::TakeTransmitted(std::int64_t now, WireByte& byte)
{
  if (this->NextTransmitted() > now)
  {
    return false;
  }
  byte = this->Outgoing.front();
  this->Outgoing.pop_front();
  return true;
}

void VirtualFtdiChip::Receive(const WireByte& byte)
{
  this->Incoming.push_back(byte);
  if (!Matches(byte.Baud, this->Rate))
  {
    this->Incoming.back().Value = static_cast<std::uint8_t>(byte.Value ^ 0xA5U);
    this->Framing = true;
  }
}

void VirtualFtdiChip::SetClearToSend(bool level, std::int64_t now)
{
  if (level != this->Cts)
  {
    this->Cts = level;
    this->StatusChanged = true;
    this->StatusTime = now;
  }
}

std::uint8_t VirtualFtdiChip::ModemStatus() const
{
  return static_cast<std::uint8_t>(0x01U | (this->Cts ? 0x10U : 0U));
}

std::int64_t VirtualFtdiChip::NextPacket() const
{
  std::int64_t due = this->LastPacket + this->Latency;
  if (this->StatusChanged)
  {
    due = std::min(due, this->StatusTime);
  }
  const std::size_t inPacket = std::min(Payload, this->Incoming.size());
  if (inPacket == Payload)
  {
    due = std::min(due, this->Incoming[Payload - 1].Time);
  }
  for (std::size_t i = 0; i < inPacket && this->EventCharacter >= 0; ++i)
  {
    if (this->Incoming[i].Value == this->EventCharacter)
    {
      return std::min(due, this->Incoming[i].Time);
    }
  }
  return due;
}

std::size_t VirtualFtdiChip::TakePacket(std::uint8_t* packet, std::int64_t now)
{
  std::int64_t due = this->NextPacket();
  if (due > now)
  {
    return 0;
  }
  const std::int64_t news =
      std::min(now, this->Incoming.empty() ? now : this->Incoming.front().Time);
  if (!this->StatusChanged && due + this->Latency <= news)
  {
    due += (news - due) / this->Latency * this->Latency;
  }
  packet[0] = this->ModemStatus();
  packet[1] = static_cast<std::uint8_t>(0x60U | (this->Framing ? 0x08U : 0U));
  std::size_t size = 2;
  while (size < Payload + 2 && !this->Incoming.empty() && this->Incoming.front().Time <= due)
  {
    packet[size++] = this->Incoming.front().Value;
    this->Incoming.pop_front();
  }
  this->Framing = false;
  this->StatusChanged = false;
  this->LastPacket = std::max(this->LastPacket, due);
  return size;
}
} // namespace palpate::test
