#pragma once

#include "Vector3.h"

#include <cmath>
#include <limits>

namespace palpate
{
/// A ray in index coordinates and the planes between cells that it crosses. When it crosses a plane
/// depends on the ray and on the plane alone; of planes crossed at once, those of the lower axis
/// count as earlier. So the cells of a ray are one sequence, whichever part of it is walked and
/// however it is walked.
class RayPath
{
public:
  /// False for what is no ray.
  bool Set(const Vector3& origin, const Vector3& direction) noexcept
  {
    this->Origin = origin;
    this->Direction = direction;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double inverse = 1.0 / direction[axis];
      const bool isMoving = std::isfinite(inverse);
      this->Step[axis] = !isMoving ? 0 : inverse > 0.0 ? 1 : -1;
      // An axis along which the ray stands still: all its planes are crossed at infinity.
      this->From[axis] = isMoving ? origin[axis] : -1.0;
      this->Inverse[axis] = isMoving ? inverse : std::numeric_limits<double>::infinity();
    }
    return origin.allFinite() && direction.allFinite() &&
           (this->Step[0] != 0 || this->Step[1] != 0 || this->Step[2] != 0);
  }

  int StepOf(int axis) const noexcept { return this->Step[axis]; }
  double Coordinate(int axis, double t) const noexcept
  {
    return this->Origin[axis] + t * this->Direction[axis];
  }
  Vector3 Point(double t) const noexcept { return this->Origin + t * this->Direction; }
  /// How far t goes while the ray moves by one voxel along an axis.
  double Slowness(int axis) const noexcept { return std::abs(this->Inverse[axis]); }
  /// The largest number that Coordinate adds.
  double Magnitude(double t) const noexcept
  {
    return (this->Origin.cwiseAbs() + std::abs(t) * this->Direction.cwiseAbs()).maxCoeff();
  }

  /// When the ray leaves a cell along an axis, if it is in its slab.
  double ExitAt(int axis, int cell) const noexcept
  {
    return this->PlaneAt(axis, this->Step[axis] > 0 ? cell + 1 : this->Step[axis] < 0 ? cell : 0);
  }
  double EntryAt(int axis, int cell) const noexcept
  {
    return this->Step[axis] == 0 ? -std::numeric_limits<double>::infinity()
                                 : this->PlaneAt(axis, this->Step[axis] > 0 ? cell : cell + 1);
  }

  /// The cell along an axis, of `cells`, after all planes that are crossed before t, or at t if
  /// `withTies`.
  int CellAt(int axis, double t, bool withTies, int cells) const noexcept
  {
    const double place =
        std::floor(this->Step[axis] == 0 ? this->Origin[axis] : this->Coordinate(axis, t));
    // Not a number, where t is huge, becomes 0.
    int cell = place > 0.0 ? static_cast<int>(place < cells - 1 ? place : cells - 1) : 0;
    const int step = this->Step[axis];
    if (step == 0)
    {
      return cell;
    }
    const auto isCrossed = [t, withTies](double plane)
    { return withTies ? plane <= t : plane < t; };
    const int last = step > 0 ? cells - 1 : 0;
    const int first = step > 0 ? 0 : cells - 1;
    while (cell != last && isCrossed(this->ExitAt(axis, cell)))
    {
      cell += step;
    }
    while (cell != first && !isCrossed(this->EntryAt(axis, cell)))
    {
      cell -= step;
    }
    return cell;
  }

private:
  double PlaneAt(int axis, int plane) const noexcept
  {
    return (plane - this->From[axis]) * this->Inverse[axis];
  }

  Vector3 Origin;
  Vector3 Direction;
  double From[3];
  double Inverse[3];
  int Step[3];
};
} // namespace palpate
