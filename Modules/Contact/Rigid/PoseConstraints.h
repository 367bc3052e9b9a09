#pragma once

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
  double Push = 0.0;                 ///< mm: its multiplier, kept as the next solution's start
  std::size_t Source = 0;            ///< the asker's own number of it
};

/// At most so many at a time; the nearest ones, if there are more.
class PoseConstraints
{
public:
  static constexpr std::size_t Most = 32;

  void Clear() noexcept { this->Count = 0; }
  void Add(const PoseConstraint& constraint) noexcept;
  void ForgetPushes() noexcept;
  std::size_t Size() const noexcept { return this->Count; }
  const PoseConstraint& operator[](std::size_t n) const noexcept { return this->All[n]; }

  /// The twist nearest to `wanted`, in |shift|^2 + length^2 |turn|^2, that no constraint forbids:
  /// n . (shift + turn x arm) + gap >= 0. Projected Gauss-Seidel on the multipliers (Ortega, Redon
  /// and Coquillart, "A six degree-of-freedom god-object method", IEEE TVCG 13, 2007, in its
  /// quasi-static form), from those that the constraints bring. Does not allocate.
  Twist Solve(const Twist& wanted, double length) noexcept;

private:
  std::array<PoseConstraint, Most> All;
  std::size_t Count = 0;
};
} // namespace palpate
