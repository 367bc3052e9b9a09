#include "BoundsBenchmarks.h"

#include "RandomShapes.h"
#include "SphericalHarmonicBounds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <sstream>

namespace palpate::bench
{
namespace
{
using BoundSample = SphericalHarmonicModel::Sample;

constexpr double HalfAngle = 0.5; // rad
constexpr int SampleCount = 642;  // the vertices of an icosahedron of frequency 8
constexpr int ConeCount = 64;

// Directions distributed evenly over the cone about +z: a spiral of equal solid angles.
std::vector<Vector3> DirectionsInCone()
{
  std::vector<Vector3> directions;
  const double turn = M_PI * (3.0 - std::sqrt(5.0)); // the golden angle
  for (int i = 0; i < SampleCount; ++i)
  {
    const double z = 1.0 - (1.0 - std::cos(HalfAngle)) * (i + 0.5) / SampleCount;
    const double s = std::sqrt((1.0 - z) * (1.0 + z));
    directions.emplace_back(s * std::cos(turn * i), s * std::sin(turn * i), z);
  }
  return directions;
}

// Cones about random axes on one organ.
class ConeCase
{
public:
  ConeCase() : Bounds(MakeModel()), Samples(SampleCount), Certified(ConeCount), Sampled(ConeCount)
  {
    test::Random random(31);
    this->Axes = test::RandomDirections(random, ConeCount);
    const std::vector<Vector3> aboutZ = DirectionsInCone();
    for (const Vector3& axis : this->Axes)
    {
      const Vector3 first = axis.unitOrthogonal();
      const Vector3 second = axis.cross(first);
      std::vector<Vector3> directions;
      directions.reserve(aboutZ.size());
      for (const Vector3& direction : aboutZ)
      {
        directions.push_back(direction.x() * first + direction.y() * second + direction.z() * axis);
      }
      this->Directions.push_back(std::move(directions));
    }
  }

  void Certify()
  {
    for (std::size_t i = 0; i < ConeCount; ++i)
    {
      this->Certified[i] = this->Bounds.RadiusInCone(this->Axes[i], HalfAngle);
    }
  }

  void Sampling()
  {
    for (std::size_t i = 0; i < ConeCount; ++i)
    {
      this->Bounds.Model().EvaluateBatch(this->Directions[i].data(), SampleCount,
                                         this->Samples.data());
      const auto less = [](const BoundSample& a, const BoundSample& b)
      { return a.Radius < b.Radius; };
      const auto extremes = std::minmax_element(this->Samples.begin(), this->Samples.end(), less);
      this->Sampled[i] = {extremes.first->Radius, extremes.second->Radius};
    }
  }

  std::string Disagreement() const
  {
    double excess = 0.0;
    for (std::size_t i = 0; i < ConeCount; ++i)
    {
      const double below = this->Sampled[i].Lower - this->Certified[i].Lower;
      const double above = this->Certified[i].Upper - this->Sampled[i].Upper;
      if (!(below >= 0.0 && above >= 0.0))
      {
        return "a sampled radius is outside the certified bounds";
      }
      excess = std::max({excess, below, above});
    }
    // Change of the organ's radius over a smallest triangle: two tenths of a radian times slopes of
    // some 5 mm/rad.
    if (excess <= 1.0)
    {
      return {};
    }
    std::ostringstream text;
    text << "certified bounds are " << excess << " mm wider than the samples";
    return text.str();
  }

private:
  static SphericalHarmonicModel MakeModel()
  {
    test::Random random(30);
    return test::RandomOrgan(random, 12);
  }

  SphericalHarmonicBounds Bounds;
  std::vector<Vector3> Axes;
  std::vector<std::vector<Vector3>> Directions;
  std::vector<BoundSample> Samples;
  std::vector<RadiusInterval> Certified;
  std::vector<RadiusInterval> Sampled;
};
} // namespace

std::vector<PairedBenchmark> BoundsBenchmarks()
{
  const auto c = std::make_shared<ConeCase>();
  return {{"sh/bounds/cone/degree12", "642 directions sampled in a batch", [c] { c->Certify(); },
           [c] { c->Sampling(); }, [c] { return c->Disagreement(); }, ConeCount}};
}
} // namespace palpate::bench
