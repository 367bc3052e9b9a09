#include "MaskOverlap.h"

#include "Bodies.h"
#include "LabelImages.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace
{
using palpate::Vector3;
using palpate::test::MakeSphere;

constexpr double VoxelCount = 8000.0;

// A block of 20 x 20 x 20 labelled voxels (1 mm), centred at the origin.
vtkSmartPointer<vtkImageData> Block()
{
  palpate::test::LabelGrid grid;
  grid.Size = {20, 20, 20};
  grid.CenterOnOrigin();
  return palpate::test::MakeLabelImage(grid, [](double, double, double) { return true; });
}

double DiceOfSphere(double radius)
{
  return palpate::DiceOfSurfaceAndMask(MakeSphere(radius, Vector3::Zero(), 40), Block(), 1);
}

TEST(MaskOverlap, CountsVoxelsBeyondTheBorder)
{
  const double volume = 4.0 / 3.0 * M_PI * std::pow(25.0, 3);
  // Facets of frequency 40 and the boundary voxels: a thousandth of the volume.
  EXPECT_NEAR(DiceOfSphere(25.0), 2.0 * VoxelCount / (VoxelCount + volume), 1e-3);
}

TEST(MaskOverlap, CountsVolumeFarBeyondTheBorder)
{
  const double volume = 4.0 / 3.0 * M_PI * std::pow(200.0, 3);
  const double dice = 2.0 * VoxelCount / (VoxelCount + volume);
  EXPECT_NEAR(DiceOfSphere(200.0), dice, 2e-3 * dice);
}

// A list of its rows would take terabytes, and its bounds exceed int.
TEST(MaskOverlap, MemoryIsIndependentOfSurfaceBounds)
{
  double dice = -1.0;
  ASSERT_NO_THROW(dice = DiceOfSphere(1e7));
  EXPECT_GE(dice, 0.0);
  EXPECT_LT(dice, 1e-12);
  ASSERT_NO_THROW(dice = DiceOfSphere(1e12));
  EXPECT_LT(dice, 1e-12);
}

TEST(MaskOverlap, IsZeroForNonFiniteSurface)
{
  const auto sphere = MakeSphere(8.0, Vector3::Zero());
  sphere->GetPoints()->SetPoint(3, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  EXPECT_EQ(palpate::DiceOfSurfaceAndMask(sphere, Block(), 1), 0.0);
}
} // namespace
