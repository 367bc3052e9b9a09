#include "BeamClearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();
// Voxels; far above the rounding of any ray's index, far below what matters.
constexpr double Slack = 1e-6;
// A beam that leaps less than this, in voxels, is better left to its rays.
constexpr double LeastLeap = 0.5;

struct Box
{
  Vector3 Lower;
  Vector3 Upper;
};

// Until when the beam's box, from t on, stays within limits along an axis; before t where it does
// not at t.
double StaysUntil(const FieldBeam& beam, int axis, double lower, double upper, double t) noexcept
{
  const double middle = beam.Middle.Origin[axis];
  const double place = middle + t * beam.Middle.Direction[axis];
  const double half = beam.HalfSize[axis] + t * beam.Growth[axis] + Slack;
  if (place - half < lower || place + half > upper)
  {
    return -Infinite;
  }
  const double slope = beam.Middle.Direction[axis];
  const double rise = slope + beam.Growth[axis];
  const double fall = slope - beam.Growth[axis];
  double until = Infinite;
  if (rise > 0.0)
  {
    until = (upper - Slack - middle - beam.HalfSize[axis]) / rise;
  }
  if (fall < 0.0)
  {
    until = std::min(until, (lower + Slack - middle + beam.HalfSize[axis]) / fall);
  }
  return until;
}

// When the beam's box first reaches into the grid; infinite if never.
double Arrival(const FieldBeam& beam, const FieldGrid& grid, double t) noexcept
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double last = grid.Size()[static_cast<std::size_t>(axis)] - 1;
    const double half = beam.HalfSize[axis] + Slack;
    const double low = beam.Middle.Origin[axis] - half;
    const double high = beam.Middle.Origin[axis] + half;
    const double rise = beam.Middle.Direction[axis] + beam.Growth[axis];
    const double fall = beam.Middle.Direction[axis] - beam.Growth[axis];
    if (high + t * rise < 0.0)
    {
      t = rise > 0.0 ? -high / rise : Infinite;
    }
    else if (low + t * fall > last)
    {
      t = fall < 0.0 ? (last - low) / fall : Infinite;
    }
  }
  return t;
}

// The empty bricks round a place, as far as its leap says; beyond the grid everything is empty.
// False where the place's brick has a surface, or lies in a material, which may end at the grid's
// border.
bool EmptyBox(const ScalarField& field, const Vector3& place, Box& box) noexcept
{
  const BrickLayout& layout = field.Layout();
  int brick[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const int last = layout.Bricks[static_cast<std::size_t>(axis)] - 1;
    brick[axis] = static_cast<int>(
        std::clamp(std::floor(place[axis] / BrickLayout::Cells), 0.0, static_cast<double>(last)));
  }
  const BrickDirectory::Entry& entry =
      field.Directory()[layout.Number(brick[0], brick[1], brick[2])];
  const auto leap = static_cast<int>(entry.Leap);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int count = layout.Bricks[static_cast<std::size_t>(axis)];
    const int first = brick[axis] - leap + 1;
    const int end = brick[axis] + leap;
    box.Lower[axis] = first <= 0 ? -Infinite : static_cast<double>(BrickLayout::Cells * first);
    box.Upper[axis] = end >= count ? Infinite : static_cast<double>(BrickLayout::Cells * end);
  }
  return leap > 0 && entry.Word == 0;
}
} // namespace

FieldBeam BeamOf(const FieldRay (&cornersIndex)[4]) noexcept
{
  FieldBeam beam;
  beam.Middle.Origin.setZero();
  beam.Middle.Direction.setZero();
  for (const FieldRay& corner : cornersIndex)
  {
    beam.Middle.Origin += 0.25 * corner.Origin;
    beam.Middle.Direction += 0.25 * corner.Direction;
  }
  for (const FieldRay& corner : cornersIndex)
  {
    beam.HalfSize = beam.HalfSize.cwiseMax((corner.Origin - beam.Middle.Origin).cwiseAbs());
    beam.Growth = beam.Growth.cwiseMax((corner.Direction - beam.Middle.Direction).cwiseAbs());
  }
  return beam;
}

double ClearUntil(const ScalarField& field, const FieldBeam& beamIndex, double tMin,
                  double tMax) noexcept
{
  const double speed = beamIndex.Middle.Direction.lpNorm<Eigen::Infinity>();
  double t = std::max(tMin, Arrival(beamIndex, field.Grid(), tMin));
  while (t < tMax)
  {
    const Vector3 place = beamIndex.Middle.Origin + t * beamIndex.Middle.Direction;
    Box empty;
    if (!EmptyBox(field, place, empty))
    {
      return t;
    }
    double until = Infinite;
    for (int axis = 0; axis < 3; ++axis)
    {
      until = std::min(until, StaysUntil(beamIndex, axis, empty.Lower[axis], empty.Upper[axis], t));
    }
    if (!((until - t) * speed > LeastLeap))
    {
      return std::max(t, std::min(until, tMax));
    }
    t = until;
  }
  return tMax;
}
} // namespace palpate
