#include "WindingNumbers.h"

#include "ExactSign.h"
#include "MeshShapes.h"
#include "RandomShapes.h"
#include "SurfaceTopology.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

namespace palpate::winding_numbers_test
{
namespace
{
std::vector<std::int16_t> NumbersOf(const IndexedMesh& mesh, const VoxelCenters& centers)
{
  std::vector<std::int16_t> numbers;
  EXPECT_EQ(FindWindingNumbers(mesh, centers, numbers).Message(), "");
  return numbers;
}

VoxelCenters Cube(int size, double step = 1.0, const Vector3& origin = Vector3::Zero())
{
  return {origin, step * Matrix3::Identity(), {size, size, size}};
}

template <typename Visit>
void ForEachCenter(const VoxelCenters& centers, const Visit& visit)
{
  std::size_t number = 0;
  for (int k = 0; k < centers.Size[2]; ++k)
  {
    for (int j = 0; j < centers.Size[1]; ++j)
    {
      for (int i = 0; i < centers.Size[0]; ++i)
      {
        visit(number++, Vector3(i, j, k));
      }
    }
  }
}

// Integer corners, so that most centres near the surface lie on it.
IndexedMesh Rounded(IndexedMesh mesh)
{
  for (Vector3& p : mesh.Points)
  {
    p = p.array().round();
  }
  return mesh;
}

TEST(WindingNumbers, OfConvexBodyAgreeWithItsPlanes)
{
  const IndexedMesh mesh = test::Sphere(4, 7.3, {8.1, 7.9, 8.2});
  const VoxelCenters centers = Cube(17);
  const std::vector<std::int16_t> numbers = NumbersOf(mesh, centers);
  ForEachCenter(centers,
                [&](std::size_t number, const Vector3& p)
                {
                  bool isInside = true;
                  for (const auto& t : mesh.Triangles)
                  {
                    isInside = isInside && exact::VolumeSign(mesh.Points[t[0]], mesh.Points[t[1]],
                                                             mesh.Points[t[2]], p) < 0;
                  }
                  ASSERT_EQ(numbers[number], isInside ? 1 : 0) << p.transpose();
                });
}

TEST(WindingNumbers, OfBoxOnVoxelCentersAreHalfOpen)
{
  const VoxelCenters centers = Cube(9);
  const std::vector<std::int16_t> numbers = NumbersOf(test::Box({2, 3, 1}, {5, 7, 8}), centers);
  ForEachCenter(centers,
                [&](std::size_t number, const Vector3& p)
                {
                  const bool isInside =
                      p[0] >= 2 && p[0] < 5 && p[1] >= 3 && p[1] < 7 && p[2] >= 1 && p[2] < 8;
                  EXPECT_EQ(numbers[number], isInside ? 1 : 0) << p.transpose();
                });
}

TEST(WindingNumbers, OfBodiesThatShareAFaceCountEachCenterOnce)
{
  const IndexedMesh both =
      test::Join(test::Box({1, 1, 1}, {4, 6, 6}), test::Box({4, 1, 1}, {6, 6, 6}));
  EXPECT_EQ(NumbersOf(both, Cube(8)), NumbersOf(test::Box({1, 1, 1}, {6, 6, 6}), Cube(8)));
}

TEST(WindingNumbers, OfCentersOnSurfaceAreThoseOfCentersMovedALittle)
{
  test::Random random(51);
  for (int i = 0; i < 20; ++i)
  {
    // Self-crossing bodies whose corners are all on voxel centres.
    IndexedMesh mesh = Rounded(test::Sphere(2 + i % 5, 5.0, {6, 6, 6}));
    for (Vector3& p : mesh.Points)
    {
      p[static_cast<int>(random() % 3)] += static_cast<double>(random() % 7) - 3.0;
    }
    const std::vector<std::int16_t> numbers = NumbersOf(mesh, Cube(14));
    // Far above rounding, and each far above the effect of the next.
    EXPECT_EQ(numbers, NumbersOf(mesh, Cube(14, 1.0, {1e-4, 1e-8, 1e-12}))) << i;
    EXPECT_NE(*std::max_element(numbers.begin(), numbers.end()), 0);
  }
}

TEST(WindingNumbers, OfOverlapAreTwoAndInsideOutMinusOne)
{
  const IndexedMesh left = test::Sphere(6, 5.0, {7, 8, 8});
  const IndexedMesh right = test::Sphere(5, 5.0, {10, 8, 8});
  const VoxelCenters centers = Cube(18);
  const std::vector<std::int16_t> inLeft = NumbersOf(left, centers);
  const std::vector<std::int16_t> inRight = NumbersOf(right, centers);
  const std::vector<std::int16_t> sum = NumbersOf(test::Join(left, right), centers);
  const std::vector<std::int16_t> difference =
      NumbersOf(test::Join(left, test::Reversed(right)), centers);
  for (std::size_t i = 0; i < sum.size(); ++i)
  {
    ASSERT_EQ(sum[i], inLeft[i] + inRight[i]);
    ASSERT_EQ(difference[i], inLeft[i] - inRight[i]);
  }
  EXPECT_EQ(*std::max_element(sum.begin(), sum.end()), 2);
  EXPECT_EQ(*std::min_element(difference.begin(), difference.end()), -1);
}

TEST(WindingNumbers, OfNestedSpheresCountShells)
{
  IndexedMesh mesh;
  for (int shell = 1; shell <= 4; ++shell)
  {
    mesh = test::Join(mesh, test::Sphere(8, 2.0 * shell, {9, 9, 9}));
  }
  const VoxelCenters centers = Cube(19);
  const std::vector<std::int16_t> numbers = NumbersOf(mesh, centers);
  ForEachCenter(centers,
                [&](std::size_t number, const Vector3& p)
                {
                  const double radius = (p - Vector3(9, 9, 9)).norm() / 2.0;
                  // The polyhedra are inscribed by up to 2 % of the radius.
                  if (std::abs(radius - std::round(radius)) > 0.1)
                  {
                    EXPECT_EQ(numbers[number], std::max(0, 4 - static_cast<int>(radius)));
                  }
                });
}

TEST(WindingNumbers, DoNotDependOnAxes)
{
  const IndexedMesh mesh = test::Lobed(12);
  const VoxelCenters centers = Cube(30, 2.0, {-30.1, -30.2, -30.3});
  const std::vector<std::int16_t> numbers = NumbersOf(mesh, centers);
  // The same centres with i and k exchanged and j reversed: left- and right-handed.
  VoxelCenters other = centers;
  other.Origin += 29 * centers.Axes.col(1);
  other.Axes.col(0) = centers.Axes.col(2);
  other.Axes.col(1) = -centers.Axes.col(1);
  other.Axes.col(2) = centers.Axes.col(0);
  for (const int sign : {1, -1})
  {
    other.Axes.col(1) *= sign;
    other.Origin = centers.Origin + (sign > 0 ? 29 : 0) * centers.Axes.col(1);
    const std::vector<std::int16_t> turned = NumbersOf(mesh, other);
    ForEachCenter(centers,
                  [&](std::size_t number, const Vector3& p)
                  {
                    const int i = static_cast<int>(p[0]);
                    const int j = static_cast<int>(sign > 0 ? 29 - p[1] : p[1]);
                    const int k = static_cast<int>(p[2]);
                    ASSERT_EQ(turned[(static_cast<std::size_t>(i) * 30 + j) * 30 + k],
                              numbers[number]);
                  });
  }
}

TEST(WindingNumbers, OnObliqueAxesSumToVolume)
{
  const IndexedMesh mesh = test::Lobed(16);
  VoxelCenters centers;
  centers.Axes << 0.6, 0.1, 0.3, -0.2, 0.7, 0.1, 0.1, 0.05, 0.9;
  centers.Size = {150, 150, 120};
  centers.Origin = -centers.Axes * Vector3(75, 75, 60);
  const std::vector<std::int16_t> numbers = NumbersOf(mesh, centers);
  const double volume =
      centers.Axes.determinant() * std::accumulate(numbers.begin(), numbers.end(), 0);
  // Counting lattice points in a smooth body: some 0.1 % with 100,000 of them.
  EXPECT_NEAR(volume / DescribeTopology(mesh).Volume, 1.0, 1e-3);
}

TEST(WindingNumbers, CountPartsOutsideTheGrid)
{
  // The grid is in the middle of the body and sees no surface.
  const std::vector<std::int16_t> numbers = NumbersOf(test::Sphere(5, 1000.0), Cube(7));
  EXPECT_EQ(std::count(numbers.begin(), numbers.end(), 1), 343);
  const std::vector<std::int16_t> beyond = NumbersOf(test::Sphere(5, 1e14, {2e14, 0, 0}), Cube(7));
  EXPECT_EQ(std::count(beyond.begin(), beyond.end(), 0), 343);
}

TEST(WindingNumbers, GiveDiceAndIrregularVoxels)
{
  const std::vector<std::int16_t> numbers{0, 1, 1, 2, -1, 0};
  const std::vector<std::uint8_t> mask{0, 1, 0, 1, 255, 1};
  const WindingOverlap overlap = CompareWithMask(numbers, mask.data());
  EXPECT_EQ(overlap.Inside, 3);
  EXPECT_EQ(overlap.Mask, 4);
  EXPECT_EQ(overlap.Both, 2);
  EXPECT_EQ(overlap.Irregular, 2);
  EXPECT_DOUBLE_EQ(overlap.Dice(), 4.0 / 7.0);
  EXPECT_DOUBLE_EQ(overlap.IrregularPercent(), 50.0);
  EXPECT_EQ(CompareWithMask({}, nullptr).Dice(), 1.0);
}

TEST(WindingNumbers, SurfacesThatOverlapThemselvesAreRefused)
{
  WindingOverlap overlap;
  overlap.Mask = 1000;
  overlap.Irregular = 10;
  EXPECT_TRUE(CheckRegularity(overlap).IsOk());
  overlap.Irregular = 11;
  EXPECT_NE(CheckRegularity(overlap).Message().find("1.1 %"), std::string::npos);
}

TEST(WindingNumbers, RejectBadInput)
{
  std::vector<std::int16_t> numbers;
  const IndexedMesh sphere = test::Sphere(2);
  EXPECT_TRUE(FindWindingNumbers({}, Cube(3), numbers).IsOk());
  EXPECT_FALSE(FindWindingNumbers(sphere, Cube(0), numbers).IsOk());
  EXPECT_FALSE(FindWindingNumbers(sphere, Cube(3000), numbers).IsOk());
  EXPECT_FALSE(FindWindingNumbers(sphere, Cube(3, 0.0), numbers).IsOk());
  VoxelCenters centers = Cube(3);
  centers.Axes.col(2) = centers.Axes.col(1);
  EXPECT_FALSE(FindWindingNumbers(sphere, centers, numbers).IsOk());
  centers = Cube(3);
  centers.Origin[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(FindWindingNumbers(sphere, centers, numbers).IsOk());
  IndexedMesh mesh = sphere;
  mesh.Points[7][2] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(FindWindingNumbers(mesh, Cube(3), numbers).IsOk());
  mesh.Points[7][2] = 1e20;
  EXPECT_FALSE(FindWindingNumbers(mesh, Cube(3), numbers).IsOk());
  mesh = sphere;
  mesh.Triangles[0][0] = 42;
  EXPECT_FALSE(FindWindingNumbers(mesh, Cube(3), numbers).IsOk());
}
} // namespace
} // namespace palpate::winding_numbers_test
