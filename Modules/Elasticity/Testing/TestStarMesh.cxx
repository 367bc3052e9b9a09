#include "ElasticCases.h"
#include "GaussLegendre.h"
#include "ModelMeasures.h"

#include <gtest/gtest.h>

#include <limits>

namespace palpate::star_mesh_test
{
namespace
{
TEST(StarMesh, FillsTheModel)
{
  std::mt19937_64 random(3);
  for (int i = 0; i < 8; ++i)
  {
    const RadialModel model = test::RandomModel(random);
    StarMesh mesh;
    ASSERT_TRUE(StarMesh::Make(model, 16, mesh).IsOk());
    // Flat faces of 16 a quarter cut off about (pi/32)^2 of the volume.
    const double volume = VolumeOf(model);
    EXPECT_NEAR(test::FilledVolume(mesh), volume, 0.015 * volume);
    EXPECT_LT(test::FilledVolume(mesh), volume);
  }
}

TEST(StarMesh, SurfaceNodesLieOnTheModel)
{
  std::mt19937_64 random(4);
  const RadialModel model = test::RandomModel(random);
  StarMesh mesh;
  ASSERT_TRUE(StarMesh::Make(model, 8, mesh).IsOk());
  for (const StarMesh::Face& face : mesh.Faces())
  {
    for (const int node : face.Nodes)
    {
      const Vector3& point = mesh.Nodes()[static_cast<std::size_t>(node)];
      EXPECT_NEAR(point.norm(), model.Radius(point.normalized()), 1e-12 * test::Radius);
    }
  }
}

TEST(StarMesh, FacesCoverTheSphereOnce)
{
  StarMesh mesh;
  ASSERT_TRUE(StarMesh::Make(test::SphereModel(), 6, mesh).IsOk());
  const GaussLegendre gauss(5);
  double sum = 0.0;
  Vector3 moment = Vector3::Zero();
  for (const StarMesh::Face& face : mesh.Faces())
  {
    for (std::size_t i = 0; i < 5; ++i)
    {
      for (std::size_t j = 0; j < 5; ++j)
      {
        const auto point = StarMesh::At(face, gauss.Nodes[i], gauss.Nodes[j]);
        sum += gauss.Weights[i] * gauss.Weights[j] * point.SolidAngle;
        moment += gauss.Weights[i] * gauss.Weights[j] * point.SolidAngle * point.Direction;
      }
    }
  }
  EXPECT_NEAR(sum, 4.0 * Pi, 1e-10);
  EXPECT_LE(moment.norm(), 1e-10);
}

TEST(StarMesh, AcceptsRadiiThatVaryManyfold)
{
  // R(d) from 0.4 to 1.6 of its mean.
  const double mean = 20.0 * std::sqrt(4.0 * Pi);
  const double slope = 12.0 / std::sqrt(3.0 / (4.0 * Pi));
  StarMesh mesh;
  const Status status =
      StarMesh::Make(RadialModel(1, {mean, 0.0, slope, 0.0}, Vector3::Zero()), 8, mesh);
  EXPECT_TRUE(status.IsOk()) << status.Message();
}

TEST(StarMesh, RefusesWhatHasNoInside)
{
  StarMesh mesh;
  EXPECT_FALSE(StarMesh::Make(RadialModel(), 8, mesh).IsOk());
  const double mean = 20.0 * std::sqrt(4.0 * Pi);
  EXPECT_FALSE(
      StarMesh::Make(RadialModel(1, {mean, 0.0, mean, 0.0}, Vector3::Zero()), 8, mesh).IsOk());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(StarMesh::Make(RadialModel(0, {nan}, Vector3::Zero()), 8, mesh).IsOk());
}

TEST(StarMesh, RefusesOtherNumbersOfElements)
{
  StarMesh mesh;
  for (const int across : {-2, 0, 1, 7, 42, 1000000})
  {
    EXPECT_FALSE(StarMesh::Make(test::SphereModel(), across, mesh).IsOk()) << across;
  }
}
} // namespace
} // namespace palpate::star_mesh_test
