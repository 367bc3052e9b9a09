#include "Inverse3Device.h"

#include "ClampedLength.h"
#include "DecimalText.h"

#include <utility>

namespace palpate
{
namespace
{
constexpr double Reach = 100.0;     // mm, of an Inverse3 about its middle (its maker's tutorial 06)
constexpr double SmallReach = 40.0; // mm, of a Minverse
constexpr double MostForceShown = 5.0; // N; below what the device displays for a short time

Eigen::AlignedBox3d Cube(double reach)
{
  return {Vector3::Constant(-reach), Vector3::Constant(reach)};
}
} // namespace

Inverse3Device::Inverse3Device(Clock& clock, Inverse3Address address)
    : Time(clock), Address(std::move(address))
{
  this->Abilities.Name = "Haply Inverse3";
  this->Abilities.DegreesOfFreedom = 6;
  this->Abilities.Buttons = 3; // of its grip
  this->Abilities.Workspace = Cube(Reach);
  this->Abilities.MaximumForce = MostForceShown;
  this->Abilities.Rate = 1000.0;
  // A state comes with each command: one that is late on a busy machine is no fault yet.
  this->Abilities.LongestGap = 0.005;
}

std::string Inverse3Device::Problem() const
{
  return this->State() == DeviceState::Error ? this->Shared.Problem() + "." : "";
}

std::string Inverse3Device::Guidance() const
{
  return this->State() == DeviceState::Homing
             ? "Hold the grip in the middle of its reach until the device answers."
             : "";
}

std::string Inverse3Device::ConnectionReport() const
{
  const std::uint64_t replies = this->Shared.Replies.load();
  if (replies == 0)
  {
    return "";
  }
  const double mean =
      1e-3 * static_cast<double>(this->Shared.SumOfReplies.load()) / static_cast<double>(replies);
  return std::to_string(replies) + " states, " + FixedText(mean, 0) +
         " µs after their command (mean), longest " +
         FixedText(1e-6 * static_cast<double>(this->Shared.LongestReply.load()), 1) +
         " ms; the device displayed forces within " +
         FixedText(this->Shared.LargestDifference.load(), 1) + " N of those sent.";
}

Status Inverse3Device::Open()
{
  if (this->State() != DeviceState::Closed)
  {
    return Status::Failure("The Inverse3 is open already.");
  }
  this->Shared.SetProblem("");
  this->Shared.Replies = 0;
  this->Shared.SumOfReplies = 0;
  this->Shared.LongestReply = 0;
  this->Shared.LargestDifference = 0.0;
  this->Shared.IsBehind = false;
  DeviceSample none;
  none.Time = this->Time.Now();
  this->Shared.Newest.Publish(none);
  this->Shared.Life = DeviceState::Homing;
  auto client = std::make_unique<Inverse3Client>(this->Time, this->Address, this->Shared);
  const Status status = client->Start();
  if (!status.IsOk())
  {
    this->Shared.Life = DeviceState::Closed;
    return status;
  }
  this->Abilities.Workspace = Cube(client->IsSmall() ? SmallReach : Reach);
  this->Client = std::move(client);
  return status;
}

void Inverse3Device::Close() noexcept
{
  if (this->Client != nullptr)
  {
    this->Client->Stop();
    this->Client.reset();
  }
  this->Shared.Life = DeviceState::Closed;
}

bool Inverse3Device::Read(DeviceSample& sample) noexcept
{
  const DeviceState state = this->State();
  if (state != DeviceState::Homing && state != DeviceState::Ready)
  {
    return false;
  }
  sample = this->Shared.Newest.Latest();
  if (state == DeviceState::Homing)
  {
    sample.Time = this->Time.Now(); // nothing is measured yet, and no silence to be noticed
  }
  return true;
}

// While the service is behind, only 0 N is passed on.
bool Inverse3Device::Apply(const Vector3& force) noexcept
{
  const DeviceState state = this->State();
  if (state != DeviceState::Homing && state != DeviceState::Ready)
  {
    return false;
  }
  const bool isForce = state == DeviceState::Ready && !this->Shared.IsBehind;
  const Vector3 clamped = isForce ? ClampedLength(force, MostForceShown) : Vector3::Zero();
  this->Shared.Wanted.Publish({clamped, ++this->Commands, this->Time.Now()});
  this->Client->Wake();
  return isForce || force.isZero(0.0);
}

Status RegisterInverse3Devices(DeviceRegistry& registry)
{
  return registry.Add(
      "inverse3", "a Haply Inverse3, 3x or Minverse, by its maker's service; inverse3[:ID]",
      [](Clock& clock, const std::string& argument, std::unique_ptr<HapticDevice>& device)
      {
        Inverse3Address address;
        const Status status = Inverse3Address::Parse(argument, address);
        if (status.IsOk())
        {
          device = std::make_unique<Inverse3Device>(clock, address);
        }
        return status;
      },
      // Asking the service opens a session, which displays 0 N; it ends at once.
      [](Clock& clock, std::vector<FoundDevice>& found)
      {
        Inverse3Device device(clock, {});
        const Status status = device.Open();
        if (status.IsOk())
        {
          found.push_back({"", true, "the service answers"});
        }
        return status;
      },
      DeviceRegistry::Proof::UntriedOnHardware);
}
} // namespace palpate
