#include "IsoSurface.h"

#include "MeshTopology.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::iso_surface_test
{
namespace
{
// Radius minus the distance from the grid's centre, mm; steps of 0.5 mm.
palpate::ScalarGrid SphereField(double radius)
{
  palpate::ScalarGrid grid;
  grid.Size = {41, 41, 41};
  grid.Spacing = {0.5, 0.5, 0.5};
  grid.StepIndex = {1.0, 1.0, 1.0};
  for (int k = 0; k < 41; ++k)
  {
    for (int j = 0; j < 41; ++j)
    {
      for (int i = 0; i < 41; ++i)
      {
        grid.Values.push_back(
            static_cast<float>(radius - 0.5 * std::sqrt((i - 20) * (i - 20) + (j - 20) * (j - 20) +
                                                        (k - 20) * (k - 20))));
      }
    }
  }
  return grid;
}

TEST(IsoSurface, SphereHasItsVolumeAndArea)
{
  palpate::ScalarGrid grid = SphereField(7.0);
  const auto surface =
      palpate::ExtractIsoSurface(grid, 0.0f, palpate::SurfacePieces::Largest).Surface;
  const palpate::EnclosedMeasure measure = palpate::MeasureEnclosed(surface);
  // Flat triangles of side h cut off about h^2 / (8 r^2) of the radius: 0.06 %, three times as much
  // of the volume.
  EXPECT_NEAR(measure.Volume, 4.0 / 3.0 * M_PI * 343.0, 4e-3 * 1437.0);
  EXPECT_NEAR(measure.Area, 4.0 * M_PI * 49.0, 4e-3 * 616.0);
}

TEST(IsoSurface, SamplesOnTheLevelYieldManifold)
{
  // Radius 7 mm is 14 steps: the poles, and many Pythagorean points, lie exactly on the level.
  palpate::ScalarGrid grid = SphereField(7.0);
  const auto surface =
      palpate::ExtractIsoSurface(grid, 0.0f, palpate::SurfacePieces::Largest).Surface;
  EXPECT_EQ(palpate::test::TopologyFault(surface), "");
}

TEST(IsoSurface, FindsLevelOfGivenVolume)
{
  palpate::ScalarGrid grid = SphereField(7.0);
  const double wanted = 4.0 / 3.0 * M_PI * 512.0; // of radius 8
  const palpate::IsoSurface found =
      palpate::ExtractIsoSurfaceOfVolume(grid, wanted, palpate::SurfacePieces::Largest);
  EXPECT_NEAR(palpate::MeasureEnclosed(found.Surface).Volume, wanted, 1e-3 * wanted);
  EXPECT_NEAR(found.Level, -1.0, 0.02); // the distance by which the sphere has to grow
}

TEST(IsoSurface, KeepsLargestPieceAndCountsAll)
{
  palpate::ScalarGrid grid = SphereField(5.0);
  grid.Values[0] = 1.0f; // a corner sticks out: a second, open piece
  grid.Values[2 + 41 * (2 + 41 * 2)] = 1.0f;
  const palpate::IsoSurface largest =
      palpate::ExtractIsoSurface(grid, 0.0f, palpate::SurfacePieces::Largest);
  EXPECT_EQ(largest.PieceCount, 3);
  EXPECT_NEAR(palpate::MeasureEnclosed(largest.Surface).Volume, 4.0 / 3.0 * M_PI * 125.0, 5.0);
  const palpate::IsoSurface all =
      palpate::ExtractIsoSurface(grid, 0.0f, palpate::SurfacePieces::All);
  EXPECT_GT(all.Surface->GetNumberOfPolys(), largest.Surface->GetNumberOfPolys());
}

TEST(IsoSurface, ReversingNegatesVolume)
{
  palpate::ScalarGrid grid = SphereField(5.0);
  const auto surface =
      palpate::ExtractIsoSurface(grid, 0.0f, palpate::SurfacePieces::Largest).Surface;
  const double volume = palpate::MeasureEnclosed(surface).Volume;
  EXPECT_GT(volume, 0.0);
  palpate::ReverseTriangles(surface);
  EXPECT_DOUBLE_EQ(palpate::MeasureEnclosed(surface).Volume, -volume);
}
} // namespace
} // namespace palpate::iso_surface_test
