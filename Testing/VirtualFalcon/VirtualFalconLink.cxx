#include "VirtualFalconLink.h"

#include <algorithm>

namespace palpate::test
{
namespace
{
constexpr std::size_t Capacity = 512; // bytes, of the queue
} // namespace

Status VirtualFalconLink::Open()
{
  if (this->OpenFailures > 0)
  {
    --this->OpenFailures;
    return Status::Failure("The Falcon cannot be claimed just now.");
  }
  if (!this->Device.IsPluggedIn())
  {
    return Status::Failure("There is no Falcon: plug it in and switch it on.");
  }
  if (this->IsBusy)
  {
    return Status::Failure("Another program uses the Falcon: end it.");
  }
  this->Waiting.clear();
  this->Waiting.reserve(1U << 16U);
  this->Queue.clear();
  this->Stop.clear();
  this->Packets = {};
  this->Gone = false;
  this->IsOpen = true;
  return Status::Success();
}

void VirtualFalconLink::Close() noexcept
{
  this->IsOpen = false;
}

Status VirtualFalconLink::Control(FtdiRequest request)
{
  this->Fetch();
  const int length =
      this->Device.ControlOut(request.Request, request.Value, request.Index, this->Time.Now());
  this->Gone = this->Gone || length == VirtualFalcon::NoDevice;
  if (request.Request == 0 && request.Value != 1)
  {
    this->Waiting.clear();
  }
  return length == 0 ? Status::Success()
                     : Status::Failure("The Falcon's serial chip refused a request.");
}

bool VirtualFalconLink::Send(const std::uint8_t* bytes, std::size_t count) noexcept
{
  const std::size_t capacity = this->Stop.empty() ? Capacity : ArmedCapacity;
  if (!this->IsOpen || this->Gone || this->Queue.size() + count > capacity)
  {
    return false;
  }
  this->Queue.insert(this->Queue.end(), bytes, bytes + count);
  this->Flush();
  return !this->Gone;
}

void VirtualFalconLink::ArmStop(const std::uint8_t* bytes, std::size_t count) noexcept
{
  this->Stop.assign(bytes, bytes + count);
}

bool VirtualFalconLink::SendStop() noexcept
{
  this->Queue.clear();
  return !this->Stop.empty() && this->Send(this->Stop.data(), this->Stop.size());
}

void VirtualFalconLink::Flush() noexcept
{
  if (!this->HoldsWrites && !this->Queue.empty())
  {
    this->Gone = !this->Device.BulkOut(this->Queue.data(), this->Queue.size(), this->Time.Now());
    this->Queue.clear();
  }
}

void VirtualFalconLink::Fetch() noexcept
{
  this->Flush();
  std::uint8_t packet[VirtualFalcon::PacketSize];
  while (const std::size_t size = this->Device.BulkIn(packet, this->Time.Now()))
  {
    const std::size_t length = this->Packets.Strip(packet, size, packet);
    this->Waiting.insert(this->Waiting.end(), packet, packet + length);
  }
  this->Gone = this->Gone || !this->Device.IsPluggedIn();
}

std::size_t VirtualFalconLink::Receive(std::uint8_t* bytes, std::size_t capacity) noexcept
{
  if (!this->IsOpen)
  {
    return 0;
  }
  this->Fetch();
  const std::size_t count = std::min(capacity, this->Waiting.size());
  const auto end = this->Waiting.begin() + static_cast<std::ptrdiff_t>(count);
  std::copy(this->Waiting.begin(), end, bytes);
  this->Waiting.erase(this->Waiting.begin(), end);
  return count;
}
} // namespace palpate::test
