#include "PlaneSampler.h"

#include "LabelImages.h"
#include "RandomOrientation.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace palpate::plane_sampler_test
{
namespace
{
constexpr float Outside = -7.0F;

// Arbitrary numbers on an arbitrary grid and extent.
template <typename T>
vtkSmartPointer<vtkImageData> RandomImage(std::mt19937_64& random)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(-3, 9, 2, 12, 5, 12);
  image->SetSpacing(0.9, 1.3, 2.1);
  image->SetOrigin(4.0, -9.0, 30.0);
  image->SetDirectionMatrix(palpate::test::RandomRotation(random).data());
  image->AllocateScalars(vtkTypeTraits<T>::VTKTypeID(), 1);
  auto* values = static_cast<T*>(image->GetScalarPointer());
  std::generate_n(values, image->GetNumberOfPoints(),
                  [&random] { return static_cast<T>(random() % 200); });
  return image;
}

// A plane through the image that extends beyond it on all sides.
PixelGrid RandomGrid(vtkImageData* image, std::mt19937_64& random)
{
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const palpate::Matrix3 turn = palpate::test::RandomOrientation(random);
  const Vector3 middle = ImageAxes(image).ToWorld(
      Vector3(3.0, 7.0, 8.5) + 3.0 * Vector3(unit(random), unit(random), unit(random)));
  PixelGrid grid;
  grid.Width = 60;
  grid.Height = 50;
  grid.ColumnWorld = 0.47 * turn.col(0);
  grid.RowWorld = 0.53 * turn.col(1);
  grid.FirstWorld = middle - 30.0 * grid.ColumnWorld - 25.0 * grid.RowWorld;
  return grid;
}

double Voxel(vtkImageData* image, const Eigen::Vector3i& index)
{
  return image->GetScalarComponentAsDouble(index.x(), index.y(), index.z(), 0);
}

// Reference: eight voxels with their weights.
double InterpolateSlowly(vtkImageData* image, const Vector3& world)
{
  const ImageAxes axes(image);
  Vector3 index = axes.ToIndex(world);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = axes.Extent[2 * axis];
    const double high = axes.Extent[2 * axis + 1];
    if (index[axis] < low - 0.5 || index[axis] > high + 0.5)
    {
      return std::nan("");
    }
    index[axis] = std::clamp(index[axis], low, high);
  }
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    Eigen::Vector3i at;
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isHigh = (corner >> axis & 1) != 0;
      const double share = index[axis] - std::floor(index[axis]);
      at[axis] = static_cast<int>(std::floor(index[axis])) + (isHigh ? 1 : 0);
      weight *= isHigh ? share : 1.0 - share;
    }
    sum += weight > 0.0 ? weight * Voxel(image, at) : 0.0;
  }
  return sum;
}

template <typename T>
class PlaneSamplerOf : public testing::Test
{
};
using Types = testing::Types<unsigned char, short, float, double>;
TYPED_TEST_SUITE(PlaneSamplerOf, Types);

// Compares every row with the reference; adds the pixels inside the image to `inside`.
void ExpectInterpolated(vtkImageData* image, const PixelGrid& grid, int& inside)
{
  const PlaneSampler sampler(image, grid);
  std::vector<float> row(static_cast<std::size_t>(grid.Width));
  for (int r = 0; r < grid.Height; ++r)
  {
    sampler.SampleLinear(r, row.data());
    for (int c = 0; c < grid.Width; ++c)
    {
      const double expected = InterpolateSlowly(image, grid.PixelWorld(c, r));
      const float value = row[static_cast<std::size_t>(c)];
      ASSERT_EQ(std::isnan(value), std::isnan(expected)) << c << ", " << r;
      if (!std::isnan(expected))
      {
        // Single precision of numbers up to 200 over three interpolations.
        ASSERT_NEAR(value, expected, 2e-4) << c << ", " << r;
        ++inside;
      }
    }
  }
}

TYPED_TEST(PlaneSamplerOf, LinearRowsInterpolateEightVoxels)
{
  std::mt19937_64 random(11);
  int inside = 0;
  for (int trial = 0; trial < 20; ++trial)
  {
    const auto image = RandomImage<TypeParam>(random);
    ExpectInterpolated(image, RandomGrid(image, random), inside);
  }
  EXPECT_GT(inside, 5000);
}

TYPED_TEST(PlaneSamplerOf, LinearRowsAlongEachAxisInterpolateEightVoxelsBothWays)
{
  std::mt19937_64 random(14);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double step : {0.3, -0.3, 0.97, -1.0, 1.7, -2.4}) // voxels a column
    {
      const auto image = RandomImage<TypeParam>(random);
      const ImageAxes axes(image);
      PixelGrid grid;
      grid.Width = static_cast<int>(20.0 / std::abs(step));
      grid.Height = 14;
      grid.ColumnWorld = step * axes.StepWorld.col(axis);
      grid.RowWorld = 0.9 * axes.StepWorld.col((axis + 1) % 3);
      const Vector3 middle =
          Vector3(3.0, 7.0, 8.5) + Vector3(unit(random), unit(random), unit(random));
      grid.FirstWorld =
          axes.ToWorld(middle) - 0.5 * grid.Width * grid.ColumnWorld - 7.0 * grid.RowWorld;
      int inside = 0;
      ExpectInterpolated(image, grid, inside);
      EXPECT_GT(inside, 20) << axis << ", " << step;
    }
  }
}

TYPED_TEST(PlaneSamplerOf, NearestRowsUseVoxelAtPoint)
{
  std::mt19937_64 random(12);
  for (int trial = 0; trial < 20; ++trial)
  {
    const auto image = RandomImage<TypeParam>(random);
    const ImageAxes axes(image);
    const PixelGrid grid = RandomGrid(image, random);
    const PlaneSampler sampler(image, grid);
    std::vector<float> row(static_cast<std::size_t>(grid.Width));
    for (int r = 0; r < grid.Height; ++r)
    {
      sampler.SampleNearest(r, Outside, row.data());
      for (int c = 0; c < grid.Width; ++c)
      {
        const Vector3 index = axes.ToIndex(grid.PixelWorld(c, r));
        const Eigen::Vector3i voxel = index.array().round().matrix().template cast<int>();
        bool isInside = true;
        for (int axis = 0; axis < 3; ++axis)
        {
          isInside = isInside && voxel[axis] >= axes.Extent[2 * axis] &&
                     voxel[axis] <= axes.Extent[2 * axis + 1];
        }
        ASSERT_EQ(row[static_cast<std::size_t>(c)],
                  isInside ? static_cast<float>(Voxel(image, voxel)) : Outside);
      }
    }
  }
}

TEST(PlaneSampler, RestoresValuesAtVoxelCentres)
{
  std::mt19937_64 random(13);
  const auto image = RandomImage<short>(random);
  const ImageAxes axes(image);
  PixelGrid grid;
  grid.Width = axes.Size(0);
  grid.Height = axes.Size(1);
  grid.FirstWorld = axes.ToWorld(Vector3(-3.0, 2.0, 8.0));
  grid.ColumnWorld = axes.StepWorld.col(0);
  grid.RowWorld = axes.StepWorld.col(1);
  const PlaneSampler sampler(image, grid);
  std::vector<float> row(static_cast<std::size_t>(grid.Width));
  for (int r = 0; r < grid.Height; ++r)
  {
    sampler.SampleLinear(r, row.data());
    for (int c = 0; c < grid.Width; ++c)
    {
      // Indices are rounded to 1e-14, and neighbours differ by up to 200.
      ASSERT_NEAR(row[static_cast<std::size_t>(c)], Voxel(image, {c - 3, r + 2, 8}), 1e-4);
    }
  }
}

TEST(PlaneSampler, SingleSliceExtendsHalfAVoxelToBothSides)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 1);
  image->SetSpacing(1.0, 1.0, 3.0);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 16,
              static_cast<unsigned char>(9));
  for (const double height : {-1.4, 0.0, 1.4, 1.6})
  {
    const PixelGrid grid{Vector3(1.0, 1.0, height), Vector3::UnitX(), Vector3::UnitY(), 1, 1};
    float value = 0.0F;
    PlaneSampler(image, grid).SampleLinear(0, &value);
    EXPECT_EQ(std::isnan(value), height > 1.5);
    EXPECT_TRUE(height > 1.5 || value == 9.0F);
  }
}
} // namespace
} // namespace palpate::plane_sampler_test
