#pragma once

#include "SimulatedHand.h"
#include "Vector3.h"

#include <array>
#include <cstdint>
#include <functional>

namespace palpate::test
{
/// The mechanism of a virtual Falcon, mm, N, s, rad. Published lengths; what was never published is
/// plausible.
struct VirtualMechanismSettings
{
  double Thigh = 60.0;
  double Shin = 102.5;
  double PlatformRadial = 14.43;
  double PlatformTangential = -25.0;
  double Offsets = 22.5; ///< of the shin at both its ends together
  double BaseRadial = 40.0;
  double BaseTangential = -23.09;
  double HomeAngle = 35.0 * M_PI / 180.0; ///< of a leg at count 0
  double AnglePerCount = 2.0 * M_PI * 14.25 / (1280.0 * 110.0);
  double CountsPerNewtonMillimeter = 6.616; ///< motor values

  /// What the counters read too much after power-up.
  std::array<int, 3> CounterErrors{1234, -777, 4321};
  /// At these counts a leg passes its encoder's index.
  int IndexCount = 700;

  HandProperties Hand;
  Vector3 Start{0.0, 0.0, 125.0};
  /// Where the hand wants to be (mm, from the base's middle) at a time (s). Without one it holds
  /// Start.
  std::function<Vector3(double)> Path;
  /// The hand is where it wants to be, whatever pushes it.
  bool IsRigid = false;
  unsigned Buttons = 0; ///< that the hand presses, a bit each
};

/// Three legs, a grip and the hand on it, in virtual time. The legs are solved as the surfaces
/// that each lets the grip move on, which is another way than the driver's: g(p, angle) = 0, and
/// what follows from g's derivatives.
class VirtualMechanism
{
public:
  explicit VirtualMechanism(const VirtualMechanismSettings& settings);

  /// Moves hand and grip up to a time (ns), with the motors as they are set.
  void AdvanceTo(std::int64_t now);
  /// Motor values as the board was told; a positive one pulls the grip in.
  void SetMotors(const std::array<std::int16_t, 3>& motors) { this->Motors = motors; }

  const Vector3& Position() const { return this->Hand.Position(); } ///< mm, of the grip
  Vector3 MotorForce() const; ///< N, of the motors at the grip, where it is now
  /// Of the legs; NaN where the grip is out of their reach.
  std::array<double, 3> Angles() const { return this->AnglesAt(this->Position()); }
  std::array<double, 3> AnglesAt(const Vector3& position) const;
  /// Counts if the encoders were homed.
  std::array<int, 3> TrueCounts() const;
  /// What the counters read.
  std::array<std::int16_t, 3> Counters() const;
  /// A bit each for encoders that have passed their index while homing.
  unsigned HomedBits() const { return this->Homed; }
  /// Homing goes on in the steps that follow.
  void SetHoming(bool on) { this->IsHoming = on; }
  /// Counters start anew, as after power-up.
  void ForgetHome();

  VirtualMechanismSettings Settings; ///< may be changed between calls

private:
  // Derivatives of g by the position and by the angle.
  struct Gradient
  {
    Vector3 ByPosition;
    double ByAngle;
  };
  Gradient GradientOf(int leg, const Vector3& position, double angle) const;
  Vector3 InLeg(int leg, const Vector3& position) const;
  Vector3 TargetAt(std::int64_t time) const;
  void PassIndices();

  SimulatedHand Hand;
  std::int64_t Reached = -1;
  std::array<std::int16_t, 3> Motors{};
  std::array<int, 3> Errors{};
  std::array<int, 3> LastCounts{};
  unsigned Homed = 0;
  bool IsHoming = false;
};
} // namespace palpate::test
