#include "MaskOverlap.h"

#include "Bodies.h"
#include "LabelImages.h"
#include "MeshConversion.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::mask_overlap_test
{
namespace
{
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
  const auto sphere = palpate::ToIndexedMesh(MakeSphere(radius, Vector3::Zero(), 40));
  return palpate::OverlapOfSurfaceAndMask(sphere, Block(), 1).Dice();
}

// Against the definition, on an oblique left-handed grid: voxel by voxel.
TEST(MaskOverlap, CountsExactlyTheCentresInside)
{
  std::mt19937_64 random(5);
  palpate::test::LabelGrid grid;
  grid.Size = {23, 17, 9};
  grid.Spacing = {0.7, 0.9, 2.1};
  grid.Direction = palpate::test::RandomRotation(random);
  for (std::size_t row = 0; row < 3; ++row)
  {
    grid.Direction[3 * row] = -grid.Direction[3 * row];
  }
  grid.CenterOnOrigin();
  const auto isLabel = [](double x, double y, double z)
  { return std::abs(x) + std::abs(y) + std::abs(z) < 7.3; };
  const auto mask = palpate::test::MakeLabelImage(grid, isLabel);
  const auto sphere =
      palpate::ToIndexedMesh(MakeSphere(6.5, Vector3(1.1, -0.4, 0.3), 60)); // facets within 0.1 um
  const palpate::WindingOverlap found = palpate::OverlapOfSurfaceAndMask(sphere, mask, 1);
  palpate::WindingOverlap expected;
  for (vtkIdType id = 0; id < mask->GetNumberOfPoints(); ++id)
  {
    Vector3 world;
    int index[3];
    mask->GetDimensions(index);
    const std::array<int, 3> size{index[0], index[1], index[2]};
    const auto n = static_cast<int>(id);
    mask->TransformIndexToPhysicalPoint(n % size[0], n / size[0] % size[1], n / size[0] / size[1],
                                        world.data());
    const bool isInside = (world - Vector3(1.1, -0.4, 0.3)).norm() < 6.5;
    const bool isInMask = isLabel(world.x(), world.y(), world.z());
    expected.Inside += isInside ? 1 : 0;
    expected.Mask += isInMask ? 1 : 0;
    expected.Both += isInside && isInMask ? 1 : 0;
  }
  EXPECT_EQ(found.Inside, expected.Inside);
  EXPECT_EQ(found.Mask, expected.Mask);
  EXPECT_EQ(found.Both, expected.Both);
  EXPECT_EQ(found.Irregular, 0);
}

// A sphere twice counts as one; its winding number is reported.
TEST(MaskOverlap, CountsOverlappingPartsOnce)
{
  palpate::IndexedMesh twice = palpate::ToIndexedMesh(MakeSphere(6.0, Vector3::Zero(), 20));
  const auto once = palpate::OverlapOfSurfaceAndMask(twice, Block(), 1);
  const auto count = static_cast<int>(twice.Points.size());
  const std::vector<std::array<int, 3>> triangles = twice.Triangles;
  twice.Points.reserve(2 * twice.Points.size());
  twice.Points.insert(twice.Points.end(), twice.Points.begin(), twice.Points.end());
  for (const auto& [a, b, c] : triangles)
  {
    twice.Triangles.push_back({a + count, b + count, c + count});
  }
  const auto both = palpate::OverlapOfSurfaceAndMask(twice, Block(), 1);
  EXPECT_EQ(both.Inside, once.Inside);
  EXPECT_EQ(both.Dice(), once.Dice());
  EXPECT_EQ(both.Irregular, once.Inside);
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
  EXPECT_EQ(palpate::OverlapOfSurfaceAndMask(palpate::ToIndexedMesh(sphere), Block(), 1).Dice(),
            0.0);
}
} // namespace
} // namespace palpate::mask_overlap_test
