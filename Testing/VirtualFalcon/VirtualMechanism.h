#pragma once

#include "SimulatedHand.h"
#include "Vector3.h"

#include <array>
#include <cstdint>
#include <functional>

namespace palpate::test
{
/// The mechanism of a virtual Falcon, mm, N, s, rad. Published lengths; unpublished values are
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

  /// Offset of the counters after power-up.
  std::array<int, 3> CounterErrors{1234, -777, 4321};
  /// At these counts a leg passes its encoder's index.
  int IndexCount = 700;

  HandProperties Hand;
  Vector3 Start{0.0, 0.0, 125.0};
  /// The hand's target (mm, from the base's centre) at a time (s). Without one it stays at Start.
  std::function<Vector3(double)> Path;
  /// The hand is at its target, whatever pushes it.
  bool IsRigid = false;
  unsigned Buttons = 0; ///< pressed by the hand, one bit each
};

/// Three legs, a grip and the hand on it, in virtual time. The legs are solved as the surfaces
/// on which each lets the grip move, a different method from the driver's: g(p, angle) = 0, and the
/// derivatives of g.
class VirtualMechanism
{
public:
  explicit VirtualMechanism(const VirtualMechanismSettings& settings);

  /// Moves hand and grip up to a time (ns), with the current motor values.
  void AdvanceTo(std::int64_t now);
  /// Motor values received by the board; a positive one pulls the grip in.
  void SetMotors(const std::array<std::int16_t, 3>& motors) { this->Motors = motors; }

  const Vector3& Position() const { return this->Hand.Position(); } ///< mm, of the grip
  Vector3 MotorForce() const; ///< N, of the motors at the grip, at its current position
  /// Angles of the legs; NaN where the grip is out of their reach.
  std::array<double, 3> Angles() const { return this->AnglesAt(this->Position()); }
  std::array<double, 3> AnglesAt(const Vector3& position) const;
  /// Counts if the encoders were homed.
  std::array<int, 3> TrueCounts() const;
  /// Readings of the counters.
  std::array<std::int16_t, 3> Counters() const;
  /// One bit for each encoder that has passed its index while homing.
  unsigned HomedBits() const { return this->Homed; }
  /// Homing happens in the following steps.
  void SetHoming(bool on) { this->IsHoming = on; }
  /// Counters restart, as after power-up.
  void ForgetHome();

  VirtualMechanismSettings Settings; ///< may be changed between calls

private:
  // Derivatives of g by position and angle.
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
