#include "CheckCases.h"
#include "MaskStatistics.h"
#include "PartStatistics.h"
#include "SliceStatistics.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::mask_statistics_test
{
namespace
{
using namespace palpate::test;

const RadialProbe& Probe()
{
  static const RadialProbe probe;
  return probe;
}

MaskStatistics Measured(const CheckedMask& mask)
{
  return MeasureMask(mask, Probe()).Statistics;
}

TEST(MaskStatistics, BallIsUnsuspicious)
{
  const MaskStatistics found = Measured(MakeBall());
  for (const char* key : {"part", "hole", "slice_hole", "gap", "border"})
  {
    EXPECT_EQ(Find(found, key).Value, 0.0) << key;
  }
  EXPECT_LT(Find(found, "neck").Value, 0.2); // steps of voxels make shallow bodies
  EXPECT_LT(Find(found, "rough").Value, 0.03);
  EXPECT_LT(Find(found, "end_superior").Value, 0.3);
}

TEST(MaskStatistics, HoleHasItsShareAndPlace)
{
  const auto isHole = [](const Vector3& at) { return (at - Vector3(24, 20, 20)).norm() <= 5.0; };
  const CheckedMask whole = MakeBall();
  const CheckedMask mask = MakeBall(isHole);
  const auto lost = static_cast<double>(whole.Voxels.Count() - mask.Voxels.Count());
  const MaskStatistics found = Measured(mask);
  EXPECT_DOUBLE_EQ(Find(found, "hole").Value, lost / static_cast<double>(mask.Voxels.Count()));
  EXPECT_DOUBLE_EQ(Find(found, "hole").Amount, 2.0 * lost);
  EXPECT_LT((Find(found, "hole").Place - Vector3(24, 20, 20)).norm(), 1e-9);
  EXPECT_DOUBLE_EQ(Find(found, "slice_hole").Value, Find(found, "hole").Value);
}

TEST(MaskStatistics, OpenChannelIsAHoleInSlicesOnly)
{
  const MaskStatistics found = Measured(
      MakeBall([](const Vector3& at) { return std::hypot(at.x() - 20, at.y() - 20) < 3.0; }));
  EXPECT_EQ(Find(found, "hole").Value, 0.0);
  EXPECT_GT(Find(found, "slice_hole").Value, 0.02);
  EXPECT_NEAR(Find(found, "slice_hole").Place.x(), 20.0, 1e-9);
}

TEST(MaskStatistics, IslandHasItsShareAndPlace)
{
  CheckedMask mask = MakeBall();
  const auto voxels = static_cast<double>(mask.Voxels.Count());
  mask.Voxels.Inside[mask.Voxels.Offset(2, 2, 2)] = 1; // index 1, 1, 1: 1, 1, 2 mm
  const MaskStatistics found = Measured(mask);
  EXPECT_DOUBLE_EQ(Find(found, "part").Value, 1.0 - voxels / (voxels + 1.0));
  EXPECT_DOUBLE_EQ(Find(found, "part").Amount, 2.0);
  EXPECT_LT((Find(found, "part").Place - Vector3(1, 1, 2)).norm(), 1e-12);
}

TEST(MaskStatistics, PartsThatShareACornerAreOne)
{
  CheckedMask mask = MakeMask({4, 4, 4}, {1.0, 1.0, 1.0}, [](const Vector3&) { return false; });
  mask.Voxels.Inside[mask.Voxels.Offset(1, 1, 1)] = 1;
  mask.Voxels.Inside[mask.Voxels.Offset(2, 2, 2)] = 1;
  EXPECT_EQ(Find(Measured(mask), "part").Value, 0.0);
}

TEST(MaskStatistics, MissingSlicesAreCountedBetweenTheirNeighbours)
{
  const MaskStatistics found = Measured(
      MakeBall([](const Vector3& at) { return std::abs(at.z() - 21.0) < 2.0; })); // 20 and 22
  EXPECT_EQ(Find(found, "gap").Amount, 2.0);
  EXPECT_GT(Find(found, "gap").Value, 0.9);
  EXPECT_NEAR(Find(found, "gap").Place.z(), 21.0, 1e-9);
}

TEST(MaskStatistics, FlatEndIsOnTheSideThatWasCut)
{
  const MaskStatistics found =
      Measured(MakeBall([](const Vector3& at) { return at.x() > 28.5; })); // towards the left
  const MaskStatistic end = Find(found, "edge_left");
  EXPECT_NEAR(end.Value, 1.0 - 8.0 * 8.0 / 256.0, 0.03); // a circle at 8 mm of 16, voxels
  EXPECT_NEAR(end.Place.x(), 28.0, 1e-9);
  for (const char* key : {"edge_right", "edge_anterior", "edge_posterior"})
  {
    EXPECT_LT(Find(found, key).Value, 0.2) << key;
  }
}

TEST(MaskStatistics, LastSliceIsAnEnd)
{
  const MaskStatistics found = Measured(MakeBall([](const Vector3& at) { return at.z() > 29.0; }));
  EXPECT_NEAR(Find(found, "end_superior").Value, 1.0 - 8.0 * 8.0 / 256.0, 0.03);
  EXPECT_NEAR(Find(found, "end_superior").Place.z(), 28.0, 1e-9);
  EXPECT_LT(Find(found, "end_inferior").Value, 0.3);
}

TEST(MaskStatistics, CopiedSlicesAreCounted)
{
  CheckedMask mask = MakeBall();
  VoxelMask& voxels = mask.Voxels;
  const std::size_t slice = voxels.Offset(0, 0, 1);
  for (std::size_t k = 3; k + 1 < static_cast<std::size_t>(voxels.Size[2]); k += 2)
  {
    std::copy_n(voxels.Inside.begin() + static_cast<std::ptrdiff_t>(k * slice), slice,
                voxels.Inside.begin() + static_cast<std::ptrdiff_t>((k + 1) * slice));
  }
  EXPECT_LT(Find(Measured(MakeBall()), "copied").Value, 0.2); // the two next to its centre
  EXPECT_GE(Find(Measured(mask), "copied").Value, 0.5);
  EXPECT_EQ(Find(Measured(mask), "copied").Amount, 2.0);
}

TEST(MaskStatistics, JumpLiesBetweenTheSlicesThatDiffer)
{
  const MaskStatistics found = Measured(
      MakeMask({60, 41, 21}, {1.0, 1.0, 2.0},
               [](const Vector3& at)
               { return std::hypot(at.x() - (at.z() < 19.0 ? 20.0 : 32.0), at.y() - 20) < 12.0; }));
  EXPECT_GT(Find(found, "step").Value, 0.8);
  EXPECT_NEAR(Find(found, "step").Place.z(), 19.0, 1e-9);
}

TEST(MaskStatistics, BorderIsTheAreaOfCutFaces)
{
  const CheckedMask mask = MakeMask({10, 10, 10}, {1.0, 2.0, 3.0},
                                    [](const Vector3& at) {
                                      return at.x() < 3.5 && at.y() > 5.0 && at.y() < 9.0 &&
                                             at.z() > 5.0 && at.z() < 13.0;
                                    });
  const MaskStatistic border = Find(Measured(mask), "border");
  EXPECT_DOUBLE_EQ(border.Amount, 2 * 3 * 2.0 * 3.0); // two by three faces of 2 x 3 mm
  EXPECT_NEAR(border.Place.x(), 0.0, 1e-12);
}

TEST(MaskStatistics, BorderHasBothEnds)
{
  const CheckedMask mask =
      MakeMask({10, 10, 10}, {1.0, 2.0, 3.0},
               [](const Vector3& at)
               { return at.x() > 3.5 && at.y() > 5.0 && at.y() < 9.0 && at.z() > 20.0; });
  // Two columns at the left end, two slices' worth of three voxels each; six by two above.
  EXPECT_DOUBLE_EQ(Find(Measured(mask), "border").Amount, 2 * 3 * 2.0 * 3.0 + 6 * 2 * 1.0 * 2.0);
}

TEST(MaskStatistics, BridgeIsThinAndInItsPlace)
{
  const auto isDumbbell = [](const Vector3& at)
  {
    return (at - Vector3(15, 20, 20)).norm() <= 12.0 || (at - Vector3(38, 20, 20)).norm() <= 7.0 ||
           (at.x() > 15 && at.x() < 38 && std::hypot(at.y() - 20, at.z() - 20) < 1.1);
  };
  const MaskStatistic neck =
      Find(Measured(MakeMask({50, 41, 41}, {1.0, 1.0, 1.0}, isDumbbell)), "neck");
  EXPECT_GT(neck.Value, 0.6);
  EXPECT_NEAR(neck.Place.x(), 29.0, 3.0); // between 27 and 31
  EXPECT_LE(neck.Amount, 4.0);
}

TEST(MaskStatistics, AreTheSameWhereverTheSlicesLie)
{
  const auto isInside = [](const Vector3& at)
  {
    return (at - Vector3(20, 20, 20)).norm() <= 16.0 && at.z() < 30.0 &&
           (at - Vector3(22, 19, 20)).norm() > 4.0;
  };
  const MaskStatistics along = Measured(MakeMask({41, 41, 21}, {1.0, 1.0, 2.0}, isInside));
  // The same body in an image whose first axis is the patient's third.
  CheckedMask turned = MakeMask({21, 41, 41}, {2.0, 1.0, 1.0},
                                [&](const Vector3& at) {
                                  return isInside({at.z(), at.y(), at.x()});
                                });
  turned.ToWorld.Axes << 0, 0, 1, 0, 1, 0, 2, 0, 0;
  const MaskStatistics across = Measured(turned);
  ASSERT_EQ(along.size(), across.size());
  for (const MaskStatistic& one : along)
  {
    const MaskStatistic other = Find(across, one.Key);
    EXPECT_NEAR(one.Value, other.Value, 1e-9) << one.Key;
    EXPECT_LT((one.Place - other.Place).norm(), 1e-6) << one.Key;
  }
}

TEST(MaskStatistics, OneVoxelIsMeasured)
{
  const MeasuredMask found =
      MeasureMask(MakeMask({3, 3, 3}, {1.0, 1.0, 1.0},
                           [](const Vector3& at) { return at == Vector3(1, 1, 1); }),
                  Probe());
  EXPECT_DOUBLE_EQ(found.Milliliters, 1e-3);
  for (const MaskStatistic& one : found.Statistics)
  {
    EXPECT_TRUE(std::isfinite(one.Value)) << one.Key;
  }
}

TEST(RadialProbe, OutlineOfABallIsItsRadius)
{
  const RadialOutline outline = MeasureMask(MakeBall(), Probe()).Outline;
  EXPECT_LT((outline.CenterWorld - Vector3(20, 20, 20)).norm(), 1e-9);
  // Y00 = 1 / sqrt(4 pi); half a voxel of the steps is 3 %.
  EXPECT_NEAR(std::exp(outline.Coefficients[0] / std::sqrt(4.0 * 3.14159265)), 16.0, 0.5);
  EXPECT_EQ(outline.Missed, 0.0);
}

TEST(RadialProbe, TellsHowMuchItsCentreMisses)
{
  // Half a shell: its centroid lies outside of it.
  const CheckedMask mask = MakeMask({41, 41, 41}, {1.0, 1.0, 1.0},
                                    [](const Vector3& at)
                                    {
                                      const double r = (at - Vector3(20, 20, 20)).norm();
                                      return r > 14.0 && r < 18.0 && at.z() > 20.0;
                                    });
  const RadialOutline outline = MeasureMask(mask, Probe()).Outline;
  // The centroid is about half of 16 mm above the rim's plane, which it sees under 116.6 degrees.
  EXPECT_NEAR(outline.Missed, 0.5 * (1.0 - 1.0 / std::sqrt(5.0)), 0.02);
}

TEST(CheckedMask, UnionHoldsTheVoxelsOfAll)
{
  const CheckedMask one = MakeBall();
  CheckedMask other = MakeMask({10, 10, 10}, {1.0, 1.0, 2.0},
                               [](const Vector3& at) { return at.x() > 3 && at.z() > 4; });
  other.Voxels.StartIndex = {40, -1, 5};
  const CheckedMask all = UnionOf({one, other});
  EXPECT_EQ(all.Voxels.Count(), one.Voxels.Count() + other.Voxels.Count());
  const double a = static_cast<double>(one.Voxels.Count());
  const double b = static_cast<double>(other.Voxels.Count());
  EXPECT_LT((all.Centroid() - (a * one.Centroid() + b * other.Centroid()) / (a + b)).norm(), 1e-9);
}

TEST(CheckedMask, CoarseMaskKeepsVolumeAndPlace)
{
  const CheckedMask fine = MakeBall();
  const CheckedMask coarse = Coarsened(fine, fine.Voxels.Inside.size() / 3);
  EXPECT_LE(coarse.Voxels.Inside.size(), fine.Voxels.Inside.size() / 3);
  const auto volume = [](const CheckedMask& mask)
  { return static_cast<double>(mask.Voxels.Count()) * mask.Voxels.VoxelVolume(); };
  EXPECT_NEAR(volume(coarse), volume(fine), 0.12 * volume(fine)); // half filled voxels count
  EXPECT_LT((coarse.Centroid() - fine.Centroid()).norm(), 0.5);
}

TEST(CheckedMask, SidesAreThePatients)
{
  EXPECT_EQ(PatientSideOf({0.9, -0.1, 0.3}), 0);  // left
  EXPECT_EQ(PatientSideOf({0.1, -0.9, 0.3}), 3);  // anterior
  EXPECT_EQ(PatientSideOf({0.1, -0.2, -0.3}), 5); // inferior
}
} // namespace
} // namespace palpate::mask_statistics_test
