#include "DrilledCases.h"
#include "FieldContactCases.h"
#include "FieldProxyTracker.h"

#include <cmath>

namespace palpate::drilled_touch_test
{
namespace
{
constexpr double Spacing = 0.5; // mm

// Bone that fills its grid except for a border, its nodes at whole multiples of the spacing.
test::ScannedBone PlainBone()
{
  const FieldGrid grid({49, 49, 49}, Vector3::Zero(), Vector3::Constant(Spacing),
                       Matrix3::Identity());
  return {grid, 11.0, 0.5};
}

std::shared_ptr<const FieldSolid> SolidOf(DrilledField& drilled)
{
  std::shared_ptr<const FieldSolid> solid;
  EXPECT_TRUE(FieldSolid::Make(test::VersionOf(drilled), 0, solid).IsOk());
  return solid;
}

std::unique_ptr<ContactTracker> TrackerOf(DrilledField& drilled, double radius)
{
  return test::TrackerOf(*test::FieldContact(test::VersionOf(drilled)), ToolShape::Sphere(radius));
}

ToolPose PoseAt(const Vector3& position)
{
  ToolPose pose;
  pose.PositionWorld = position;
  return pose;
}

void CutCanal(DrilledField& drilled, double radius, const Vector3& middle)
{
  const Vector3 along = 8.0 * Vector3::UnitX();
  test::CutPath(drilled, CutTool::Sphere(radius), middle - along, middle + along);
}

TEST(DrilledTouch, SmallerSphereMeasuresTheCanalWithinATenthOfAVoxel)
{
  const test::ScannedBone bone = PlainBone();
  const auto drilled = test::Drill(*bone.Make());
  constexpr double Canal = 2.0;
  constexpr double Sphere = 1.0;
  const Vector3 middle = bone.Center + Vector3(0.0, 0.13, -0.21);
  CutCanal(*drilled, Canal, middle);
  for (int n = 0; n < 21; ++n)
  {
    const double angle = 0.3 * n;
    const auto tracker = TrackerOf(*drilled, Sphere);
    const Vector3 out(0.0, std::cos(angle), std::sin(angle));
    Vector3 proxy;
    for (int tick = 0; tick <= 150; ++tick)
    {
      proxy = tracker->Follow(PoseAt(middle + 0.01 * tick * out)).ProxyWorld;
    }
    EXPECT_NEAR((proxy - middle).norm() + Sphere, Canal, 0.1 * Spacing) << angle;
  }
}

// A wall between two canals, its centre on a layer of nodes: tools that hit it stay on their side,
// while versions follow each other.
TEST(DrilledTouch, ThinWallStopsFastTools)
{
  constexpr double Canal = 2.0;
  for (const double voxels : {0.5, 1.0})
  {
    const test::ScannedBone bone = PlainBone();
    const auto drilled = test::Drill(*bone.Make());
    const Vector3 apart = (Canal + 0.5 * voxels * Spacing) * Vector3::UnitZ();
    CutCanal(*drilled, Canal, bone.Center - apart);
    CutCanal(*drilled, Canal, bone.Center + apart);
    for (const double step : {0.05, 0.2, 0.9, 3.0}) // mm per tick
    {
      const Vector3 start = bone.Center - apart;
      const auto tracker = TrackerOf(*drilled, 0.5);
      std::vector<std::shared_ptr<const FieldSolid>> versions; // outlive their use
      for (int tick = 0; step * tick < 8.0; ++tick)
      {
        // Removal continues at the canal's end.
        const Vector3 end = start + Vector3(7.0 + 0.01 * tick, 0.0, 0.0);
        test::CutPath(*drilled, CutTool::Sphere(1.0), end, end);
        versions.push_back(SolidOf(*drilled));
        tracker->UseSolid(*versions.back());
        const Contact& contact = tracker->Follow(PoseAt(start + step * tick * Vector3::UnitZ()));
        ASSERT_LT(contact.ProxyWorld[2], bone.Center[2]) << voxels << " " << step;
      }
    }
  }
}
} // namespace
} // namespace palpate::drilled_touch_test
