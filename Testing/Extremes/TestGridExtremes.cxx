// Rays, inside tests and touch on grids and values of every size, on a plane, which trilinear
// interpolation holds exactly.
#include "FieldContactCases.h"
#include "RandomOrientation.h"
#include "WorstCase.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
using test::At;
using test::WorstCase;

// value = (normal . world) * scale on an oblique grid: exact by trilinear interpolation.
struct ObliquePlane
{
  ObliquePlane(const Vector3& spacing, double scale, const Vector3& originWorld)
  {
    std::mt19937_64 random(8820);
    this->Grid = {{30, 30, 30}, originWorld, spacing, test::RandomOrientation(random)};
    const Vector3 middle = Vector3::Constant(14.5);
    this->MiddleWorld = this->Grid.PointWorld(middle);
    // Crosses about as many voxels along each axis.
    this->Normal = this->Grid.GradientWorld(Vector3(1.0, -0.8, 0.6)).normalized();
    for (std::size_t n = 0; n < this->Grid.NodeCount(); ++n)
    {
      const Vector3 node = this->Grid.PointWorld(test::NodeIndex(this->Grid.Size(), n));
      this->Samples.push_back(scale * this->Height(node));
    }
  }
  double Height(const Vector3& pointWorld) const
  {
    return this->Normal.dot(pointWorld - this->MiddleWorld);
  }

  FieldGrid Grid;
  Vector3 MiddleWorld;
  Vector3 Normal; // into the material
  std::vector<double> Samples;
};

constexpr double NoAnswer = 1e9;

struct PlaneErrors
{
  WorstCase Hit;    // mm
  WorstCase Depth;  // mm
  WorstCase Normal; // rad
  int WrongSide = 0;
};

PlaneErrors TouchPlane(const ObliquePlane& plane)
{
  const auto field = test::MakeField(plane.Grid, plane.Samples, 0.0);
  const RayCaster caster(field);
  const FieldSampler sampler(field);
  const auto contact = test::FieldContact(field);
  const double step = plane.Grid.Spacing().minCoeff();
  std::mt19937_64 random(8821);
  std::uniform_real_distribution<double> aside(-3.0, 3.0);
  PlaneErrors errors;
  for (int n = 0; n < 200; ++n)
  {
    const Vector3 inIndex = Vector3(aside(random), aside(random), aside(random));
    const Vector3 near = plane.MiddleWorld + plane.Grid.VectorWorld(inIndex);
    const Vector3 foot = near - plane.Height(near) * plane.Normal;
    const FieldHit hit =
        caster.CastWorld({foot - 2.0 * step * plane.Normal, plane.Normal}, 0.0, 4.0 * step);
    errors.Hit.Add(hit.Kind == HitKind::Surface ? plane.Height(hit.Position) : NoAnswer);
    errors.WrongSide += sampler.IsInsideWorld(0, foot - 1e-6 * step * plane.Normal) ? 1 : 0;
    errors.WrongSide += sampler.IsInsideWorld(0, foot + 1e-6 * step * plane.Normal) ? 0 : 1;
    const auto tracker = test::TrackerOf(*contact, ToolShape::Sphere(0.0));
    tracker->Follow(At(foot - 2.0 * step * plane.Normal));
    const Contact& felt = tracker->Follow(At(foot + 0.5 * step * plane.Normal));
    errors.Depth.Add(felt.IsValid ? felt.Depth - 0.5 * step : NoAnswer);
    errors.Normal.Add((felt.NormalWorld + plane.Normal).norm());
  }
  return errors;
}

// `bound` in mm and rad.
void ExpectExact(const PlaneErrors& errors, double bound)
{
  EXPECT_LE(errors.Hit.Value(), bound);
  EXPECT_LE(errors.Depth.Value(), bound);
  EXPECT_LE(errors.Normal.Value(), bound);
  EXPECT_EQ(errors.WrongSide, 0);
}

const Vector3 Somewhere(-12.5, 40.25, 7.0);

TEST(GridExtremes, SpacingsOneToAHundredAreExactOnAPlane)
{
  for (const Vector3& spacing : {Vector3(0.1, 0.1, 10.0), Vector3(10.0, 0.1, 1.0)})
  {
    // Roundings of 300 mm, divided by the finest spacing for the normal.
    ExpectExact(TouchPlane(ObliquePlane(spacing, 1.0, Somewhere)), 1e-11);
  }
}

TEST(GridExtremes, TenMetresAwayAPlaneIsExactToRounding)
{
  // Roundings of 10 m are 2e-12 mm; samples are made of them.
  ExpectExact(TouchPlane(ObliquePlane(Vector3::Constant(0.5), 1.0, {1e4, -1e4, 1e4})), 1e-10);
}

TEST(GridExtremes, ValuesOfAnySizeGiveTheSamePlane)
{
  // Denormal in float; the least and the most that a field takes
  for (const double scale : {1e-140, 1e-42, 1e-3, 1e37, 1e138})
  {
    ExpectExact(TouchPlane(ObliquePlane(Vector3::Constant(0.5), scale, Somewhere)), 1e-11);
  }
}
} // namespace
} // namespace palpate
