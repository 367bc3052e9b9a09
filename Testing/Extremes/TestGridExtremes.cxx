// Rays, inside tests and touch on grids and values of every size, on a plane, which trilinear
// interpolation represents exactly.
#include "FieldContactCases.h"
#include "RandomOrientation.h"
#include "WorstCase.h"

#include <gtest/gtest.h>

namespace palpate::grid_extremes_test
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
    this->CenterWorld = this->Grid.PointWorld(middle);
    // Crosses a similar number of voxels along each axis.
    this->Normal = this->Grid.GradientWorld(Vector3(1.0, -0.8, 0.6)).normalized();
    for (std::size_t n = 0; n < this->Grid.NodeCount(); ++n)
    {
      const Vector3 node = this->Grid.PointWorld(test::NodeIndex(this->Grid.Size(), n));
      this->Samples.push_back(scale * this->Height(node));
    }
  }
  double Height(const Vector3& pointWorld) const
  {
    return this->Normal.dot(pointWorld - this->CenterWorld);
  }

  FieldGrid Grid;
  Vector3 CenterWorld;
  Vector3 Normal; // into the material
  std::vector<double> Samples;
};

constexpr double NoAnswer = 1e9;

struct PlaneErrors
{
  WorstCase Hit;          // mm
  WorstCase Depth;        // mm, of a point
  WorstCase Normal;       // rad
  WorstCase SphereDepth;  // relative to the finest spacing, for a sphere of four times its width
  WorstCase SphereNormal; // rad
  int WrongSide = 0;
};

// Places on the plane, near the centre of the grid.
std::vector<Vector3> PlacesOn(const ObliquePlane& plane)
{
  std::mt19937_64 random(8821);
  std::uniform_real_distribution<double> aside(-3.0, 3.0);
  std::vector<Vector3> places;
  for (int n = 0; n < 200; ++n)
  {
    const Vector3 inIndex(aside(random), aside(random), aside(random));
    const Vector3 near = plane.CenterWorld + plane.Grid.VectorWorld(inIndex);
    places.emplace_back(near - plane.Height(near) * plane.Normal);
  }
  return places;
}

// A tool that moves perpendicularly to the plane, half of the finest spacing deep.
Contact Pressed(const ContactModel& contact, const ObliquePlane& plane, double toolRadius,
                const Vector3& place)
{
  const double step = plane.Grid.Spacing().minCoeff();
  const auto at = [&](double depth) { return At(place + (depth - toolRadius) * plane.Normal); };
  const auto tracker = test::TrackerOf(contact, ToolShape::Sphere(toolRadius));
  tracker->Follow(at(-2.0 * step));
  return tracker->Follow(at(0.5 * step));
}

PlaneErrors TouchPlane(const ObliquePlane& plane)
{
  const auto field = test::MakeField(plane.Grid, plane.Samples, 0.0);
  const RayCaster caster(field);
  const FieldSampler sampler(field);
  const auto contact = test::FieldContact(field);
  const double step = plane.Grid.Spacing().minCoeff();
  PlaneErrors errors;
  for (const Vector3& place : PlacesOn(plane))
  {
    const FieldHit hit =
        caster.CastWorld({place - 2.0 * step * plane.Normal, plane.Normal}, 0.0, 4.0 * step);
    errors.Hit.Add(hit.Kind == HitKind::Surface ? plane.Height(hit.Position) : NoAnswer);
    errors.WrongSide += sampler.IsInsideWorld(0, place - 1e-6 * step * plane.Normal) ? 1 : 0;
    errors.WrongSide += sampler.IsInsideWorld(0, place + 1e-6 * step * plane.Normal) ? 0 : 1;
    const Contact point = Pressed(*contact, plane, 0.0, place);
    errors.Depth.Add(point.IsValid ? point.Depth - 0.5 * step : NoAnswer);
    errors.Normal.Add((point.NormalWorld + plane.Normal).norm());
    const Contact sphere = Pressed(*contact, plane, 2.0 * step, place);
    errors.SphereDepth.Add(sphere.IsValid ? sphere.Depth / step - 0.5 : NoAnswer);
    errors.SphereNormal.Add((sphere.NormalWorld + plane.Normal).norm());
  }
  return errors;
}

// `bound` in mm and rad.
void ExpectExact(const PlaneErrors& errors, double bound)
{
  EXPECT_LE(errors.Hit.Value(), bound);
  EXPECT_LE(errors.Depth.Value(), bound);
  EXPECT_LE(errors.Normal.Value(), bound);
  // Its shell is nowhere lower than the sphere by more than that.
  EXPECT_LE(errors.SphereDepth.Value(), 0.05);
  EXPECT_LE(errors.SphereNormal.Value(), bound);
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

TEST(GridExtremes, PlaneTenMetresAwayIsExactToRounding)
{
  // Roundings of 10 m are 2e-12 mm; the samples contain them.
  ExpectExact(TouchPlane(ObliquePlane(Vector3::Constant(0.5), 1.0, {1e4, -1e4, 1e4})), 1e-10);
}

TEST(GridExtremes, ValuesOfAnySizeGiveTheSamePlane)
{
  // Denormal in float; the smallest and the largest that a field accepts
  for (const double scale : {1e-140, 1e-42, 1e-3, 1e37, 1e138})
  {
    ExpectExact(TouchPlane(ObliquePlane(Vector3::Constant(0.5), scale, Somewhere)), 1e-11);
  }
}
} // namespace
} // namespace palpate::grid_extremes_test
