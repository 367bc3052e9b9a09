#include "DrilledCases.h"
#include "FieldNodes.h"
#include "FieldSampler.h"
#include "RemovalBytes.h"
#include "RemovalStroke.h"

#include <cmath>

namespace palpate::protection_test
{
namespace
{
constexpr double Nerve = 1.2; // mm, radius, around the axis along z through the centre

test::ScannedBone Bone()
{
  const FieldGrid grid({49, 49, 49}, Vector3::Zero(), Vector3::Constant(0.4), Matrix3::Identity());
  return {grid, 9.0, 0.4};
}

double DistanceToNerve(const test::ScannedBone& bone, const Vector3& point)
{
  const Vector3 nearby = point - bone.Center;
  return std::hypot(nearby[0], nearby[1]) - Nerve;
}

std::shared_ptr<const RemovedDistances> NerveOf(const test::ScannedBone& bone,
                                                const RemovedDistances& like)
{
  constexpr int Side = RemovedDistances::Side;
  RemovalStroke made(RemovedDistances::None(like.Grid(), like.Band()));
  for (int n = 0; n < 7 * 7 * 7; ++n)
  {
    const RemovedDistances::Corner corner{n % 7 * Side, n / 7 % 7 * Side, n / 49 * Side};
    RemovalStroke::Nodes distances;
    for (std::size_t node = 0; node < distances.size(); ++node)
    {
      const auto number = static_cast<int>(node);
      const Vector3 index(corner[0] + number % Side, corner[1] + number / Side % Side,
                          corner[2] + number / (Side * Side));
      const double distance = DistanceToNerve(bone, like.Grid().PointWorld(index));
      distances[node] = static_cast<float>(std::clamp(distance, -like.Band(), like.Band()));
    }
    made.Set(corner, distances);
  }
  return made.Finish();
}

struct Protected
{
  test::ScannedBone Scan = Bone();
  std::unique_ptr<DrilledField> Drilled = test::Drill(*Scan.Make());
  std::shared_ptr<const RemovedDistances> Nerve = NerveOf(Scan, Drilled->Now());

  Protected()
  {
    const Status status = this->Drilled->Protect(this->Nerve);
    EXPECT_TRUE(status.IsOk()) << status.Message();
  }
  // Across the nerve, through its axis.
  void CutAcross(double radius)
  {
    const Vector3 along = 4.0 * Vector3::UnitX();
    test::CutPath(*this->Drilled, CutTool::Sphere(radius), this->Scan.Center - along,
                  this->Scan.Center + along);
  }
};

TEST(Protection, ForbiddenRegionKeepsItsBits)
{
  Protected bone;
  bone.CutAcross(2.0);
  const std::vector<float> now = test::SamplesNow(*bone.Drilled, bone.Scan);
  // A cell's diagonal, and half a side for the correction of kinks between cuts.
  const double ramp = bone.Scan.Grid.Spacing().norm() + 0.5 * bone.Scan.Grid.Spacing().maxCoeff();
  int deep = 0;
  for (std::size_t n = 0; n < now.size(); ++n)
  {
    const double depth = -DistanceToNerve(
        bone.Scan, bone.Scan.Grid.PointWorld(test::NodeIndex(bone.Scan.Grid.Size(), n)));
    ASSERT_TRUE(depth < 0.1 * 0.4 || bone.Scan.Bone[n] < test::ScannedBone::Iso ||
                now[n] >= test::ScannedBone::Iso)
        << n;
    if (depth > ramp)
    {
      ASSERT_EQ(now[n], bone.Scan.Bone[n]);
      ++deep;
    }
  }
  EXPECT_GT(deep, 40);
}

// Two cylinders that cross at a right angle: 16/3 r^3 of equal ones; integrated here.
TEST(Protection, RemovesTheSweepMinusTheForbiddenRegion)
{
  Protected bone;
  constexpr double R = 2.0;
  bone.CutAcross(R);
  double common = 0.0; // intersection of the canal's cylinder and the nerve's
  constexpr int Steps = 20000;
  for (int n = 0; n < Steps; ++n)
  {
    const double y = Nerve * (2.0 * (n + 0.5) / Steps - 1.0);
    common +=
        2.0 * Nerve / Steps * 4.0 * std::sqrt(Nerve * Nerve - y * y) * std::sqrt(R * R - y * y);
  }
  const double wanted = M_PI * R * R * (8.0 + 4.0 / 3.0 * R) - common;
  EXPECT_NEAR(bone.Drilled->RemovedVolume(), wanted, 0.01 * wanted);
}

TEST(Protection, RemainingPillarIsForbiddenOneWithinATenthOfAVoxel)
{
  Protected bone;
  bone.CutAcross(2.0);
  const auto version = test::VersionOf(*bone.Drilled);
  const FieldSampler sampler(version);
  for (double angle = -0.6; angle <= 0.6; angle += 0.1) // where the canal meets it at a right angle
  {
    const Vector3 out(std::cos(angle), std::sin(angle), 0.0);
    double radius = 0.5 * Nerve;
    for (; radius < 2.0; radius += 0.001)
    {
      const Vector3 point = bone.Scan.Center + radius * out;
      unsigned char inside = 0;
      sampler.AreInsideWorld(0, &point, 1, &inside);
      if (inside == 0)
      {
        break;
      }
    }
    EXPECT_NEAR(radius, Nerve, 0.1 * 0.4) << angle;
  }
}

TEST(Protection, RestoredStateRemovesNothingForbidden)
{
  Protected bone;
  bone.CutAcross(2.0);
  const auto open = test::Drill(*bone.Scan.Make());
  const Vector3 along = 4.0 * Vector3::UnitX();
  test::CutPath(*open, CutTool::Sphere(2.0), bone.Scan.Center - along, bone.Scan.Center + along);
  Protected restored;
  ASSERT_TRUE(restored.Drilled->Restore(open->Removed()).IsOk());
  EXPECT_EQ(BytesOf(*restored.Drilled->Removed()), BytesOf(*bone.Drilled->Removed()));
  // Undo restores the previous state.
  restored.Drilled->Undo();
  EXPECT_EQ(restored.Drilled->RemovedVolume(), 0.0);
}

TEST(Protection, FullyForbiddenCutRemovesNothing)
{
  Protected bone;
  test::CutPath(*bone.Drilled, CutTool::Sphere(0.3), bone.Scan.Center, bone.Scan.Center);
  EXPECT_EQ(bone.Drilled->RemovedVolume(), 0.0);
}

TEST(Protection, RequiresTheSameGridAndNoEarlierCut)
{
  Protected bone;
  bone.CutAcross(1.0);
  EXPECT_FALSE(bone.Drilled->Protect(bone.Nerve).IsOk());
  const FieldGrid other({10, 10, 10}, Vector3::Zero(), Vector3::Ones(), Matrix3::Identity());
  EXPECT_FALSE(test::Drill(*bone.Scan.Make())
                   ->Protect(RemovedDistances::None(other, bone.Drilled->Now().Band()))
                   .IsOk());
}

TEST(FieldNodes, EqualSamplesWhereStoredAndKeepTheirSideElsewhere)
{
  const test::ScannedBone scan = Bone();
  const auto field = scan.Make(scan.Bone);
  const std::vector<float> nodes = NodesOf(*field, 0);
  ASSERT_EQ(nodes.size(), scan.Bone.size());
  for (std::size_t n = 0; n < nodes.size(); ++n)
  {
    const bool isInside = scan.Bone[n] >= test::ScannedBone::Iso;
    ASSERT_EQ(nodes[n] >= test::ScannedBone::Iso, isInside) << n;
    ASSERT_TRUE(!isInside || nodes[n] == scan.Bone[n]) << n; // the inside is preserved
  }
}
} // namespace
} // namespace palpate::protection_test
