#include "TangentSphere.h"

#include "CenteredSurfaceSample.h"
#include "SurfaceCurvature.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace palpate
{
namespace
{
constexpr double Unlimited = std::numeric_limits<double>::infinity();

using Tree = SurfacePatchTreeOf<CenteredSurface>;

struct Place
{
  Vector3 Point; // relative to the surface's centre, mm
  Vector3 Normal;

  // Of the sphere that touches here and touches a ball.
  double RadiusTo(const Vector3& center, double size) const noexcept
  {
    const Vector3 across = center - this->Point;
    const double rise = across.dot(this->Normal) + size;
    return rise > 0.0 ? 0.5 * (across.squaredNorm() - size * size) / rise : Unlimited;
  }
};

// Of the surface: points nearer to the place than this are on it up to rounding, and say nothing.
// Its curvature stands for them.
constexpr double Beside = 1e-6;

// Along the normal to the first centre of curvature, at most `largest`; 0 where the surface has no
// tangent plane.
double FocusWithin(double largest, const CenteredSurface::SecondOrderSample& sample,
                   const Vector3& normal) noexcept
{
  const auto [most, least] = CurvatureAt(sample).Principal;
  const double towards = AreaVector(sample).dot(normal) < 0.0 ? most : -least;
  return towards * largest <= 1.0 ? largest : towards > 0.0 ? 1.0 / towards : 0.0;
}

// The sphere of the smallest radius through the middle of a part.
struct Limit
{
  double Radius; // mm
  int Node;      // of the part; -1 where none is that near
};

class LimitSearch
{
public:
  LimitSearch(const Tree& tree, const Place& place, double largest) noexcept
      : Parts(tree), At(place), Found{largest, -1}
  {
  }

  Limit Run() noexcept
  {
    for (int root = 0; root < Tree::RootCount; ++root)
    {
      this->Examine(root, 0);
    }
    while (this->Count > 0)
    {
      const Part next = this->Open[--this->Count];
      const std::size_t first = this->Count;
      for (int part = 0; next.Least < this->Found.Radius && part < 4; ++part)
      {
        this->Examine(Tree::FirstPart(next.Node) + part, first);
      }
    }
    return this->Found;
  }

private:
  struct Part
  {
    double Least; // radius of a sphere that touches it, mm
    int Node;
  };

  // Of those from number `first` on, the one that promises the smallest sphere is next.
  void Examine(int node, std::size_t first) noexcept
  {
    const auto [center, size] = this->Parts.MiddlesOf(node);
    const double radius = this->At.RadiusTo(center, size);
    const double beside = Beside * this->Parts.LargestRadius();
    const bool isPlace = size == 0.0 && (center - this->At.Point).squaredNorm() < beside * beside;
    if (!(radius < this->Found.Radius) || isPlace)
    {
      return;
    }
    if (!this->Parts.IsInner(node))
    {
      this->Found = {radius, node};
      return;
    }
    std::size_t at = this->Count++;
    for (; at > first && this->Open[at - 1].Least < radius; --at)
    {
      this->Open[at] = this->Open[at - 1];
    }
    this->Open[at] = {radius, node};
  }

  static constexpr std::size_t MostLevels = 16;

  const Tree& Parts;
  Place At;
  Limit Found;
  std::array<Part, Tree::RootCount + 3 * MostLevels> Open;
  std::size_t Count = 0;
};

// The middle of a part may be beside the nearest point.
double Shrunk(const ClosestPointSearchOf<CenteredSurface>& search, const Place& place,
              const Limit& limit) noexcept
{
  constexpr int Spheres = 4;
  constexpr int Evaluations = 8;
  constexpr double Almost = 0.995;
  constexpr double Tolerance = 1e-4; // rad
  double radius = limit.Radius;
  Vector3 parameter = search.Tree().CapOf(limit.Node).Center;
  for (int sphere = 0; sphere < Spheres; ++sphere)
  {
    const Vector3 center = place.Point + radius * place.Normal;
    const auto nearest = search.Descent().Run(
        center, parameter, search.Model().EvaluateSecondOrder(parameter), Tolerance, Evaluations);
    const Vector3 point = nearest.PointWorld - search.Model().CenterWorld();
    if ((point - center).norm() >= Almost * radius)
    {
      break;
    }
    radius = std::clamp(place.RadiusTo(point, 0.0), 0.0, radius);
    parameter = nearest.Direction;
  }
  return radius;
}
} // namespace

double LargestTangentSphere(const ClosestPointSearchOf<CenteredSurface>& search,
                            const CenteredSurface::SecondOrderSample& sample, const Vector3& normal,
                            double largest) noexcept
{
  const Place place{sample.Point, normal};
  const Limit limit = LimitSearch(search.Tree(), place, FocusWithin(largest, sample, normal)).Run();
  return limit.Node < 0 ? limit.Radius : Shrunk(search, place, limit);
}
} // namespace palpate
