#pragma once

#include "SurfaceFriction.h"
#include "Vector3.h"

#include <array>
#include <cstddef>

namespace palpate
{
/// A small motion of a stiff body: of its origin (mm), and a rotation vector (rad) about it.
struct Twist
{
  Vector3 Shift = Vector3::Zero();
  Vector3 Turn = Vector3::Zero();
};

/// Where a stiff body may not go further: a point of it stays on the outer side of a plane.
struct PoseConstraint
{
  Vector3 Arm = Vector3::Zero();     ///< from the body's origin to the point, mm
  Vector3 Normal = Vector3::UnitZ(); ///< unit, outwards
  double Gap = 0.0;                  ///< mm from the point to the plane, negative inside
  SurfaceFriction Friction = {};
  std::size_t Source = 0;         ///< the owner's own number of it, below SourcesOfOwner
  std::size_t Owner = 0;          ///< set by PoseConstraints::Add
  double Push = 0.0;              ///< mm: its multiplier, kept as the next solution's start
  Vector3 Drag = Vector3::Zero(); ///< mm, along the plane: the multiplier of friction
  bool IsSlipping = false;        ///< the dynamic coefficient holds until it comes to rest
  bool Cuts = true;               ///< of the body's part there, where it drills

  /// By how much it moves the body's origin, mm.
  Vector3 Shift() const noexcept { return this->Push * this->Normal + this->Drag; }
};

/// At most so many at a time; the nearest ones, if there are more.
class PoseConstraints
{
public:
  static constexpr std::size_t Most = 32;

  void Clear() noexcept
  {
    this->Count = 0;
    this->IsHeld = false;
  }
  /// What is near a part of the body is not known yet: the body must stay until the next tick.
  void Hold() noexcept { this->IsHeld = true; }
  bool Holds() const noexcept { return this->IsHeld; }
  /// Of what is added from now on; its sources are told apart from those of others.
  void SetOwner(std::size_t owner) noexcept { this->Owner = owner; }
  static constexpr std::size_t SourcesOfOwner = std::size_t{1} << 20;
  void Add(const PoseConstraint& constraint) noexcept;
  /// Starts from the multipliers of another solution, where the sources are the same.
  void StartFrom(const PoseConstraints& solved) noexcept;
  /// For a motion that is only kept out.
  void ForgetPushes() noexcept;
  std::size_t Size() const noexcept { return this->Count; }
  const PoseConstraint& operator[](std::size_t n) const noexcept { return this->All[n]; }
  const PoseConstraint* begin() const noexcept { return this->All.data(); }
  const PoseConstraint* end() const noexcept { return this->All.data() + this->Count; }

  /// The twist nearest to `wanted`, in |shift|^2 + length^2 |turn|^2, that no constraint forbids:
  /// n . (shift + turn x arm) + gap >= 0. Projected Gauss-Seidel on the multipliers (Ortega, Redon
  /// and Coquillart, "A six degree-of-freedom god-object method", IEEE TVCG 13, 2007, in its
  /// quasi-static form), from those that the constraints bring; as soon as few constraints hold the
  /// body, by their linear equations. Coulomb's friction holds the points
  /// in place, up to the static coefficient times the push, and slows them by the dynamic one
  /// beyond. Does not allocate.
  Twist Solve(const Twist& wanted, double length) noexcept;

private:
  bool SolveHeld(const Twist& wanted, double perTurn, Twist& twist) noexcept;
  struct PushRow;
  static double PushOne(PoseConstraint& at, const PushRow& row, double perTurn,
                        Twist& twist) noexcept;
  double DragOne(PoseConstraint& at, Twist& twist, double perTurn) const noexcept;

  std::array<PoseConstraint, Most> All;
  std::size_t Count = 0;
  std::size_t Owner = 0;
  bool IsHeld = false;
};
} // namespace palpate
