#include "StretchedBasin.h"

#include "CenteredSurfaceSample.h"

namespace palpate
{
namespace
{
// A sample by steps of unit length on the surface instead of unit angles of the parameters.
CenteredSurface::SecondOrderSample Unstretched(const CenteredSurface::SecondOrderSample& sample,
                                               const std::array<double, 3>& metric) noexcept
{
  const auto& [aa, ab, bb] = metric;
  const double a = 1.0 / std::sqrt(aa);
  const double shear = ab / aa;
  const double b = 1.0 / std::sqrt(bb - shear * ab);
  const auto& [xa, xb] = sample.First;
  const auto& [xaa, xab, xbb] = sample.Second;
  CenteredSurface::SecondOrderSample even = sample;
  even.First = {a * xa, b * (xb - shear * xa)};
  even.Second = {a * a * xaa, a * b * (xab - shear * xaa),
                 b * b * (xbb - 2.0 * shear * xab + shear * shear * xaa)};
  return even;
}

// The half squared distance along a step of `length` mm is above its quadratic expansion minus
// length^3 / 6 times Fall(length); see ClosestPointDescent.cxx, with steps instead of angles.
struct ExpansionInBasin
{
  double Second;     // |x''|, 1/mm
  double Product;    // 3 |x'.x''|, 1/mm
  double Third;      // |x'''|, 1/mm^2
  double Distance;   // mm
  double Eigenvalue; // the smallest of the Hessian
  double Away;       // length of the Newton step, mm
  double Least;      // of the quadratic expansion, mm^2

  double Fall(double length) const noexcept
  {
    return this->Product +
           (this->Distance + length * (1.0 + 0.5 * length * this->Second)) * this->Third;
  }
  // Where length * Fall(length) is that part of the eigenvalue, or before.
  double LengthWithin(double part) const noexcept
  {
    double length = part * this->Eigenvalue / this->Fall(0.0);
    for (int i = 0; i < 4; ++i)
    {
      length = std::sqrt(length * part * this->Eigenvalue / this->Fall(length));
    }
    return std::min(length, part * this->Eigenvalue / this->Fall(length));
  }
};

ExpansionInBasin ExpansionOf(const CenteredSurface::SecondOrderSample& even,
                             const Vector3& offset) noexcept
{
  const double aa = 1.0 - offset.dot(even.Second[0]);
  const double ab = -offset.dot(even.Second[1]);
  const double bb = 1.0 - offset.dot(even.Second[2]);
  const double a = -offset.dot(even.First[0]);
  const double b = -offset.dot(even.First[1]);
  const double half = 0.5 * (aa + bb);
  const double determinant = aa * bb - ab * ab;
  const double larger = half + std::sqrt(std::max(0.0, half * half - determinant));
  const double stepA = (ab * b - bb * a) / determinant;
  const double stepB = (ab * a - aa * b) / determinant;
  ExpansionInBasin expansion{};
  expansion.Second = LargestSecond(even);
  expansion.Product = LargestProduct(even);
  expansion.Distance = offset.norm();
  expansion.Eigenvalue = half > 0.0 ? determinant / larger : -1.0;
  expansion.Away = std::sqrt(stepA * stepA + stepB * stepB);
  expansion.Least = 0.5 * (offset.squaredNorm() + a * stepA + b * stepB);
  return expansion;
}
} // namespace

StretchedBasin StretchedBasinAround(const Vector3& parameter,
                                    const CenteredSurface::SecondOrderSample& sample,
                                    const Vector3& offset, const PointDerivativeBounds& bounds,
                                    double rounding) noexcept
{
  StretchedBasin basin;
  const auto& [first, second] = sample.First;
  basin.Tangents = sample.Tangents;
  basin.Metric = {first.squaredNorm(), first.dot(second), second.squaredNorm()};
  const auto& [aa, ab, bb] = basin.Metric;
  basin.Stretch = LargestRoot(aa, ab, bb);
  const double determinant = aa * bb - ab * ab;
  const double trace = aa + bb;
  if (!(determinant > 1e-8 * trace * trace))
  {
    return basin;
  }
  const double least = std::sqrt(determinant) / basin.Stretch; // |x'|, mm/rad
  basin.Least = least;
  ExpansionInBasin expansion = ExpansionOf(Unstretched(sample, basin.Metric), offset);
  if (!(expansion.Eigenvalue > 0.0))
  {
    return basin;
  }
  constexpr double Widest = 1.0; // rad
  const auto& caps = bounds.CapAngles();
  for (const double angle : {caps[0], caps[1], caps[2], Widest})
  {
    expansion.Third = bounds.ThirdWithin(parameter, angle) / (least * least * least);
    const double away = expansion.Away;
    double length = expansion.LengthWithin(2.6);
    length = length < 30.0 * away ? expansion.LengthWithin(1.5) : length;
    const double known = 11.0 * away;
    const bool isWidest = length <= angle * least; // wider caps have larger derivatives
    length = std::min(length, angle * least);
    if (length <= basin.Reach || known > angle * least)
    {
      continue;
    }
    const double square =
        2.0 * (expansion.Least - known * known * known * expansion.Fall(known) / 6.0);
    basin.Reach = length;
    basin.LowerDistance = std::sqrt(std::max(0.0, square)) - rounding;
    if (isWidest)
    {
      break;
    }
  }
  return basin;
}
} // namespace palpate
