#include "ShapeFeatures.h"

#include "ComparedCases.h"
#include "MeshShapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <string>

namespace palpate::shape_features_test
{
namespace
{
std::vector<ShapeFeature> FeaturesOf(const IndexedMesh& mesh, const PointSpread& spread)
{
  std::vector<ShapeFeature> features;
  const Status status = MeasureShapeFeatures(mesh, spread, features);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return features;
}

std::vector<ShapeFeature> FeaturesOf(const IndexedMesh& mesh)
{
  return FeaturesOf(mesh, PointSpread::OfInside(mesh));
}

// The Initiative's digital phantom: 5 x 4 x 4 voxels of 2 mm of which these six are not part.
bool IsInPhantom(int x, int y, int z)
{
  const bool isFirst = x == 0 && y == 2 && z == 1;
  const bool isMiddle = x == 2 && y == 2 && z == 2;
  return !isFirst && !isMiddle && !(x >= 3 && y == 0 && z >= 2);
}

// Its consensus values, in three digits (Zwanenburg et al., Radiology 295 (2020) 328, and the
// manual): an implementation that nobody here has written.
TEST(ShapeFeatures, OfTheDigitalPhantomHaveTheConsensusValues)
{
  IndexToWorld toWorld;
  toWorld.Axes = 2.0 * Matrix3::Identity();
  std::vector<Vector3> centers;
  const ComparedBody body =
      test::BodyOfVoxels({7, 6, 6}, toWorld,
                         [&](const Vector3& world)
                         {
                           const Vector3 index = world / 2.0;
                           const auto [x, y, z] = std::array<int, 3>{static_cast<int>(index[0]),
                                                                     static_cast<int>(index[1]),
                                                                     static_cast<int>(index[2])};
                           const bool isIn = x >= 0 && x < 5 && y >= 0 && y < 4 && z >= 0 &&
                                             z < 4 && IsInPhantom(x, y, z);
                           if (isIn)
                           {
                             centers.push_back(world);
                           }
                           return isIn;
                         },
                         {-1, -1, -1});
  ASSERT_EQ(centers.size(), 74U);
  const std::vector<ShapeFeature> found =
      FeaturesOf(body.Surface(), PointSpread::OfPoints(centers));
  const std::map<std::string, double> consensus{{"volume_mesh", 556.0},
                                                {"surface_area", 388.0},
                                                {"surface_to_volume_ratio", 0.698},
                                                {"compactness_1", 0.0411},
                                                {"compactness_2", 0.599},
                                                {"spherical_disproportion", 1.19},
                                                {"sphericity", 0.843},
                                                {"asphericity", 0.186},
                                                {"maximum_3d_diameter", 13.1},
                                                {"major_axis_length", 11.4},
                                                {"minor_axis_length", 9.31},
                                                {"least_axis_length", 8.54},
                                                {"elongation", 0.816},
                                                {"flatness", 0.749},
                                                {"volume_density_aabb", 0.869},
                                                {"area_density_aabb", 0.866},
                                                {"volume_density_aee", 1.17},
                                                {"area_density_aee", 1.36},
                                                {"volume_density_convex_hull", 0.961},
                                                {"area_density_convex_hull", 1.03}};
  ASSERT_EQ(found.size(), consensus.size());
  for (const ShapeFeature& feature : found)
  {
    // Half a unit of the third digit; and cubes with more than three corners outside can be cut
    // into triangles in several ways, whose areas differ by 0.2 %.
    const double expected = consensus.at(feature.Key);
    EXPECT_NEAR(feature.Value, expected, std::max(0.007 * expected, 0.003)) << feature.Key;
  }
}

TEST(ShapeFeatures, OfAnEllipsoidAreThoseOfFormulas)
{
  IndexedMesh mesh = test::Sphere(80);
  const Vector3 axes(9.0, 6.0, 4.0);
  for (Vector3& point : mesh.Points)
  {
    point = point.cwiseProduct(axes);
  }
  const std::vector<ShapeFeature> found = FeaturesOf(mesh);
  // Inscribed triangles of 0.015 of the radius: 1e-4.
  EXPECT_NEAR(ValueOf(found, "volume_mesh"), 4.0 / 3.0 * M_PI * axes.prod(), 0.3);
  // Semi-axes of an even body are sqrt(5) standard deviations.
  EXPECT_NEAR(ValueOf(found, "major_axis_length"), 4.0 / std::sqrt(5.0) * 9.0, 0.01);
  EXPECT_NEAR(ValueOf(found, "least_axis_length"), 4.0 / std::sqrt(5.0) * 4.0, 0.01);
  EXPECT_NEAR(ValueOf(found, "elongation"), 6.0 / 9.0, 1e-4);
  EXPECT_NEAR(ValueOf(found, "maximum_3d_diameter"), 18.0, 0.01);
  EXPECT_NEAR(ValueOf(found, "volume_density_convex_hull"), 1.0, 1e-9);
  // The enclosing ellipsoid of the manual is the same shape: 4 standard deviations across.
  EXPECT_NEAR(ValueOf(found, "volume_density_aee"), std::pow(5.0 / 4.0, 1.5), 1e-3);
}

TEST(ShapeFeatures, OfASphereAreRound)
{
  const std::vector<ShapeFeature> found = FeaturesOf(test::Sphere(80, 5.0));
  EXPECT_NEAR(ValueOf(found, "sphericity"), 1.0, 1e-4);
  EXPECT_NEAR(ValueOf(found, "compactness_2"), 1.0, 3e-4);
  EXPECT_NEAR(ValueOf(found, "asphericity"), 0.0, 1e-4);
  EXPECT_NEAR(ValueOf(found, "compactness_1"), 1.0 / (6.0 * M_PI), 1e-5);
  EXPECT_NEAR(ValueOf(found, "flatness"), 1.0, 1e-6);
  EXPECT_NEAR(ValueOf(found, "area_density_aee"), 1.25, 1e-3);
}

// But for the box along the axes, nothing depends on where a body lies; ratios not on its size.
TEST(ShapeFeatures, DoNotDependOnPlaceAndScaleWithSize)
{
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  const IndexedMesh mesh = test::Lobed(20);
  const std::vector<ShapeFeature> before = FeaturesOf(mesh);
  for (int trial = 0; trial < 5; ++trial)
  {
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
            .normalized();
    const double scale = std::exp(normal(random));
    IndexedMesh moved = mesh;
    for (Vector3& point : moved.Points)
    {
      point = scale * (turn * point) + Vector3(120.0, -80.0, 300.0);
    }
    for (const ShapeFeature& feature : FeaturesOf(moved))
    {
      const std::string unit = feature.Unit;
      const std::map<std::string, double> powers{
          {"", 0.0}, {"mm", 1.0}, {"mm2", 2.0}, {"mm3", 3.0}, {"1/mm", -1.0}};
      const double expected = ValueOf(before, feature.Key) * std::pow(scale, powers.at(unit));
      if (std::string(feature.Key).find("aabb") == std::string::npos)
      {
        EXPECT_NEAR(feature.Value / expected, 1.0, 1e-6) << feature.Key;
      }
    }
  }
}

TEST(ShapeFeatures, RefuseWhatEnclosesNothing)
{
  std::vector<ShapeFeature> features;
  EXPECT_FALSE(MeasureShapeFeatures({}, {}, features).IsOk());
  const IndexedMesh inverted = test::Reversed(test::Sphere(3));
  EXPECT_FALSE(MeasureShapeFeatures(inverted, {}, features).IsOk());
}

TEST(PointSpread, AxesAreRightHandedFromTheLongestOn)
{
  IndexedMesh box = test::Box(Vector3(0.0, 0.0, 0.0), Vector3(2.0, 10.0, 5.0));
  Vector3 lengths;
  const Matrix3 axes = PointSpread::OfInside(box).Axes(&lengths);
  EXPECT_LT((axes.col(0) - Vector3::UnitY()).norm(), 1e-12);
  EXPECT_LT((axes.col(1) - Vector3::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(axes.determinant(), 1.0, 1e-12);
  EXPECT_NEAR(lengths[0], 4.0 * 10.0 / std::sqrt(12.0), 1e-9);
  EXPECT_NEAR(lengths[2], 4.0 * 2.0 / std::sqrt(12.0), 1e-9);
}
} // namespace
} // namespace palpate::shape_features_test
