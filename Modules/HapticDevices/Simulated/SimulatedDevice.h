#pragma once

#include "Clock.h"
#include "DeviceRegistry.h"
#include "HapticDevice.h"
#include "LatestValue.h"
#include "SimulatedHand.h"
#include "SimulatedWrist.h"

#include <array>
#include <atomic>
#include <functional>

namespace palpate
{
/// Faults that can be injected into a simulated device.
enum class SimulatedFault
{
  None,
  NonFinitePosition, ///< positions are NaN
  FrozenSample,      ///< repeats the last sample
  LateSamples,       ///< samples are 20 ms old
  MirroredPosition,  ///< encoders count backwards
  RefusedForce,      ///< forces are not accepted
  Unplugged          ///< no longer answers
};

/// A device of about a Falcon's size with a hand on it. The parameters of mechanism and hand are
/// plausible, not measured on a device.
struct SimulatedSettings
{
  HandProperties Hand;
  HandProperties Wrist = WristProperties();
  double MaximumForce = 8.0;     ///< N; larger ones saturate
  double MaximumTorque = 0.0;    ///< N mm; larger ones saturate. 0: it shows none, and never turns
  double MaximumStiffness = 3.0; ///< N/mm
  double MaximumDamping = 0.02;  ///< N s/mm
  double Resolution = 0.045;     ///< mm, positions are multiples of it; 0 is exact
  double Delay = 0.0;            ///< s until a force takes effect
  double Rate = 1000.0;          ///< Hz
  double WorkspaceRadius = 40.0; ///< mm, around the origin
  double HomingDuration = 0.0;   ///< s
  bool HasMotors = false;        ///< true: the safety chain takes it for a real device
  /// The hand's target (mm) at a time (s) after opening; without one it is what LeadHand said. It
  /// must neither throw nor allocate.
  std::function<Vector3(double)> Path;
  /// How the hand wants to be turned, likewise; without one it wants the identity.
  std::function<Eigen::Quaterniond(double)> TurnPath;
};

/// A simulated device: a hand on a mechanism (SimulatedHand) with quantised encoders, delayed
/// forces, and motors that saturate and switch off after 20 ms without a command; with motors that
/// turn (MaximumTorque), also a wrist (SimulatedWrist), whose encoders are exact. Time is the
/// clock's; the motion is integrated in steps of at most 10 us up to each Read. The result depends
/// only on the clock and the calls, bit for bit.
class SimulatedDevice final : public HapticDevice
{
public:
  /// Keeps the address of the clock, which must outlive it.
  SimulatedDevice(Clock& clock, const SimulatedSettings& settings);

  const DeviceCapabilities& Capabilities() const noexcept override { return this->Abilities; }
  DeviceState State() const noexcept override { return this->Life.load(); }
  std::string Problem() const override;
  Status Open() override;
  void Close() noexcept override;
  bool Read(DeviceSample& sample) noexcept override;
  bool Apply(const Vector3& force) noexcept override
  {
    return this->ApplyWrench(force, Vector3::Zero());
  }
  bool ApplyWrench(const Vector3& force, const Vector3& torque) noexcept override;

  /// Where the hand wants to be (mm), as a mouse would say it; from one thread.
  bool LeadHand(const Vector3& target) noexcept override
  {
    this->Wanted.Publish(target);
    return true;
  }
  /// From any thread; in effect from the next Read or Apply on.
  void Inject(SimulatedFault fault) noexcept { this->Broken.store(fault); }

  /// The hand's exact state and energies; reading thread only.
  const SimulatedHand& Hand() const noexcept { return this->Body; }
  /// The same of its turns.
  const SimulatedWrist& Wrist() const noexcept { return this->Joint; }

private:
  struct Command
  {
    std::int64_t Time = 0; // ns, when it takes effect
    Vector3 Force = Vector3::Zero();
    Vector3 Torque = Vector3::Zero();
  };

  void AdvanceTo(std::int64_t now) noexcept;
  const Command& CommandAt(std::int64_t time) noexcept;
  Vector3 TargetAt(std::int64_t time) noexcept;
  Eigen::Quaterniond TurnTargetAt(std::int64_t time) const;
  bool Turns() const noexcept { return this->Settings.MaximumTorque > 0.0; }
  Vector3 Counted() const noexcept;
  void Measure(std::int64_t now, SimulatedFault fault) noexcept;
  void ForgetCommands() noexcept;

  Clock& Time;
  SimulatedSettings Settings;
  DeviceCapabilities Abilities;
  SimulatedHand Body;
  SimulatedWrist Joint;
  std::atomic<DeviceState> Life{DeviceState::Closed};
  std::atomic<SimulatedFault> Broken{SimulatedFault::None};
  LatestValue<PlainVector3> Wanted;
  Vector3 Target = Vector3::Zero();                               // of the hand at the time reached
  Eigen::Quaterniond TurnTarget = Eigen::Quaterniond::Identity(); // likewise
  std::int64_t Opened = 0;                                        // ns
  std::int64_t Reached = 0;                                       // ns, by the motion
  DeviceSample Last;
  // Delayed commands; more than 64 at once are dropped.
  std::array<Command, 64> Commands;
  std::size_t Oldest = 0;
  std::size_t CommandCount = 0;
  Command InEffect;
};

/// Adds "simulated": a SimulatedDevice with default settings.
Status RegisterSimulatedDevices(DeviceRegistry& registry);
} // namespace palpate
