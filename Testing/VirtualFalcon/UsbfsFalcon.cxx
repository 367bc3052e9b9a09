#include "UsbfsFalcon.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

namespace palpate::test
{
namespace
{
constexpr std::size_t SetupSize = 8;
constexpr std::int64_t ShortestPause = 50'000; // ns, between two polls of the device

std::int64_t Now()
{
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Marks a request as ready to be reaped.
void Finish(UsbfsFile& file, const std::deque<UsbfsRequest>::iterator& waiting, int outcome)
{
  waiting->Outcome = outcome;
  file.Finished.push_back(std::move(*waiting));
  file.Waiting.erase(waiting);
  if (file.Finished.size() == 1)
  {
    file.ShowWork(true);
  }
}

usbdevfs_ctrltransfer SetupOf(const std::uint8_t* bytes)
{
  const auto word = [bytes](std::size_t n)
  { return static_cast<std::uint16_t>(bytes[n] | bytes[n + 1] << 8); };
  usbdevfs_ctrltransfer setup{};
  setup.bRequestType = bytes[0];
  setup.bRequest = bytes[1];
  setup.wValue = word(2);
  setup.wIndex = word(4);
  setup.wLength = word(6);
  return setup;
}
} // namespace

UsbfsFalcon::UsbfsFalcon(VirtualFalcon& falcon, FalconDescriptors descriptors)
    : Falcon(falcon), Texts(std::move(descriptors)), Server([this] { this->Serve(); })
{
}

UsbfsFalcon::~UsbfsFalcon()
{
  {
    const std::lock_guard<std::mutex> lock(this->Access);
    this->IsEnding = true;
  }
  this->Changed.notify_all();
  this->Server.join();
}

UsbfsFile* UsbfsFalcon::OpenFile(std::function<void(bool)> showWork, std::function<void()> showGone)
{
  const std::lock_guard<std::mutex> lock(this->Access);
  if (!this->Falcon.IsPluggedIn())
  {
    return nullptr;
  }
  UsbfsFile& file = this->Files.emplace_back();
  file.ShowWork = std::move(showWork);
  file.ShowGone = std::move(showGone);
  file.ShowWork(false);
  return &file;
}

void UsbfsFalcon::CloseFile(UsbfsFile* file)
{
  const std::lock_guard<std::mutex> lock(this->Access);
  this->Files.remove_if([file](const UsbfsFile& one) { return &one == file; });
}

int UsbfsFalcon::Submit(UsbfsFile& file, usbdevfs_urb& urb, void* address)
{
  const std::lock_guard<std::mutex> lock(this->Access);
  if (file.IsGone)
  {
    return -ENODEV;
  }
  const bool isControl = urb.type == USBDEVFS_URB_TYPE_CONTROL;
  if (!isControl && (urb.type != USBDEVFS_URB_TYPE_BULK || !file.HasClaim))
  {
    return -EINVAL;
  }
  UsbfsRequest request;
  request.Urb = &urb;
  request.Address = address;
  file.Waiting.push_back(std::move(request));
  if (isControl)
  {
    this->FinishControl(file.Waiting.back());
    Finish(file, file.Waiting.end() - 1, file.Waiting.back().Outcome);
  }
  this->Changed.notify_all();
  return 0;
}

int UsbfsFalcon::Reap(UsbfsFile& file, void*& address)
{
  const std::lock_guard<std::mutex> lock(this->Access);
  if (file.Finished.empty())
  {
    return file.IsGone ? -ENODEV : -EAGAIN;
  }
  const UsbfsRequest request = std::move(file.Finished.front());
  file.Finished.pop_front();
  usbdevfs_urb& urb = *request.Urb;
  const std::size_t offset = urb.type == USBDEVFS_URB_TYPE_CONTROL ? SetupSize : 0;
  std::copy(request.Received.begin(), request.Received.end(),
            static_cast<std::uint8_t*>(urb.buffer) + offset);
  urb.status = request.Outcome;
  urb.actual_length = request.Length;
  address = request.Address;
  if (file.Finished.empty())
  {
    file.ShowWork(false);
  }
  return 0;
}

int UsbfsFalcon::Discard(UsbfsFile& file, const void* address)
{
  const std::lock_guard<std::mutex> lock(this->Access);
  const auto found =
      std::find_if(file.Waiting.begin(), file.Waiting.end(),
                   [address](const UsbfsRequest& request) { return request.Address == address; });
  if (found == file.Waiting.end())
  {
    return -EINVAL;
  }
  if (!this->KeepsDiscarded)
  {
    Finish(file, found, -ENOENT);
  }
  return 0;
}

int UsbfsFalcon::Claim(UsbfsFile& file, bool detaches)
{
  const bool isTaken =
      std::any_of(this->Files.begin(), this->Files.end(),
                  [&file](const UsbfsFile& other) { return &other != &file && other.HasClaim; });
  if (isTaken || (!this->Driver.empty() && !detaches))
  {
    return -EBUSY;
  }
  this->Driver.clear();
  file.HasClaim = true;
  return 0;
}

int UsbfsFalcon::Answer(UsbfsFile& file, unsigned long request, void* argument)
{
  const std::lock_guard<std::mutex> lock(this->Access);
  if (file.IsGone)
  {
    return -ENODEV;
  }
  switch (request)
  {
  case USBDEVFS_GET_CAPABILITIES:
    *static_cast<__u32*>(argument) = USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_BULK_CONTINUATION |
                                     USBDEVFS_CAP_NO_PACKET_SIZE_LIM |
                                     USBDEVFS_CAP_BULK_SCATTER_GATHER |
                                     USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
    return 0;
  case USBDEVFS_DISCONNECT_CLAIM:
    return this->Claim(file, true);
  case USBDEVFS_CLAIMINTERFACE:
    return this->Claim(file, false);
  case USBDEVFS_RELEASEINTERFACE:
    file.HasClaim = false;
    return 0;
  case USBDEVFS_GETDRIVER:
    if (this->Driver.empty())
    {
      return -ENODATA;
    }
    std::strncpy(static_cast<usbdevfs_getdriver*>(argument)->driver, this->Driver.c_str(),
                 USBDEVFS_MAXDRIVERNAME);
    return 0;
  case USBDEVFS_CONNECTINFO:
    *static_cast<usbdevfs_connectinfo*>(argument) = {2, 0};
    return 0;
  case USBDEVFS_CONTROL:
  {
    const auto& setup = *static_cast<const usbdevfs_ctrltransfer*>(argument);
    return this->Control(setup, static_cast<std::uint8_t*>(setup.data));
  }
  case USBDEVFS_SETCONFIGURATION:
  case USBDEVFS_SETINTERFACE:
  case USBDEVFS_CLEAR_HALT:
  case USBDEVFS_RESET:
    return 0;
  case USBDEVFS_IOCTL: // to detach or attach a driver
    return -ENODATA;
  default:
    return -ENOTTY;
  }
}

// Returns the number of bytes transferred, or a negative errno.
int UsbfsFalcon::Control(const usbdevfs_ctrltransfer& setup, std::uint8_t* data)
{
  constexpr std::uint8_t VendorOut = 0x40;
  constexpr std::uint8_t VendorIn = 0xc0;
  constexpr std::uint8_t StandardIn = 0x80;
  constexpr std::uint8_t GetDescriptor = 6;
  constexpr std::uint8_t GetConfiguration = 8;
  constexpr int StringDescriptor = 3;
  int answer = VirtualFalcon::Stall;
  if (setup.bRequestType == VendorOut && setup.wLength == 0)
  {
    answer = this->Falcon.ControlOut(setup.bRequest, setup.wValue, setup.wIndex, Now());
  }
  else if (setup.bRequestType == VendorIn)
  {
    answer = this->Falcon.ControlIn(setup.bRequest, setup.wValue, setup.wIndex, data, setup.wLength,
                                    Now());
  }
  else if (setup.bRequestType == StandardIn && setup.bRequest == GetConfiguration &&
           setup.wLength > 0)
  {
    data[0] = 1;
    answer = 1;
  }
  else if (setup.bRequestType == StandardIn && setup.bRequest == GetDescriptor &&
           setup.wValue >> 8 == StringDescriptor)
  {
    std::vector<std::uint8_t> text = this->Texts.String(setup.wValue & 0xff);
    text.resize(std::min<std::size_t>(text.size(), setup.wLength));
    std::copy(text.begin(), text.end(), data);
    answer = text.empty() ? VirtualFalcon::Stall : static_cast<int>(text.size());
  }
  return answer == VirtualFalcon::NoDevice ? -ENODEV : answer < 0 ? -EPIPE : answer;
}

void UsbfsFalcon::FinishControl(UsbfsRequest& request)
{
  const auto* bytes = static_cast<const std::uint8_t*>(request.Urb->buffer);
  const usbdevfs_ctrltransfer setup = SetupOf(bytes);
  request.Received.resize(setup.wLength);
  const int length = this->Control(setup, request.Received.data());
  request.Outcome = std::min(length, 0);
  request.Length = std::max(length, 0);
  const bool isRead = (setup.bRequestType & 0x80U) != 0;
  request.Received.resize(isRead ? static_cast<std::size_t>(request.Length) : 0);
}

// Returns whether the request is finished: by a short packet, or because no other would fit.
bool UsbfsFalcon::Fill(UsbfsRequest& read, std::int64_t now)
{
  const auto capacity = static_cast<std::size_t>(read.Urb->buffer_length);
  std::uint8_t packet[VirtualFalcon::PacketSize];
  if (this->ReadFailures > 0)
  {
    --this->ReadFailures;
    read.Outcome = -EPROTO;
    return true;
  }
  while (read.Received.size() < capacity)
  {
    const std::size_t count = this->Falcon.BulkIn(packet, now);
    if (count == 0)
    {
      return false;
    }
    const bool fits = count <= capacity - read.Received.size();
    read.Received.insert(read.Received.end(), packet,
                         packet + std::min(count, capacity - read.Received.size()));
    read.Length = static_cast<int>(read.Received.size());
    read.Outcome = fits ? 0 : -EOVERFLOW;
    if (count < VirtualFalcon::PacketSize || !fits)
    {
      return true;
    }
  }
  return true;
}

void UsbfsFalcon::TakeReads(UsbfsFile& file, std::int64_t now)
{
  const auto next = [&file]
  {
    return std::find_if(file.Waiting.begin(), file.Waiting.end(),
                        [](const UsbfsRequest& request) { return request.IsRead(); });
  };
  for (auto read = next(); read != file.Waiting.end() && this->Fill(*read, now); read = next())
  {
    Finish(file, read, read->Outcome);
  }
}

void UsbfsFalcon::TakeWrites(UsbfsFile& file, std::int64_t now)
{
  const auto next = [&file]
  {
    return std::find_if(file.Waiting.begin(), file.Waiting.end(),
                        [](const UsbfsRequest& request) { return !request.IsRead(); });
  };
  for (auto write = next(); write != file.Waiting.end(); write = next())
  {
    const auto count = static_cast<std::size_t>(write->Urb->buffer_length);
    if (this->WriteFailures > 0)
    {
      --this->WriteFailures;
      Finish(file, write, -EPROTO);
      continue;
    }
    write->Length = write->Urb->buffer_length;
    this->Falcon.BulkOut(static_cast<const std::uint8_t*>(write->Urb->buffer), count, now);
    Finish(file, write, 0);
  }
}

void UsbfsFalcon::BringUpToDate()
{
  static_cast<void>(this->Falcon.NextDue(Now()));
}

void UsbfsFalcon::Serve(UsbfsFile& file)
{
  if (file.IsGone)
  {
    return;
  }
  if (!this->HoldsWrites)
  {
    this->TakeWrites(file, Now());
  }
  this->TakeReads(file, Now());
  if (!this->Falcon.IsPluggedIn()) // by a scripted fault
  {
    this->TakeAway(file, Unplugging::AbortsReads);
  }
}

void UsbfsFalcon::Serve()
{
  std::unique_lock<std::mutex> lock(this->Access);
  while (!this->IsEnding)
  {
    bool isWaiting = false;
    for (UsbfsFile& file : this->Files)
    {
      this->Serve(file);
      isWaiting = isWaiting || !file.Waiting.empty();
    }
    const std::int64_t due = this->Falcon.NextDue(Now());
    if (!isWaiting || due == VirtualFalcon::Never)
    {
      this->Changed.wait(lock);
      continue;
    }
    const std::int64_t wake = std::max(due, Now() + ShortestPause);
    this->Changed.wait_until(lock,
                             std::chrono::steady_clock::time_point(std::chrono::nanoseconds(wake)));
  }
}

void UsbfsFalcon::TakeAway(UsbfsFile& file, Unplugging how)
{
  file.IsGone = true;
  file.HasClaim = false;
  while (!file.Waiting.empty())
  {
    const bool aborts = how == Unplugging::AbortsReads || !file.Waiting.front().IsRead();
    Finish(file, file.Waiting.begin(), aborts ? -ESHUTDOWN : 0);
  }
  if (how == Unplugging::AbortsReads)
  {
    file.ShowGone();
  }
}

void UsbfsFalcon::Unplug(Unplugging how, VirtualFalcon::Supply supply)
{
  const std::lock_guard<std::mutex> lock(this->Access);
  this->Falcon.Unplug(Now(), supply);
  for (UsbfsFile& file : this->Files)
  {
    this->TakeAway(file, how);
  }
}

void UsbfsFalcon::Plug()
{
  const std::lock_guard<std::mutex> lock(this->Access);
  this->Falcon.Plug(Now());
}

void UsbfsFalcon::HoldWrites(bool hold)
{
  const std::lock_guard<std::mutex> lock(this->Access);
  this->HoldsWrites = hold;
  this->Changed.notify_all();
}

void UsbfsFalcon::FailReads(int count)
{
  const std::lock_guard<std::mutex> lock(this->Access);
  this->ReadFailures = count;
  this->Changed.notify_all();
}

void UsbfsFalcon::FailWrites(int count)
{
  const std::lock_guard<std::mutex> lock(this->Access);
  this->WriteFailures = count;
  this->Changed.notify_all();
}

void UsbfsFalcon::KeepDiscarded(bool keep)
{
  const std::lock_guard<std::mutex> lock(this->Access);
  this->KeepsDiscarded = keep;
}

void UsbfsFalcon::BindDriver(const std::string& name)
{
  const std::lock_guard<std::mutex> lock(this->Access);
  this->Driver = name;
}

void UsbfsFalcon::ReleaseClaims()
{
  const std::lock_guard<std::mutex> lock(this->Access);
  for (UsbfsFile& file : this->Files)
  {
    if (file.HasClaim)
    {
      file.HasClaim = false;
      file.Waiting.clear();
    }
  }
}

std::size_t UsbfsFalcon::WaitingCount()
{
  const std::lock_guard<std::mutex> lock(this->Access);
  std::size_t count = 0;
  for (const UsbfsFile& file : this->Files)
  {
    count += file.Waiting.size();
  }
  return count;
}

std::size_t UsbfsFalcon::WaitingWrites()
{
  const std::lock_guard<std::mutex> lock(this->Access);
  std::size_t count = 0;
  for (const UsbfsFile& file : this->Files)
  {
    count += static_cast<std::size_t>(std::count_if(file.Waiting.begin(), file.Waiting.end(),
                                                    [](const UsbfsRequest& request)
                                                    { return !request.IsRead(); }));
  }
  return count;
}

std::size_t UsbfsFalcon::FileCount()
{
  const std::lock_guard<std::mutex> lock(this->Access);
  return this->Files.size();
}
} // namespace palpate::test
