#include "LibusbFalconLink.h"

#include <unistd.h>
#include <utility>

namespace palpate
{
LibusbFalconLink::LibusbFalconLink(std::string which) : Which(std::move(which)) {}

LibusbFalconLink::LibusbFalconLink(DescriptorSource source) : Source(std::move(source)) {}

Status LibusbFalconLink::OpenHandle()
{
  Status status = MakeLibusbContext(this->Context);
  if (!status.IsOk() || this->Source == nullptr)
  {
    return status.IsOk() ? OpenFalcon(*this->Context, this->Which, this->Handle) : status;
  }
  this->Descriptor = this->Source();
  return this->Descriptor >= 0 ? OpenFalcon(*this->Context, this->Descriptor, this->Handle)
                               : Status::Failure("There is no Falcon: plug it in.");
}

Status LibusbFalconLink::Open()
{
  if (this->Traffic != nullptr)
  {
    return Status::Failure("The link to the Falcon is open already.");
  }
  // The guard may hold the device, and is needed again if nothing else can stop the motors.
  const bool isOwed = this->Guard.WasCalled();
  this->Guard.Dismiss();
  Status status = this->OpenHandle();
  if (status.IsOk() && this->Source == nullptr)
  {
    this->BusPath = BusPathOf(*this->Handle);
    this->Guard.Start(this->BusPath);
  }
  if (status.IsOk())
  {
    this->Traffic = std::make_unique<LibusbTraffic>(this->Context.get(), this->Handle.get(),
                                                    [this] { this->Guard.Call(); });
    status = this->Traffic->Start();
  }
  if (!status.IsOk())
  {
    this->Close();
    if (isOwed && this->Guard.Start(this->BusPath))
    {
      this->Guard.Call();
    }
  }
  return status;
}

void LibusbFalconLink::Close() noexcept
{
  const bool wasOpen = this->Traffic != nullptr;
  const bool mayPush = wasOpen && (!this->Traffic->Stop() || this->Traffic->IsGone());
  // Transfers that were not returned in time are safe to release once the handle, and with it the
  // kernel's side of them, is closed.
  this->Handle.reset();
  this->Traffic.reset();
  this->Context.reset();
  if (this->Descriptor >= 0)
  {
    close(this->Descriptor);
    this->Descriptor = -1;
  }
  if (mayPush)
  {
    this->Guard.Call();
  }
  else if (wasOpen)
  {
    this->Guard.Dismiss();
  }
}

std::string LibusbFalconLink::Caution() const
{
  return this->Traffic == nullptr || this->Guard.IsRunning() || this->Source != nullptr
             ? ""
             : "palpate-falcon-guard was not found, so nothing takes the force away if this "
               "program "
               "is killed";
}

Status LibusbFalconLink::Control(FtdiRequest request)
{
  return this->Traffic != nullptr ? this->Traffic->Control(request)
                                  : Status::Failure("The link to the Falcon is closed.");
}

bool LibusbFalconLink::Send(const std::uint8_t* bytes, std::size_t count) noexcept
{
  return this->Traffic != nullptr && this->Traffic->Send(bytes, count);
}

void LibusbFalconLink::ArmStop(const std::uint8_t* bytes, std::size_t count) noexcept
{
  if (this->Traffic != nullptr)
  {
    this->Traffic->ArmStop(bytes, count);
  }
}

bool LibusbFalconLink::SendStop() noexcept
{
  return this->Traffic != nullptr && this->Traffic->SendStop();
}

std::size_t LibusbFalconLink::Receive(std::uint8_t* bytes, std::size_t capacity) noexcept
{
  return this->Traffic != nullptr ? this->Traffic->Receive(bytes, capacity) : 0;
}

bool LibusbFalconLink::ClearToSend() const noexcept
{
  return this->Traffic != nullptr && this->Traffic->ClearToSend();
}

bool LibusbFalconLink::IsGone() const noexcept
{
  return this->Traffic != nullptr && this->Traffic->IsGone();
}
} // namespace palpate
