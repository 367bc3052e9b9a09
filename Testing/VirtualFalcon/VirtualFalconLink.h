#pragma once

#include "Clock.h"
#include "FalconLink.h"
#include "FtdiPackets.h"
#include "VirtualFalcon.h"

#include <vector>

namespace palpate::test
{
/// The cable to a VirtualFalcon, without any USB: a driver's requests reach the model at the
/// clock's time, and packets arrive as if reads had been pending. Keeps both addresses.
class VirtualFalconLink final : public FalconLink
{
public:
  VirtualFalconLink(VirtualFalcon& falcon, const Clock& clock) : Device(falcon), Time(clock) {}

  Status Open() override;
  void Close() noexcept override;
  Status Control(FtdiRequest request) override;
  bool Send(const std::uint8_t* bytes, std::size_t count) noexcept override;
  std::size_t Receive(std::uint8_t* bytes, std::size_t capacity) noexcept override;
  bool ClearToSend() const noexcept override { return this->Packets.ClearToSend(); }
  void ArmStop(const std::uint8_t* bytes, std::size_t count) noexcept override;
  bool SendStop() noexcept override;
  bool IsGone() const noexcept override { return this->Gone; }

  /// Another program has the device: Open fails.
  bool IsBusy = false;
  /// The device takes nothing: sent data waits in the queue, until that is full.
  bool HoldsWrites = false;
  /// Number of further calls of Open that fail.
  int OpenFailures = 0;

private:
  void Fetch() noexcept;
  void Flush() noexcept;

  VirtualFalcon& Device;
  const Clock& Time;
  FtdiPackets Packets;
  std::vector<std::uint8_t> Waiting; // received, not yet taken
  std::vector<std::uint8_t> Queue;   // sent, held back
  std::vector<std::uint8_t> Stop;    // set by ArmStop
  bool IsOpen = false;
  bool Gone = false;
};
} // namespace palpate::test
