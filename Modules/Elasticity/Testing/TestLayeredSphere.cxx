#include "ElasticCases.h"

#include <gtest/gtest.h>

namespace palpate::layered_sphere_test
{
namespace
{
TEST(LayeredSphere, LayersOfOneMaterialAreOneSphere)
{
  const LayeredSphere whole({{25.0, 0.02}}, 0.49, 1e-3);
  const LayeredSphere layers({{7.0, 0.02}, {24.0, 0.02}, {25.0, 0.02}}, 0.49, 1e-3);
  for (const int degree : {0, 1, 2, 5, 12, 60, 400})
  {
    const Eigen::Matrix2d a = whole.Response(degree);
    const Eigen::Matrix2d b = layers.Response(degree);
    EXPECT_LE((a - b).norm(), 1e-10 * a.norm()) << degree;
  }
}

TEST(LayeredSphere, ResponseIsReciprocal)
{
  const LayeredSphere sphere({{15.0, 0.2}, {20.0, 0.005}, {25.0, 0.02}}, 0.3, 1e-3);
  for (const int degree : {1, 2, 7, 30, 200})
  {
    const Eigen::Matrix2d response = sphere.Response(degree);
    EXPECT_NEAR(response(0, 1) / (degree * (degree + 1.0)), response(1, 0),
                1e-9 * std::abs(response(1, 0)))
        << degree;
    EXPECT_GT(response(0, 0), 0.0);
    EXPECT_GT(response.determinant(), 0.0);
  }
}

// A rigid sphere moves as a whole against its bed.
TEST(LayeredSphere, RigidSphereMovesAsItsBedYields)
{
  const LayeredSphere sphere({{25.0, 1e6}}, 0.3, 1e-3);
  const double moved = 1.0 / (1e-3 * 4.0 * Pi * 25.0 * 25.0);
  EXPECT_NEAR(sphere.Compliance(3.0), moved, 1e-5 * moved);
}

TEST(LayeredSphere, SmallPatchesAreThoseOfAHalfSpace)
{
  const LayeredSphere sphere = test::SphereTruth(0.0);
  const double reduced = test::Tissue / (1.0 - test::Poisson * test::Poisson);
  const double patch = 0.05;
  // The curvature and the bed change it by parts of the order of a/R.
  EXPECT_NEAR(sphere.Compliance(patch) * 5.0 * reduced * patch / 3.0, 1.0,
              10.0 * patch / test::Radius);
}

TEST(LayeredSphere, UniformPressureOfAThickSphereIsLames)
{
  // u = p R (1 - 2 nu) / (E + k R (1 - 2 nu)) for a homogeneous sphere on springs k.
  const double nu = 0.3;
  const LayeredSphere sphere({{25.0, 0.02}}, nu, 2e-3);
  const double y = 1.0 / std::sqrt(4.0 * Pi); // cancels: both are coefficients
  const double soft = 25.0 * (1.0 - 2.0 * nu) / (0.02 + 2e-3 * 25.0 * (1.0 - 2.0 * nu));
  EXPECT_NEAR(y * sphere.Response(0)(0, 0), y * soft, 1e-12 * soft);
}
} // namespace
} // namespace palpate::layered_sphere_test
