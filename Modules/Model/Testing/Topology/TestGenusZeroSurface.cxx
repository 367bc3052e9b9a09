#include "GenusZeroSurface.h"
#include "TopologyPhantoms.h"

#include <gtest/gtest.h>
#include <random>

namespace palpate::genus_zero_surface_test
{
namespace
{
using namespace palpate::phantoms;

// Makes the surface and checks what holds for every mask that is not refused.
palpate::GenusZeroSurface SurfaceOf(const palpate::VoxelMask& mask,
                                    const palpate::GenusZeroSettings& settings = {})
{
  palpate::GenusZeroSurface surface;
  const palpate::Status status = palpate::MakeGenusZeroSurface(mask, settings, {}, surface);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  EXPECT_TRUE(IsClosedManifold(surface.Mesh));
  EXPECT_EQ(EulerOf(surface.Mesh), 2);
  EXPECT_GT(VolumeOf(surface.Mesh), 0.0);
  return surface;
}

double VolumeError(const palpate::GenusZeroSurface& surface)
{
  return std::abs(VolumeOf(surface.Mesh) / surface.TargetVolume() - 1.0);
}

bool IsInBall(int i, int j, int k, double centre, double radius)
{
  return std::hypot(i - centre, j - centre, k - centre) < radius;
}

TEST(GenusZeroSurface, KeepsVolumeAndPlaceOfBoxesRodsAndSheets)
{
  const std::array<std::array<int, 3>, 7> sizes{
      {{1, 1, 1}, {6, 7, 8}, {60, 1, 1}, {1, 40, 1}, {40, 40, 1}, {1, 30, 30}, {40, 4, 4}}};
  for (const std::array<int, 3>& size : sizes)
  {
    const palpate::VoxelMask mask =
        MaskOf(size, {0.8, 0.8, 0.8}, [](int i, int j, int k) { return true; });
    const palpate::GenusZeroSurface surface = SurfaceOf(mask);
    EXPECT_LT(VolumeError(surface), 0.003) << size[0] << ' ' << size[1] << ' ' << size[2];
    EXPECT_EQ(surface.Topology.ChangedVolume(), 0.0);
    EXPECT_TRUE(surface.Lost.empty());
    Vector3 low = surface.Mesh.Points.front();
    Vector3 high = low;
    for (const Vector3& point : surface.Mesh.Points)
    {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    const Vector3 centre(0.4 * (size[0] - 1), 0.4 * (size[1] - 1), 0.4 * (size[2] - 1));
    EXPECT_LT((0.5 * (low + high) - centre).norm(), 0.1 * surface.Field.Grid.Spacing);
  }
}

TEST(GenusZeroSurface, AcceptsExtremeSpacings)
{
  const auto isInside = [](int i, int j, int k)
  {
    return std::hypot(i - 12.0, j - 12.0) < 11.0 - k &&
           std::hypot(i - 12.0, j - 12.0) > 2.0 * k - 8.0;
  };
  for (const std::array<double, 3>& spacing :
       {std::array<double, 3>{0.25, 0.25, 3.0}, std::array<double, 3>{0.01, 0.01, 10.0},
        std::array<double, 3>{1000.0, 1.0, 1.0}, std::array<double, 3>{3.0, 3.0, 0.5}})
  {
    const palpate::GenusZeroSurface surface = SurfaceOf(MaskOf({25, 25, 6}, spacing, isInside));
    // The grid's spacing is limited by area: the longest one is only some nodes thick.
    EXPECT_LT(VolumeError(surface), 0.06) << spacing[0] << ' ' << spacing[2];
  }
}

TEST(GenusZeroSurface, CutsRingOfVoxels)
{
  const palpate::GenusZeroSurface surface =
      SurfaceOf(MaskOf({40, 40, 12}, {1.0, 1.0, 1.0},
                       [](int i, int j, int k)
                       { return Ring(Vector3(i - 19.5, j - 19.5, k - 5.5), 14.0, 4.5) > 0.0; }));
  EXPECT_EQ(surface.Topology.CutHandles.Count, 1);
  EXPECT_LT(surface.Topology.ChangedPercent(), 2.0);
  EXPECT_LT(VolumeError(surface), 0.003);
}

TEST(GenusZeroSurface, FillsHollowBallAndReportsIt)
{
  const palpate::GenusZeroSurface surface =
      SurfaceOf(MaskOf({24, 24, 24}, {1.0, 1.0, 1.0},
                       [](int i, int j, int k)
                       { return IsInBall(i, j, k, 11.5, 11.0) && !IsInBall(i, j, k, 11.5, 6.0); }));
  EXPECT_EQ(surface.Topology.FilledCavities.Count, 1);
  EXPECT_GT(surface.Topology.ChangedPercent(), 10.0);
  EXPECT_FALSE(palpate::CheckTopology(surface.Topology, {}).IsOk());
  // The cavity's volume counts nodes.
  EXPECT_LT(VolumeError(surface), 0.01);
}

TEST(GenusZeroSurface, RefusesTwoBallsUnlessBridged)
{
  const palpate::VoxelMask mask =
      MaskOf({40, 18, 18}, {1.0, 1.0, 1.0},
             [](int i, int j, int k)
             { return IsInBall(i, j, k, 8.5, 8.0) || IsInBall(i - 22, j, k, 8.5, 8.0); });
  palpate::GenusZeroSurface surface;
  palpate::GenusZeroSettings settings;
  settings.Topology.BridgeParts = false;
  EXPECT_FALSE(palpate::MakeGenusZeroSurface(mask, settings, {}, surface).IsOk());
  surface = SurfaceOf(mask);
  EXPECT_EQ(surface.Topology.Bridges.Count, 1);
  EXPECT_FALSE(palpate::CheckTopology(surface.Topology, {}).IsOk()); // a gap of 6 mm
}

TEST(GenusZeroSurface, MakesSurfaceOfEverySpongeAndSaysHowMuchChanged)
{
  std::mt19937_64 random(5);
  for (const unsigned voids : {3u, 25u})
  {
    // Interpolated between its neighbours, a void of one voxel is left with a sixth of its volume.
    const double least = 0.1 * voids;
    const palpate::GenusZeroSurface surface =
        SurfaceOf(MaskOf({22, 22, 22}, {1.0, 1.0, 1.0},
                         [&](int i, int j, int k)
                         { return IsInBall(i, j, k, 10.5, 10.0) && random() % 100 >= voids; }));
    EXPECT_GT(surface.Topology.ChangedPercent(), least) << voids;
  }
}

// The ball's surface would lie 0.1 mm farther out if it had the volume of the specks, too.
TEST(GenusZeroSurface, HasTheVolumeOfWhatItKeepsWithoutSpecks)
{
  std::mt19937 random(8);
  std::bernoulli_distribution isSpeck(0.01);
  long ball = 0;
  const palpate::VoxelMask mask =
      MaskOf({50, 50, 50}, {1.0, 1.0, 1.0},
             [&](int i, int j, int k)
             {
               const bool isInside = IsInBall(i, j, k, 24.5, 15.0);
               ball += isInside ? 1 : 0;
               return isInside || (isSpeck(random) && !IsInBall(i, j, k, 24.5, 18.0));
             });
  const palpate::GenusZeroSurface surface = SurfaceOf(mask);
  EXPECT_NEAR(VolumeOf(surface.Mesh), static_cast<double>(ball), 0.005 * static_cast<double>(ball));
  EXPECT_GT(surface.Topology.DroppedParts.Count, 100);
  EXPECT_NEAR(surface.Topology.DroppedParts.Volume, surface.MaskVolume - static_cast<double>(ball),
              1e-6);
  EXPECT_GT(surface.Topology.ChangedPercent(), 5.0);
}

// Its pores are finer than the field, and its voxels are no thin parts that are to be restored.
TEST(GenusZeroSurface, DoesNotFillASpongeSilently)
{
  std::mt19937 random(9);
  std::bernoulli_distribution isInside(0.25);
  const palpate::VoxelMask mask =
      MaskOf({60, 60, 60}, {1.0, 1.0, 1.0}, [&](int i, int j, int k) { return isInside(random); });
  palpate::GenusZeroSettings settings;
  settings.Field.CellsOnSurface = 1500;
  palpate::GenusZeroSurface surface;
  const palpate::Status status = palpate::MakeGenusZeroSurface(mask, settings, {}, surface);
  ASSERT_TRUE(status.IsOk()) << status.Message();
  EXPECT_GT(surface.Topology.ChangedPercent(), 2.0);
}

TEST(GenusZeroSurface, KeepsThinEnds)
{
  // A tongue of one pixel on a large body, between the rows of a grid with wide steps.
  const palpate::VoxelMask mask =
      MaskOf({90, 40, 14}, {0.3, 0.3, 3.0},
             [](int i, int j, int k)
             {
               const bool isBody = std::hypot(i - 20.0, j - 20.0) < 19.0 - std::abs(k - 6.5);
               return isBody || (j == 18 && k == 6 && i > 20 && i < 85);
             });
  palpate::GenusZeroSettings settings;
  settings.Field.Spacing = 1.0;
  settings.RestoreThinParts = false;
  const palpate::GenusZeroSurface without = SurfaceOf(mask, settings);
  ASSERT_FALSE(without.Lost.empty());
  EXPECT_FALSE(without.Lost.front().IsSeparate);
  EXPECT_GT(without.Lost.front().Distance, 5.0);
  EXPECT_LT((without.Lost.front().Farthest - Vector3(84 * 0.3, 18 * 0.3, 18.0)).norm(), 1e-9);
  settings.RestoreThinParts = true;
  const palpate::GenusZeroSurface with = SurfaceOf(mask, settings);
  EXPECT_TRUE(with.Lost.empty());
  EXPECT_GT(with.RestoredVolume, 0.0);
  EXPECT_LT(VolumeError(with), 0.01);
}

TEST(GenusZeroSurface, SaysWhenLostVoxelsAreSeparateInMask)
{
  const palpate::VoxelMask mask =
      MaskOf({40, 24, 24}, {1.0, 1.0, 1.0},
             [](int i, int j, int k)
             { return IsInBall(i, j, k, 11.5, 11.0) || (i == 35 && j == 12 && k == 12); });
  const palpate::GenusZeroSurface surface = SurfaceOf(mask);
  ASSERT_EQ(surface.Lost.size(), 1u);
  EXPECT_TRUE(surface.Lost.front().IsSeparate);
  // From the voxel's centre to the ball's surface at 22.5; distances are to vertices.
  EXPECT_NEAR(surface.Lost.front().Distance, 12.6, 0.3);
  EXPECT_EQ(surface.RestoredVolume, 0.0);
}

TEST(GenusZeroSurface, StopsWhenProgressSaysSo)
{
  const palpate::VoxelMask mask =
      MaskOf({4, 4, 4}, {1.0, 1.0, 1.0}, [](int i, int j, int k) { return true; });
  palpate::GenusZeroSurface surface;
  double last = 0.0;
  const auto count = [&](double fraction)
  {
    EXPECT_GE(fraction, last);
    last = fraction;
    return true;
  };
  EXPECT_TRUE(palpate::MakeGenusZeroSurface(mask, {}, count, surface).IsOk());
  EXPECT_EQ(last, 1.0);
  for (int allowed = 0; allowed < 3; ++allowed)
  {
    int calls = 0;
    const auto stop = [&](double fraction) { return calls++ < allowed; };
    EXPECT_FALSE(palpate::MakeGenusZeroSurface(mask, {}, stop, surface).IsOk());
    EXPECT_EQ(calls, allowed + 1);
  }
}

TEST(GenusZeroSurface, RejectsEmptyAndMalformedMasks)
{
  palpate::GenusZeroSurface surface;
  palpate::VoxelMask mask;
  EXPECT_FALSE(palpate::MakeGenusZeroSurface(mask, {}, {}, surface).IsOk());
  mask = MaskOf({4, 4, 4}, {1.0, 1.0, 1.0}, [](int i, int j, int k) { return false; });
  EXPECT_FALSE(palpate::MakeGenusZeroSurface(mask, {}, {}, surface).IsOk());
  mask.Spacing[0] = std::nan("");
  EXPECT_FALSE(palpate::MakeGenusZeroSurface(mask, {}, {}, surface).IsOk());
}
} // namespace
} // namespace palpate::genus_zero_surface_test
