#pragma once

#include "ProjectedShapes.h"
#include "RadialModel.h"

#include <algorithm>
#include <cmath>

namespace palpate::test
{
/// A body of revolution about z whose radius is a polynomial in z, so that its harmonics represent
/// it exactly: a spindle thin at the equator, or a disc thin at the poles.
struct SlenderBody
{
  bool IsNeedle;
  int Degree;       ///< even
  double Length;    ///< mm, from the centre to the tips or the rim
  double Thickness; ///< mm, from the centre to the waist or the faces

  RadialModel Model(const Vector3& centerWorld = Vector3::Zero()) const
  {
    const auto radius = [this](const Vector3& u)
    {
      const double square = this->IsNeedle ? u[2] * u[2] : 1.0 - u[2] * u[2];
      return this->Thickness +
             (this->Length - this->Thickness) * std::pow(square, this->Degree / 2);
    };
    return Project(this->Degree, radius, centerWorld);
  }
};

/// The unsigned distance (mm) from a place to such a body's surface: the nearest point lies in the
/// half plane of the place and the axis, which is searched in steps of a 20,000th and then by
/// golden sections.
inline double DistanceInMeridian(const RadialModel& model, const Vector3& queryWorld)
{
  const Vector3 q = queryWorld - model.CenterWorld();
  const double aside = std::hypot(q[0], q[1]);
  const auto squared = [&](double angle)
  {
    const Vector3 u(std::sin(angle), 0.0, std::cos(angle));
    const double r = model.Radius(u);
    return std::pow(r * u[0] - aside, 2) + std::pow(r * u[2] - q[2], 2);
  };
  constexpr int Steps = 20000;
  constexpr double Step = M_PI / Steps;
  int best = 0;
  double least = squared(0.0);
  for (int n = 1; n <= Steps; ++n)
  {
    const double there = squared(n * Step);
    best = there < least ? n : best;
    least = std::min(least, there);
  }
  double low = (best - 1) * Step;
  double high = (best + 1) * Step;
  constexpr double Golden = 0.6180339887498949;
  for (int n = 0; n < 60; ++n)
  {
    const double first = high - Golden * (high - low);
    const double second = low + Golden * (high - low);
    if (squared(first) < squared(second))
    {
      high = second;
    }
    else
    {
      low = first;
    }
  }
  return std::sqrt(squared(0.5 * (low + high)));
}
} // namespace palpate::test
