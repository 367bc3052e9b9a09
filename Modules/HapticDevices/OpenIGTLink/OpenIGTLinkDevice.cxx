#include "OpenIGTLinkDevice.h"

#include "IgtlMessages.h"
#include "IgtlTouchState.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

namespace palpate
{
namespace
{
constexpr int WaitMilliseconds = 1;
constexpr std::int64_t ForceLasts = 20'000'000; // ns without Apply
constexpr double LargestForce = 5.0;            // N, of a device that is not known
constexpr std::size_t BytesAtOnce = 65536;
constexpr std::int64_t LongestUnconfirmed = 30'000'000; // ns; systems confirm within 40 ms unread
constexpr int SendBufferBytes = 4096;
constexpr std::size_t ForceBytes = 92; // a message's
constexpr int CloseMilliseconds = 50;  // for 0 N to leave

constexpr const char* Ended =
    "The OpenIGTLink peer has closed the connection: start it, then open the device again.";
constexpr const char* NotUnderstood =
    "The peer sends something that is not OpenIGTLink: check its address and port.";
} // namespace

OpenIGTLinkDevice::OpenIGTLinkDevice(Clock& clock, IgtlPeer peer)
    : Time(clock), From(std::move(peer)), Stream(SendBufferBytes), Arriving(LongestUnconfirmed),
      Reading(LongestUnconfirmed)
{
  this->Abilities.Name = "OpenIGTLink";
  this->Abilities.DegreesOfFreedom = 6;
  constexpr double Reach = 200.0; // mm, about that of an arm
  this->Abilities.Workspace = {Vector3::Constant(-Reach), Vector3::Constant(Reach)};
  this->Abilities.MaximumForce = LargestForce;
  this->Abilities.Rate = 1000.0;
  this->Abilities.LongestGap = LongestGap;
}

std::string OpenIGTLinkDevice::Problem() const
{
  return this->State() == DeviceState::Error ? this->Failure.load() : "";
}

std::string OpenIGTLinkDevice::Guidance() const
{
  if (this->State() != DeviceState::Homing)
  {
    return "";
  }
  const std::string tool = this->From.Name.empty() ? "poses" : "poses of " + this->From.Name;
  return this->From.Connects()
             ? "Waiting for " + tool + " on port " + std::to_string(this->Stream.Port()) + "."
             : "Waiting for " + tool + " from " + this->From.Host + ".";
}

std::string OpenIGTLinkDevice::ConnectionReport() const
{
  const std::uint64_t refused = this->Refused.load();
  const std::uint64_t notSent = this->NotSent.load();
  std::string report;
  if (refused > 0)
  {
    report = std::to_string(refused) + " damaged poses were not used.";
  }
  if (notSent > 0)
  {
    report += (report.empty() ? "" : " ") + std::to_string(notSent) +
              " forces were not sent, since the peer did not take them in time.";
  }
  return report;
}

Status OpenIGTLinkDevice::Open()
{
  if (this->State() != DeviceState::Closed)
  {
    return Status::Failure("The OpenIGTLink device is open already.");
  }
  const Status status = this->From.Connects()
                            ? this->Stream.Listen(this->From.Port, this->From.Host.empty())
                            : this->Stream.Connect(this->From.Host, this->From.Port);
  if (!status.IsOk())
  {
    return status;
  }
  this->Poses = IgtlPoses(this->From.Name);
  this->Refused = 0;
  this->NotSent = 0;
  this->IsBehind = false;
  this->Arriving = this->Reading = IgtlProgress(LongestUnconfirmed);
  this->ForcesSent = 0;
  this->Rest.clear();
  this->IsAtRest = true;
  this->MustEnd = false;
  this->SentNumber = this->Commands;
  this->Told = this->Displayed.Latest();
  this->Last.Time = this->Time.Now();
  this->Newest.Publish(this->Last);
  this->Life = DeviceState::Homing;
  this->Thread = std::thread([this] { this->Run(); });
  return Status::Success();
}

void OpenIGTLinkDevice::Close() noexcept
{
  this->MustEnd = true;
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
  this->Stream.Close();
  this->Life = DeviceState::Closed;
}

bool OpenIGTLinkDevice::Read(DeviceSample& sample) noexcept
{
  const DeviceState state = this->State();
  if (state != DeviceState::Homing && state != DeviceState::Ready)
  {
    return false;
  }
  sample = this->Newest.Latest();
  if (state == DeviceState::Homing)
  {
    // There is nothing to measure yet, and no silence to be noticed.
    sample.Time = this->Time.Now();
  }
  return true;
}

bool OpenIGTLinkDevice::Apply(const Vector3& force) noexcept
{
  const DeviceState state = this->State();
  if (state != DeviceState::Homing && state != DeviceState::Ready)
  {
    return false;
  }
  if (this->IsBehind)
  {
    ++this->NotSent;
    return false;
  }
  const double length = force.norm();
  const bool isForce = state == DeviceState::Ready && length > 0.0; // not NaN
  const double part = isForce ? std::min(1.0, LargestForce / length) : 0.0;
  const Vector3 clamped = isForce ? Vector3(part * force) : Vector3::Zero();
  this->Wanted.Publish({clamped, ++this->Commands, this->Time.Now()});
  return true;
}

void OpenIGTLinkDevice::Show(const TouchState& state) noexcept
{
  if (const std::optional<IgtlTouch> shown = IgtlTouchOf(state))
  {
    this->Displayed.Publish(*shown);
  }
}

void OpenIGTLinkDevice::Run()
{
  bool goesOn = true;
  while (goesOn && !this->MustEnd)
  {
    this->Stream.Wait(WaitMilliseconds);
    goesOn = !this->Stream.HasPeer() || (this->TakePoses() && this->SendNews());
  }
  if (this->Stream.HasPeer() && !this->IsAtRest)
  {
    this->SendLastZero();
  }
}

// What is left of a message must end before the next one.
void OpenIGTLinkDevice::SendLastZero()
{
  const std::vector<std::uint8_t> zero = IgtlForceMessage("Force", Vector3::Zero());
  std::ptrdiff_t sent = 0;
  for (int tries = 0; tries < CloseMilliseconds && sent == 0; ++tries)
  {
    const bool isOpen = this->SendRest();
    sent = !isOpen ? -1 : this->Rest.empty() ? this->SendNow(zero) : 0;
    if (sent == 0 || !this->Rest.empty())
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
}

bool OpenIGTLinkDevice::TakePoses()
{
  std::array<std::uint8_t, BytesAtOnce> bytes;
  std::ptrdiff_t count = 0;
  while ((count = this->Stream.Receive(bytes.data(), bytes.size())) > 0)
  {
    if (!this->Poses.Take(bytes.data(), static_cast<std::size_t>(count)))
    {
      this->EndIn(NotUnderstood);
      return false;
    }
    if (static_cast<std::size_t>(count) < bytes.size())
    {
      break;
    }
  }
  this->Refused = this->Poses.Refused();
  if (const IgtlPose* pose = this->Poses.Newest())
  {
    this->Last.Position = pose->Position;
    this->Last.Orientation = pose->Orientation;
    this->Last.Time = this->Time.Now();
    ++this->Last.Sequence;
    this->Newest.Publish(this->Last);
    DeviceState homing = DeviceState::Homing;
    this->Life.compare_exchange_strong(homing, DeviceState::Ready);
  }
  if (count < 0)
  {
    this->EndIn(Ended);
  }
  return count >= 0;
}

// Returns false if the connection has ended.
bool OpenIGTLinkDevice::SendNews()
{
  this->WatchPeer();
  const bool isOpen = this->SendRest() && this->SendForce() && this->SendShown();
  if (!isOpen)
  {
    this->EndIn(Ended);
  }
  return isOpen;
}

void OpenIGTLinkDevice::WatchPeer()
{
  const std::int64_t now = this->Time.Now();
  this->Arriving.Update(this->Stream.Unconfirmed(), now);
  this->Reading.Update(this->Unread(), now);
  this->IsBehind = this->Arriving.IsBehind() || this->Reading.IsBehind();
}

// Forces that the peer has not confirmed; 0 for one that confirms none.
std::uint64_t OpenIGTLinkDevice::Unread() const noexcept
{
  const std::uint64_t read = this->Poses.ForcesRead();
  return read == 0 || read > this->ForcesSent ? 0 : this->ForcesSent - read;
}

// While the peer is behind, two forces: its system confirms a second one at once if its program
// reads.
bool OpenIGTLinkDevice::HasRoom(std::size_t bytes) const noexcept
{
  const std::size_t unconfirmed = this->Stream.Unconfirmed();
  const std::size_t most = this->IsBehind ? 2 : MostOnTheirWay;
  return this->Rest.empty() && this->Unread() < most &&
         (unconfirmed == 0 || unconfirmed + bytes <= most * ForceBytes);
}

// Nothing if the peer need not be told.
std::optional<PlainVector3> OpenIGTLinkDevice::NextForce()
{
  const Command& command = this->Wanted.Latest();
  const bool isNew = command.Number != this->SentNumber;
  const bool isOld = this->Time.Now() - command.Time > ForceLasts;
  this->SentNumber = command.Number;
  if (this->IsBehind || isOld)
  {
    return this->IsBehind || isNew || !this->IsAtRest ? std::optional<PlainVector3>(PlainVector3())
                                                      : std::nullopt;
  }
  return isNew ? std::optional<PlainVector3>(command.Force) : std::nullopt;
}

bool OpenIGTLinkDevice::SendForce()
{
  if (!this->HasRoom(ForceBytes))
  {
    return true;
  }
  const std::optional<PlainVector3> force = this->NextForce();
  const std::ptrdiff_t sent = force ? this->SendNow(IgtlForceMessage("Force", *force)) : 0;
  if (sent > 0)
  {
    ++this->ForcesSent;
    this->Reading.Sent(1, this->Time.Now());
    this->IsAtRest = Vector3(*force).isZero(0.0);
  }
  return sent >= 0;
}

bool OpenIGTLinkDevice::SendShown()
{
  const IgtlTouch& now = this->Displayed.Latest();
  if (now.Tick == this->Told.Tick || this->IsBehind)
  {
    return true;
  }
  const std::vector<std::uint8_t> messages = IgtlTouchMessages(this->Told, now);
  const std::ptrdiff_t sent = this->HasRoom(messages.size()) ? this->SendNow(messages) : 0;
  if (sent > 0)
  {
    this->Told = now;
  }
  return sent >= 0;
}

// A message that the connection takes no byte of is not kept: the next one is newer.
std::ptrdiff_t OpenIGTLinkDevice::SendNow(const std::vector<std::uint8_t>& message)
{
  const std::ptrdiff_t sent = this->Stream.Send(message.data(), message.size());
  if (sent > 0)
  {
    this->Arriving.Sent(static_cast<std::uint64_t>(sent), this->Time.Now());
    this->Rest.assign(message.begin() + sent, message.end());
  }
  return sent;
}

// Returns false if the connection has ended.
bool OpenIGTLinkDevice::SendRest()
{
  const std::ptrdiff_t sent =
      this->Rest.empty() ? 0 : this->Stream.Send(this->Rest.data(), this->Rest.size());
  if (sent > 0)
  {
    this->Arriving.Sent(static_cast<std::uint64_t>(sent), this->Time.Now());
    this->Rest.erase(this->Rest.begin(), this->Rest.begin() + sent);
  }
  return sent >= 0;
}

void OpenIGTLinkDevice::EndIn(const char* problem) noexcept
{
  this->Failure = problem;
  this->Life = DeviceState::Error;
}

Status RegisterOpenIGTLinkDevices(DeviceRegistry& registry)
{
  return registry.Add(
      "openigtlink",
      "a tool tracked over the network; openigtlink:[HOST:]PORT[/NAME], without HOST it connects "
      "from this machine, with * from any",
      [](Clock& clock, const std::string& argument, std::unique_ptr<HapticDevice>& device)
      {
        IgtlPeer peer;
        Status status = ParseIgtlPeer(argument, peer);
        if (status.IsOk())
        {
          device = std::make_unique<OpenIGTLinkDevice>(clock, peer);
        }
        return status;
      },
      // Listing devices must not open a port, and none is taken unasked.
      [](Clock&, std::vector<FoundDevice>&)
      {
        return Status::Failure("A peer is met when the device is opened: name it, such as "
                               "openigtlink:18944.");
      },
      DeviceRegistry::Proof::UntriedOnHardware);
}
} // namespace palpate
