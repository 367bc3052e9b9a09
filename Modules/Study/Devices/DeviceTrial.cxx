#include "DeviceTrial.h"

#include "ForceField.h"
#include "TouchRecording.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr double MostWallForce = 2.0; // N
constexpr double PartOfForce = 0.5;   // of what the device can push
constexpr double UsualReach = 80.0;   // mm, of a device that does not say

// In front of the person: pushes back towards +z, up to a largest force.
class SoftWall final : public ForceField
{
public:
  SoftWall(double place, double stiffness, double largest)
      : Place(place), Slope(stiffness), Largest(largest)
  {
  }
  Vector3 ForceWorld(const Vector3& originWorld) const noexcept override
  {
    const double depth = std::max(0.0, this->Place - originWorld.z());
    return {0.0, 0.0, std::min(this->Largest, this->Slope * depth)};
  }
  Eigen::AlignedBox3d BoundsWorld() const noexcept override
  {
    constexpr double Far = 1e6; // mm
    return {Vector3(-Far, -Far, -Far), Vector3(Far, Far, this->Place)};
  }
  double Stiffness() const noexcept override { return this->Slope; }

private:
  double Place;   // mm
  double Slope;   // N/mm
  double Largest; // N
};

double SizeOf(const DeviceCapabilities& device, int axis)
{
  return device.Workspace.isEmpty() ? UsualReach : device.Workspace.sizes()[axis];
}
} // namespace

DeviceTrial::DeviceTrial(Clock& clock, std::filesystem::path folder, const RealtimeRequest& request)
    : Time(clock), File(std::move(folder) / "first-use.touch"), Session(clock, request)
{
}

Status DeviceTrial::Start(std::unique_ptr<HapticDevice> opened, int clutchButton)
{
  this->At = Step::Move;
  this->Visited.setEmpty();
  this->MovedParts = {};
  this->FirstPose.reset();
  this->TurnedPart = 0.0;
  this->FeltTicks = 0;
  this->TicksSince = 0;
  this->BeginsAgain = false;
  this->Stopped.reset();
  this->Proved.reset();
  this->Failure.clear();
  const ServoSettings settings;
  this->Rate = settings.Rate;
  this->Session.SetClutchButton(clutchButton);
  this->Session.Open(std::move(opened), settings);
  Status status = this->Session.Start(this->Scene(), {});
  if (!status.IsOk())
  {
    this->End();
  }
  return status;
}

Vector3 DeviceTrial::Middle() const
{
  const Eigen::AlignedBox3d& workspace = this->Capabilities().Workspace;
  return workspace.isEmpty() ? Vector3(Vector3::Zero()) : Vector3(workspace.center());
}

double DeviceTrial::Wall() const
{
  constexpr double Before = 0.1; // of the reach, beyond the middle
  return this->Middle().z() - Before * SizeOf(this->Capabilities(), 2);
}

double DeviceTrial::MostForce() const
{
  return std::min(MostWallForce, PartOfForce * this->Capabilities().MaximumForce);
}

TouchScene DeviceTrial::Scene() const
{
  constexpr double Softest = 0.3; // N/mm
  constexpr double PartOfStable = 0.5;
  TouchScene scene;
  if (this->At != Step::Move)
  {
    const double stable = this->Capabilities().MaximumStiffness;
    const double stiffness = stable > 0.0 ? std::min(Softest, PartOfStable * stable) : Softest;
    scene.Fields.push_back(
        std::make_shared<const SoftWall>(this->Wall(), stiffness, this->MostForce()));
  }
  return scene;
}

Status DeviceTrial::GoTo(Step step)
{
  this->At = step;
  this->Last = {};
  this->BeginsAgain = false;
  this->TicksSince = 0;
  this->Stopped.reset();
  this->Proved.reset();
  this->Failure.clear();
  if (this->Session.IsRecording())
  {
    static_cast<void>(this->Session.StopRecording());
  }
  Status status = this->Session.Publish(this->Scene(), {}, SceneEntry::FadeIn);
  if (status.IsOk() && step == Step::Stop)
  {
    // The servo begins again for it, so that the recording has its first tick.
    status = this->Session.StartRecording(this->File);
  }
  return status;
}

void DeviceTrial::Take(const TouchState& tick)
{
  constexpr double LongestWay = 30.0; // mm
  constexpr double PartOfReach = 0.25;
  constexpr double Turn = 0.35; // rad, 20 degrees
  if (tick.State != DeviceState::Ready || !tick.HasSample || !tick.Sample.IsPose())
  {
    return;
  }
  if (this->At == Step::Move)
  {
    this->Visited.extend(Vector3(tick.Sample.Position));
    for (int axis = 0; axis < 3; ++axis)
    {
      const double way = std::min(LongestWay, PartOfReach * SizeOf(this->Capabilities(), axis));
      this->MovedParts[static_cast<std::size_t>(axis)] =
          std::min(1.0, this->Visited.sizes()[axis] / way);
    }
    const Eigen::Quaterniond pose(Eigen::Vector4d(tick.Sample.Orientation.data()));
    this->FirstPose = this->FirstPose.value_or(pose);
    this->TurnedPart =
        std::max(this->TurnedPart, std::min(1.0, this->FirstPose->angularDistance(pose) / Turn));
  }
  const bool isFelt = Vector3(tick.ForceDevice).norm() >= StopProof::LeastForce;
  this->FeltTicks += this->At == Step::Feel && isFelt ? 1 : 0;
}

const TouchSessionReading& DeviceTrial::Poll()
{
  constexpr int Enough = 50; // ticks after the stop
  const TouchSessionReading& reading = this->Session.Poll();
  this->Last = reading.Newest;
  for (const TouchState& tick : reading.NewTicks)
  {
    this->Take(tick);
    const bool isOff = tick.Safety.Fault != SafetyFault::None || tick.IsClutched;
    this->TicksSince = isOff ? this->TicksSince + 1 : 0;
  }
  if (this->BeginsAgain && reading.Newest.Safety.Fault == SafetyFault::None)
  {
    this->Failure = this->GoTo(Step::Stop).Message();
  }
  if (this->At == Step::Stop && this->Session.IsRecording() && this->TicksSince >= Enough)
  {
    this->Prove();
  }
  return reading;
}

bool DeviceTrial::HasMoved() const
{
  return std::all_of(this->MovedParts.begin(), this->MovedParts.end(),
                     [](double part) { return part >= 1.0; });
}

double DeviceTrial::Felt() const
{
  constexpr double Seconds = 0.5;
  return std::min(1.0, this->FeltTicks / (Seconds * this->Rate));
}

void DeviceTrial::StopForce()
{
  if (!this->IsRunning())
  {
    return;
  }
  if (this->At == Step::Stop && !this->Stopped)
  {
    this->Stopped = this->Time.Now();
  }
  this->Session.Loop().SwitchOff();
}

// From the file, as anybody may read it.
void DeviceTrial::Prove()
{
  TouchRecording recording;
  Status status = this->Session.StopRecording();
  if (status.IsOk())
  {
    status = ReadTouchRecording(this->File.string(), recording);
  }
  this->Failure = status.Message();
  if (!status.IsOk())
  {
    return;
  }
  // A stop by the device's own button, or by a fault, has no other time than the tick's.
  const std::optional<std::int64_t> stopped =
      this->Stopped ? this->Stopped : StopProof::FindStop(recording.Ticks);
  this->TickCount = recording.Ticks.size();
  this->Proved = stopped ? StopProof::Of(recording.Ticks, *stopped) : StopProof();
}

// A test begins again once force is on: a servo that begins while it is off stays off.
void DeviceTrial::AllowForce()
{
  if (this->IsRunning())
  {
    this->Session.Loop().Rearm();
    this->BeginsAgain = this->At == Step::Stop;
  }
}
} // namespace palpate
