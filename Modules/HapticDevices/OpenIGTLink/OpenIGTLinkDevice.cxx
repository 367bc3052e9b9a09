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
constexpr int CloseMilliseconds = 50; // for 0 N to leave

constexpr const char* Ended =
    "The OpenIGTLink peer has closed the connection: start it, then open the device again.";
constexpr const char* NotUnderstood =
    "The peer sends something that is not OpenIGTLink: check its address and port.";
} // namespace

OpenIGTLinkDevice::OpenIGTLinkDevice(Clock& clock, IgtlPeer peer)
    : Time(clock), From(std::move(peer))
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
  return refused == 0 ? "" : std::to_string(refused) + " damaged poses were not used.";
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
    // What is left of a message must end before the next one.
    this->SendRest();
    this->Add(IgtlForceMessage("Force", Vector3::Zero()));
    for (int tries = 0; tries < CloseMilliseconds && this->SendRest() && !this->Rest.empty();
         ++tries)
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

// Only when all of the former messages has been taken, so that nothing old is sent.
bool OpenIGTLinkDevice::SendNews()
{
  if (this->Rest.empty())
  {
    this->AddForce();
    this->AddShown();
  }
  if (!this->SendRest())
  {
    this->EndIn(Ended);
    return false;
  }
  return true;
}

void OpenIGTLinkDevice::AddForce()
{
  const Command& command = this->Wanted.Latest();
  const bool isNew = command.Number != this->SentNumber;
  const bool isOld = this->Time.Now() - command.Time > ForceLasts;
  if (isNew || (isOld && !this->IsAtRest))
  {
    const PlainVector3 force = isOld ? PlainVector3() : command.Force;
    this->SentNumber = command.Number;
    this->IsAtRest = Vector3(force).isZero(0.0);
    this->Add(IgtlForceMessage("Force", force));
  }
}

void OpenIGTLinkDevice::AddShown()
{
  const IgtlTouch& now = this->Displayed.Latest();
  if (now.Tick == this->Told.Tick)
  {
    return;
  }
  this->Add(IgtlTouchMessages(this->Told, now));
  this->Told = now;
}

void OpenIGTLinkDevice::Add(const std::vector<std::uint8_t>& message)
{
  this->Rest.insert(this->Rest.end(), message.begin(), message.end());
}

// Returns false if the connection has ended.
bool OpenIGTLinkDevice::SendRest()
{
  const std::ptrdiff_t sent =
      this->Rest.empty() ? 0 : this->Stream.Send(this->Rest.data(), this->Rest.size());
  if (sent > 0)
  {
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
      });
}
} // namespace palpate
