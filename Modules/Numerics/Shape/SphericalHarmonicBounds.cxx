#include "SphericalHarmonicBounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
// Centres of caps and sines of their radii are rounded to float, directions of queries to double.
constexpr double GeometryTolerance = 1e-6;

constexpr double Infinity = std::numeric_limits<double>::infinity();

void Join(RadiusInterval& interval, const RadiusInterval& other)
{
  // Comparisons such that NaN propagates: it must not look like a bound.
  interval.Lower = other.Lower >= interval.Lower ? interval.Lower : other.Lower;
  interval.Upper = other.Upper <= interval.Upper ? interval.Upper : other.Upper;
}

void AddCenters(const SphericalTriangle& triangle, int refinement, std::vector<Vector3>& centers,
                double& radius)
{
  if (refinement <= 0)
  {
    const SphericalCap cap = triangle.Cap();
    centers.push_back(cap.Center);
    radius = std::max(radius, cap.Radius);
    return;
  }
  for (const SphericalTriangle& part : triangle.Split())
  {
    AddCenters(part, refinement - 1, centers, radius);
  }
}
} // namespace

// A cone and the position of caps relative to it, by chords: those are accurate for small angles,
// where cosines are not, and need no inverse functions.
struct SphericalHarmonicBounds::Cone
{
  Vector3 Axis;
  double Angle; // rad, 0 to pi
  double HalfSine;
  double HalfCosine;

  Cone(const Vector3& axis, double halfAngle)
      : Axis(axis), Angle(halfAngle < 0.0    ? 0.0
                          : halfAngle < M_PI ? halfAngle
                                             : M_PI), // NaN too
        HalfSine(std::sin(0.5 * this->Angle)), HalfCosine(std::cos(0.5 * this->Angle))
  {
  }

  double SquaredChord(const Node& node) const
  {
    return (this->Axis - Vector3(node.Center[0], node.Center[1], node.Center[2])).squaredNorm();
  }
  // Certainly disjoint; false with NaN.
  bool Misses(const Node& node, double squaredChord) const
  {
    const double sine = this->HalfSine * node.HalfCosine + this->HalfCosine * node.HalfSine;
    const double cosine = this->HalfCosine * node.HalfCosine - this->HalfSine * node.HalfSine;
    return cosine > 0.0 && squaredChord > 4.0 * sine * sine;
  }
  // The whole cap lies inside the cone; false with NaN.
  bool Holds(const Node& node, double squaredChord) const
  {
    const double sine = this->HalfSine * node.HalfCosine - this->HalfCosine * node.HalfSine;
    return sine > 0.0 && squaredChord < 4.0 * sine * sine;
  }
};

SphericalHarmonicBounds::SphericalHarmonicBounds(const SphericalHarmonicModel& model,
                                                 const Options& options)
    : Surface(model), Powers(model), Whole{Infinity, -Infinity}
{
  for (const SphericalTriangle& face : SphericalTriangle::Icosahedron())
  {
    const std::int32_t root = this->Build(face, options.Depth, options.Refinement);
    const Node& node = this->Nodes[static_cast<std::size_t>(root)];
    Join(this->Whole, node.Interval);
    this->WholeSlope = node.Slope <= this->WholeSlope ? this->WholeSlope : node.Slope;
  }
}

std::int32_t SphericalHarmonicBounds::Build(const SphericalTriangle& triangle, int depth,
                                            int refinement)
{
  const auto index = static_cast<std::int32_t>(this->Nodes.size());
  const SphericalCap cap = triangle.Cap();
  const double half = 0.5 * (cap.Radius + GeometryTolerance);
  Node node{{static_cast<float>(cap.Center.x()), static_cast<float>(cap.Center.y()),
             static_cast<float>(cap.Center.z())},
            static_cast<float>(std::sin(half)),
            static_cast<float>(std::cos(half)),
            0,
            {Infinity, -Infinity},
            0.0};
  this->Nodes.push_back(node);
  if (depth <= 0)
  {
    this->Enclose(triangle, refinement, node);
    this->WalkFrom = std::max(this->WalkFrom, 0.5 * cap.Radius);
  }
  else
  {
    for (const SphericalTriangle& part : triangle.Split())
    {
      const std::int32_t child = this->Build(part, depth - 1, refinement);
      const Node& childNode = this->Nodes[static_cast<std::size_t>(child)];
      Join(node.Interval, childNode.Interval);
      node.Slope = childNode.Slope <= node.Slope ? node.Slope : childNode.Slope;
    }
  }
  node.Next = static_cast<std::int32_t>(this->Nodes.size());
  this->Nodes[static_cast<std::size_t>(index)] = node;
  return index;
}

void SphericalHarmonicBounds::Enclose(const SphericalTriangle& triangle, int refinement,
                                      Node& node) const
{
  std::vector<Vector3> centers;
  double radius = 0.0;
  AddCenters(triangle, refinement, centers, radius);
  std::vector<SphericalHarmonicModel::Sample> samples(centers.size());
  this->Surface.EvaluateBatch(centers.data(), centers.size(), samples.data());
  for (const SphericalHarmonicModel::Sample& sample : samples)
  {
    Join(node.Interval, this->Powers.RadiusAround(sample, radius));
    const double slope = this->Powers.SlopeAround(sample, radius);
    node.Slope = slope <= node.Slope ? node.Slope : slope;
  }
}

template <typename AddsNothing, typename Joiner>
void SphericalHarmonicBounds::Walk(const Cone& cone, AddsNothing addsNothing,
                                   Joiner join) const noexcept
{
  const auto count = static_cast<std::int32_t>(this->Nodes.size());
  for (std::int32_t i = 0; i < count;)
  {
    const Node& node = this->Nodes[static_cast<std::size_t>(i)];
    const double squaredChord = cone.SquaredChord(node);
    if (cone.Misses(node, squaredChord) || addsNothing(node))
    {
      i = node.Next;
    }
    else if (node.Next == i + 1 || cone.Holds(node, squaredChord))
    {
      join(node);
      i = node.Next;
    }
    else
    {
      ++i;
    }
  }
}

RadiusInterval SphericalHarmonicBounds::RadiusInCone(const Vector3& axis,
                                                     double halfAngle) const noexcept
{
  const Cone cone(axis, halfAngle);
  const RadiusInterval near =
      this->Powers.RadiusAround(this->Surface.Evaluate(axis), cone.Angle + GeometryTolerance);
  if (cone.Angle <= this->WalkFrom && near.Lower <= near.Upper)
  {
    return near;
  }
  RadiusInterval joined{Infinity, -Infinity};
  this->Walk(
      cone,
      [&joined](const Node& node)
      { return node.Interval.Lower >= joined.Lower && node.Interval.Upper <= joined.Upper; },
      [&joined](const Node& node) { Join(joined, node.Interval); });
  // In this order an axis that is NaN leaves the whole sphere's interval.
  return {std::max(joined.Lower, near.Lower), std::min(joined.Upper, near.Upper)};
}

double SphericalHarmonicBounds::SlopeInCone(const Vector3& axis, double halfAngle) const noexcept
{
  const Cone cone(axis, halfAngle);
  const double near =
      this->Powers.SlopeAround(this->Surface.Evaluate(axis), cone.Angle + GeometryTolerance);
  if (cone.Angle <= this->WalkFrom && near >= 0.0)
  {
    return near;
  }
  double largest = 0.0;
  this->Walk(
      cone, [&largest](const Node& node) { return node.Slope <= largest; },
      [&largest](const Node& node) { largest = node.Slope; });
  return std::min(largest, near);
}
} // namespace palpate
