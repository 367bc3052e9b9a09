#pragma once

#include "RayPath.h"

namespace palpate
{
/// The part of a ray in one cell, between two planes that it crosses.
struct CellSegment
{
  double T0, T1;
  double U0[3],
      U1[3]; ///< ends in the cell, from 0 to 1; just 0 or 1 along the axis that is crossed

  CellSegment(const RayPath& path, const int* cell, double t0, int entryAxis, double t1,
              int exitAxis) noexcept
      : T0(t0), T1(t1)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->U0[axis] = Within(path.Coordinate(axis, t0) - cell[axis]);
      this->U1[axis] = Within(path.Coordinate(axis, t1) - cell[axis]);
    }
    this->U0[entryAxis] = path.StepOf(entryAxis) > 0 ? 0.0 : 1.0;
    this->U1[exitAxis] = path.StepOf(exitAxis) > 0 ? 1.0 : 0.0;
  }

  double At(double parameter) const noexcept
  {
    const double t = this->T0 + parameter * (this->T1 - this->T0);
    return t < this->T1 ? t : this->T1;
  }
  static double Within(double u) noexcept { return u > 0.0 ? (u < 1.0 ? u : 1.0) : 0.0; }
};
} // namespace palpate
