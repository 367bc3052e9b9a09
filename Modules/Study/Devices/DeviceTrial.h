#pragma once

#include "PalpateStudyModule.h"
#include "StopProof.h"
#include "TouchSession.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace palpate
{
/// The first use of a device, step by step, without a scene: it is moved, it feels a soft wall, and
/// its stop is tested by a recording. Owner thread only.
class PALPATESTUDY_EXPORT DeviceTrial
{
public:
  enum class Step
  {
    Move, ///< without force
    Feel, ///< a wall in front
    Stop, ///< the same, recorded
  };

  /// Keeps the address of the clock. The recording is written to `folder`.
  DeviceTrial(Clock& clock, std::filesystem::path folder, const RealtimeRequest& request = {});

  /// Begins with Move. The device must be open.
  Status Start(std::unique_ptr<HapticDevice> opened, int clutchButton);
  bool IsRunning() const { return this->Session.IsRunning(); }
  void End() { this->Session.Stop(); }

  Step Now() const { return this->At; }
  /// Fails if the scene or the recording cannot be begun.
  Status GoTo(Step step);
  /// Call at least ten times a second.
  const TouchSessionReading& Poll();
  /// Of the last poll in this step.
  const TouchState& Newest() const { return this->Last; }
  const HapticDevice& Device() const { return this->Session.Device(); }
  const DeviceCapabilities& Capabilities() const { return this->Session.Device().Capabilities(); }

  /// Of the way that each axis has to be moved, from 0 to 1.
  const std::array<double, 3>& Moved() const { return this->MovedParts; }
  bool Turns() const { return this->Capabilities().DegreesOfFreedom > 3; }
  double Turned() const { return this->TurnedPart; } ///< likewise
  bool HasMoved() const;
  /// Of the time that the wall has to be felt, from 0 to 1.
  double Felt() const;
  /// Place of the wall (mm, device's z): behind it, away from the person, a force acts.
  double Wall() const;
  /// Of the strongest force of the wall, N.
  double MostForce() const;

  /// All force ends, and stays off; in the step Stop a force that acts is proved to have ended.
  void StopForce();
  /// A person allows force again; a test that proved nothing is begun again.
  void AllowForce();
  /// The result of the test; none before it was made.
  const std::optional<StopProof>& Proof() const { return this->Proved; }
  /// Ticks of the recording that it is from.
  std::size_t RecordedTicks() const { return this->TickCount; }
  /// Why a recording could not be made or read; may be empty.
  const std::string& Problem() const { return this->Failure; }

  /// See HapticDevice::LeadHand; mm of the device.
  bool LeadHand(const Vector3& target) { return this->Session.LeadHand(target); }

private:
  TouchScene Scene() const;
  void Take(const TouchState& tick);
  void Prove();
  Vector3 Middle() const;

  Clock& Time;
  std::filesystem::path File;
  TouchSession Session;
  Step At = Step::Move;
  Eigen::AlignedBox3d Visited;
  std::array<double, 3> MovedParts{};
  std::optional<Eigen::Quaterniond> FirstPose;
  double TurnedPart = 0.0;
  TouchState Last;
  int FeltTicks = 0;
  double Rate = 0.0;                   ///< Hz
  std::optional<std::int64_t> Stopped; ///< ns, when the stop under test was asked for
  int TicksSince = 0;                  ///< force went off
  bool BeginsAgain = false;            ///< the test, once force is on
  std::optional<StopProof> Proved;
  std::size_t TickCount = 0;
  std::string Failure;
};
} // namespace palpate
