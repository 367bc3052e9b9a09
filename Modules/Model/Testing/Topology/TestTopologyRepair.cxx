#include "MarchingTetrahedra.h"
#include "TopologyPhantoms.h"
#include "TopologyRepair.h"

#include <gtest/gtest.h>
#include <random>

namespace palpate::topology_repair_test
{
namespace
{
using namespace palpate::phantoms;

constexpr double Spacing = 0.6;

// A ring that is thinnest at the positive x axis.
double DentedRing(const Vector3& p)
{
  return Ring(p, 9.0, 3.0, 1.2);
}

TEST(TopologyRepair, LeavesBallAsItIs)
{
  palpate::ShapeField field =
      Sampled(7.0, Spacing, [](const Vector3& p) { return Sphere(p, 6.0); });
  const std::vector<float> before = field.Values;
  palpate::TopologyReport report;
  ASSERT_TRUE(palpate::RepairTopology(field, {}, report).IsOk());
  EXPECT_EQ(field.Values, before);
  EXPECT_EQ(report.ChangedVolume(), 0.0);
}

TEST(TopologyRepair, CutsRingWhereItIsThinnest)
{
  palpate::ShapeField field = Sampled(13.0, Spacing, DentedRing);
  palpate::TopologyReport report;
  ASSERT_TRUE(palpate::RepairTopology(field, {}, report).IsOk());
  EXPECT_TRUE(IsBall(field));
  EXPECT_EQ(report.CutHandles.Count, 1);
  EXPECT_EQ(report.FilledHandles.Count, 0);
  EXPECT_LT((report.CutHandles.LargestCentre - Vector3(9.0, 0.0, 0.0)).norm(), 2.0 * Spacing);
  // A gap on both sides of one node across a tube of 1.8 mm radius: at the tube's surface, where
  // the field is shallow, up to a step; inside of it a tenth. Oblique ones are up to sqrt(3) as
  // large.
  const double wall = std::acos(-1.0) * 1.8 * 1.8 * Spacing;
  EXPECT_GT(report.CutHandles.Volume, 0.1 * wall);
  EXPECT_LT(report.CutHandles.Volume, 1.0 * wall);
}

// A ring with a heavy part at negative x, and two necks: a thinner one beside the heavy part, and
// one opposite to it. Noise would decide between them.
TEST(TopologyRepair, CutsFarFromTheCentreWhereNecksAreAlike)
{
  const auto signet = [](const Vector3& p)
  {
    const double around = std::atan2(p[1], p[0]);
    const auto neck = [around](double at, double depth)
    { return depth * std::exp(-std::pow((around - at) / 0.3, 2)); };
    const double tube = 2.4 - neck(0.0, 1.0) - neck(1.9, 1.1);
    const double ring = tube - std::hypot(std::hypot(p[0], p[1]) - 9.0, p[2]);
    return std::max(ring, Sphere(p - Vector3(-9.0, 0.0, 0.0), 4.5));
  };
  palpate::ShapeField field = Sampled(15.0, Spacing, signet);
  palpate::TopologyReport report;
  ASSERT_TRUE(palpate::RepairTopology(field, {}, report).IsOk());
  EXPECT_TRUE(IsBall(field));
  EXPECT_EQ(report.CutHandles.Count, 1);
  EXPECT_LT((report.CutHandles.LargestCentre - Vector3(9.0, 0.0, 0.0)).norm(), 3.0 * Spacing);
}

// At positive x the ring is a band, thin and wide; at negative x a neck, thicker and much narrower.
TEST(TopologyRepair, CutsWhereCrossSectionIsLeast)
{
  constexpr double Radius = 10.0;
  const auto part = [](double cosine) { return std::pow(std::max(0.0, cosine), 12.0); };
  palpate::ShapeField field =
      Sampled(17.0, 0.4,
              [&](const Vector3& p)
              {
                const double around = std::max(1e-9, std::hypot(p[0], p[1]));
                const double band = part(p[0] / around);
                const double neck = part(-p[0] / around);
                const double thick = 2.6 - 1.7 * band - 1.2 * neck; // radially
                const double wide = 2.6 + 2.4 * band - 1.2 * neck;  // along z
                const double out = std::hypot((around - Radius) / thick, p[2] / wide);
                return std::min(thick, wide) * (1.0 - out);
              });
  palpate::TopologyReport report;
  ASSERT_TRUE(palpate::RepairTopology(field, {}, report).IsOk());
  EXPECT_TRUE(IsBall(field));
  EXPECT_EQ(report.CutHandles.Count, 1);
  EXPECT_LT((report.CutHandles.LargestCentre - Vector3(-Radius, 0.0, 0.0)).norm(), 2.0);
}

TEST(TopologyRepair, FillsNarrowHole)
{
  palpate::ShapeField field =
      Sampled(9.0, Spacing, [](const Vector3& p) { return Ring(p, 4.0, 3.2); });
  palpate::TopologyReport report;
  ASSERT_TRUE(palpate::RepairTopology(field, {}, report).IsOk());
  EXPECT_TRUE(IsBall(field));
  EXPECT_EQ(report.CutHandles.Count, 0);
  EXPECT_EQ(report.FilledHandles.Count, 1);
  EXPECT_LT(report.FilledHandles.LargestCentre.head<2>().norm(), 2.0 * Spacing);
}

// A hole about as wide as the tube.
TEST(TopologyRepair, FillsHoleWhereACutCostsAboutAsMuch)
{
  palpate::ShapeField field =
      Sampled(9.0, Spacing, [](const Vector3& p) { return Ring(p, 4.2, 2.15); });
  palpate::TopologyReport report;
  ASSERT_TRUE(palpate::RepairTopology(field, {}, report).IsOk());
  EXPECT_TRUE(IsBall(field));
  EXPECT_EQ(report.CutHandles.Count, 0);
  EXPECT_EQ(report.FilledHandles.Count, 1);
}

TEST(TopologyRepair, CutsBothRingsOfDoubleTorus)
{
  const Vector3 beside(8.0, 0.0, 0.0);
  palpate::ShapeField field =
      Sampled(18.0, Spacing,
              [&](const Vector3& p)
              { return std::max(Ring(p - beside, 7.0, 2.0), Ring(p + beside, 7.0, 2.0)); });
  palpate::TopologyReport report;
  ASSERT_TRUE(palpate::RepairTopology(field, {}, report).IsOk());
  EXPECT_TRUE(IsBall(field));
  EXPECT_EQ(report.CutHandles.Count, 2);
}

// The oracle is the surface itself: its volume before and after, as marching tetrahedra make it.
TEST(TopologyRepair, ReportsExactVolumes)
{
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const auto porous = [&](const Vector3& p) { return part(random) < 0.02 ? -0.25 : DentedRing(p); };
  palpate::ShapeField field = Sampled(13.0, Spacing, porous);
  palpate::IndexedMesh before;
  palpate::IndexedMesh after;
  ASSERT_TRUE(palpate::MarchTetrahedra(field, before).IsOk());
  palpate::TopologyReport report;
  ASSERT_TRUE(palpate::RepairTopology(field, {}, report).IsOk());
  ASSERT_TRUE(palpate::MarchTetrahedra(field, after).IsOk());
  ASSERT_GT(report.CutHandles.Volume, 0.0);
  ASSERT_GT(report.FilledCavities.Volume + report.FilledHandles.Volume, 0.0);
  // Single precision of the fields' values.
  EXPECT_NEAR(VolumeOf(after) - VolumeOf(before), report.AddedVolume(), 1e-4 * VolumeOf(before));
  EXPECT_NEAR(report.ObjectVolume, VolumeOf(before), 1e-4 * VolumeOf(before));
}

TEST(TopologyRepair, DropsSmallPartsAndSaysWhere)
{
  const Vector3 place(8.0, 0.0, 0.0);
  palpate::ShapeField field =
      Sampled(11.0, Spacing,
              [&](const Vector3& p) { return std::max(Sphere(p, 6.0), Sphere(p - place, 1.2)); });
  palpate::TopologyReport report;
  palpate::TopologySettings settings;
  settings.SmallPart = 0.02;
  ASSERT_TRUE(palpate::RepairTopology(field, settings, report).IsOk());
  EXPECT_TRUE(IsBall(field));
  EXPECT_EQ(report.DroppedParts.Count, 1);
  EXPECT_LT((report.DroppedParts.LargestCentre - place).norm(), Spacing);
  // A sphere of 7.24 mm^3 sampled at two nodes a radius, less the rim that it loses to flat faces.
  EXPECT_NEAR(report.DroppedParts.Volume, 6.6, 0.7);
  EXPECT_NEAR(report.AddedVolume(), -report.DroppedParts.Volume, 1e-9);
}

TEST(TopologyRepair, RefusesOrBridgesTwoSpheres)
{
  const Vector3 beside(5.5, 0.0, 0.0);
  const auto twoSpheres = [&](const Vector3& p)
  { return std::max(Sphere(p - beside, 4.0), Sphere(p + beside, 4.0)); };
  palpate::ShapeField field = Sampled(11.0, Spacing, twoSpheres);
  palpate::TopologyReport report;
  palpate::TopologySettings settings;
  settings.BridgeParts = false;
  const palpate::Status refused = palpate::RepairTopology(field, settings, report);
  EXPECT_NE(refused.Message().find("2 separate parts"), std::string::npos) << refused.Message();
  ASSERT_TRUE(palpate::RepairTopology(field, {}, report).IsOk());
  EXPECT_TRUE(IsBall(field));
  EXPECT_EQ(report.Bridges.Count, 1);
  // The spheres are 3 mm apart; the bridge joins nodes inside of them.
  EXPECT_NEAR(report.Bridges.LargestExtent, 3.0, 2.0 * Spacing);
  EXPECT_LT(report.Bridges.LargestCentre.norm(), 2.0 * Spacing);
  // A gap of 3 mm is more than a quarter of the diameter of 10.1 mm that their volume has.
  palpate::TopologyLimits limits;
  EXPECT_FALSE(palpate::CheckTopology(report, limits).IsOk());
  limits.GapShare = 0.5;
  EXPECT_TRUE(palpate::CheckTopology(report, limits).IsOk());
  limits.BridgedGap = 1.0;
  EXPECT_FALSE(palpate::CheckTopology(report, limits).IsOk());
}

// Bridges are found by one search that goes on: each is as cheap as a search of its own finds it.
TEST(TopologyRepair, BridgesRowsOfSpheresByTheirShortestGaps)
{
  const auto spheres = [](const Vector3& p)
  {
    double most = -100.0;
    for (int i = -2; i <= 2; ++i)
    {
      most = std::max(most, Sphere(p - Vector3(6.0 * i, 0.3 * i * i, 0.0), 2.2));
    }
    return most;
  };
  palpate::ShapeField field = Sampled(16.0, Spacing, spheres);
  palpate::TopologyReport report;
  ASSERT_TRUE(palpate::RepairTopology(field, {}, report).IsOk());
  EXPECT_TRUE(IsBall(field));
  EXPECT_EQ(report.Bridges.Count, 4);
  // The widest gap is that of the outer ones.
  EXPECT_NEAR(report.Bridges.LargestExtent, std::hypot(6.0, 0.9) - 4.4, 2.0 * Spacing);
}

// Two rods side by side that are thick at the origin. A bump a third of a spacing high at one end,
// as noise makes them, is where they are nearest.
TEST(TopologyRepair, BridgesWhereMostOfTheObjectIs)
{
  const auto rods = [](const Vector3& p)
  {
    const double side = std::abs(p[1]) - 3.0;
    const double bump = (p - Vector3(12.0, 2.0, 0.0)).norm() < 1.5 ? 0.2 : 0.0;
    const double thick = 1.5 + 1.5 * std::exp(-p[0] * p[0] / 16.0);
    const double across = std::hypot(std::max(0.0, side), p[2]);
    const double rod = side < 0.0 ? std::min(thick - std::abs(p[2]), 1.5 + side) : thick - across;
    return std::min(rod + bump, 14.0 - std::abs(p[0]));
  };
  palpate::ShapeField field = Sampled(17.0, Spacing, rods);
  palpate::TopologyReport report;
  ASSERT_TRUE(palpate::RepairTopology(field, {}, report).IsOk());
  EXPECT_TRUE(IsBall(field));
  EXPECT_EQ(report.Bridges.Count, 1);
  EXPECT_NEAR(report.Bridges.LargestCentre[0], 0.0, 4.0) << "the thick part is 8 mm long";
}

TEST(TopologyRepair, FillsCavityAndLimitsNameIt)
{
  const Vector3 place(1.0, 0.0, 2.0);
  palpate::ShapeField field =
      Sampled(9.0, Spacing,
              [&](const Vector3& p) { return std::min(Sphere(p, 8.0), -Sphere(p - place, 3.5)); });
  palpate::TopologyReport report;
  ASSERT_TRUE(palpate::RepairTopology(field, {}, report).IsOk());
  EXPECT_TRUE(IsBall(field));
  EXPECT_EQ(report.FilledCavities.Count, 1);
  const double volume = 4.0 / 3.0 * std::acos(-1.0) * 3.5 * 3.5 * 3.5;
  EXPECT_NEAR(report.FilledCavities.Volume, volume, 0.05 * volume);
  EXPECT_LT((report.FilledCavities.LargestCentre - place).norm(), 0.1 * Spacing);
  EXPECT_NEAR(report.FilledCavities.LargestExtent, 7.0 * std::sqrt(3.0), 2.0 * Spacing);
  const palpate::Status status = palpate::CheckTopology(report, {});
  EXPECT_NE(status.Message().find("cavity"), std::string::npos) << status.Message();
}

TEST(TopologyReport, CavityLimitIsOneOfVolume)
{
  palpate::TopologyReport report;
  report.ObjectVolume = 16000.0;
  // A crack between slices, as in a patient's mask: long, but of 30 mm^3.
  report.FilledCavities = {1, 30.0, 30.0, Vector3::Zero(), 7.3};
  EXPECT_TRUE(palpate::CheckTopology(report, {}).IsOk());
  report.FilledCavities = {1, 66.0, 66.0, Vector3::Zero(), 7.3}; // a sphere of 5 mm has 65.4
  EXPECT_FALSE(palpate::CheckTopology(report, {}).IsOk());
}

TEST(TopologyRepair, MakesBallOfEverySponge)
{
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (const double voids : {0.03, 0.25, 0.6})
  {
    palpate::ShapeField field = Sampled(
        8.0, 0.5, [&](const Vector3& p) { return part(random) < voids ? -0.25 : Sphere(p, 7.0); });
    palpate::TopologyReport report;
    ASSERT_TRUE(palpate::RepairTopology(field, {}, report).IsOk());
    EXPECT_TRUE(IsBall(field)) << voids;
    // Nodes slightly outside amid deep ones are far less than their share of the volume.
    EXPECT_EQ(palpate::CheckTopology(report, {}).IsOk(), voids < 0.1) << report.ChangedPercent();
  }
}

// The triangulation's diagonals keep their direction when all axes are reversed or two of them
// swapped, but not when one is mirrored: which nodes of a wall change may differ, not what is
// found.
TEST(TopologyRepair, ReportsSameChangesOnTurnedAxes)
{
  palpate::ShapeField field = Sampled(13.0, Spacing, DentedRing);
  palpate::TopologyReport report;
  ASSERT_TRUE(palpate::RepairTopology(field, {}, report).IsOk());
  const auto check = [&](const char* name, const auto& turn)
  {
    palpate::ShapeField turned =
        Sampled(13.0, Spacing, [&](const Vector3& p) { return DentedRing(turn(p)); });
    palpate::TopologyReport other;
    ASSERT_TRUE(palpate::RepairTopology(turned, {}, other).IsOk());
    EXPECT_TRUE(IsBall(turned)) << name;
    EXPECT_EQ(other.CutHandles.Count, report.CutHandles.Count) << name;
    EXPECT_EQ(other.FilledHandles.Count, report.FilledHandles.Count) << name;
    EXPECT_NEAR(other.CutHandles.Volume, report.CutHandles.Volume, 0.4 * report.CutHandles.Volume)
        << name;
    EXPECT_LT((turn(other.CutHandles.LargestCentre) - report.CutHandles.LargestCentre).norm(),
              2.0 * Spacing)
        << name;
  };
  check("mirrored", [](const Vector3& p) { return Vector3(-p[0], p[1], p[2]); });
  check("reversed", [](const Vector3& p) { return Vector3(-p); });
  check("swapped", [](const Vector3& p) { return Vector3(p[1], p[0], p[2]); });
  check("cycled", [](const Vector3& p) { return Vector3(p[2], p[0], p[1]); });
}

TEST(TopologyRepair, RejectsBadSettingsAndEmptyObjects)
{
  palpate::TopologyReport report;
  palpate::ShapeField field = Sampled(3.0, 1.0, [](const Vector3& p) { return -1.0; });
  EXPECT_FALSE(palpate::RepairTopology(field, {}, report).IsOk());
  field = Sampled(3.0, 1.0, [](const Vector3& p) { return Sphere(p, 2.0); });
  palpate::TopologySettings settings;
  settings.SmallPart = 1.0;
  EXPECT_FALSE(palpate::RepairTopology(field, settings, report).IsOk());
}
} // namespace
} // namespace palpate::topology_repair_test
