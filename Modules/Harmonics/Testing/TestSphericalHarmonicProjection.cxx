#include "SphericalHarmonicProjection.h"

#include "RandomOrientation.h"
#include "RandomShapes.h"
#include "TurnedModel.h"

#include <gtest/gtest.h>

namespace palpate::spherical_harmonic_projection_test
{
namespace
{
using test::Random;

TEST(SphericalHarmonicProjection, ReproducesModels)
{
  Random random(306);
  for (const int degree : {0, 1, 7, 30})
  {
    const RadialModel model = test::RandomOrgan(random, degree);
    const std::vector<double> projected = ProjectOnHarmonics(
        degree + 2, 2 * degree + 2, [&model](const Vector3& u) { return model.Radius(u); });
    const std::vector<double> expected = model.WithDegree(degree + 2).Coefficients();
    ASSERT_EQ(projected.size(), expected.size());
    for (std::size_t k = 0; k < projected.size(); ++k)
    {
      EXPECT_NEAR(projected[k], expected[k], 1e-12); // thousands of radii near 20 mm
    }
  }
}

TEST(SphericalHarmonicProjection, TurnsModelsAboutPoint)
{
  Random random(311);
  const RadialModel model = test::RandomOrgan(random, 10);
  const Matrix3 turn = test::RandomOrientation(random);
  const Vector3 pivot(10.0, -20.0, 30.0);
  const RadialModel turned = test::TurnedModel(model, turn, pivot);
  for (const Vector3& u : test::RandomDirections(random, 50))
  {
    const Vector3 expected = pivot + turn * (model.PointWorld(u) - pivot);
    EXPECT_LE((turned.PointWorld(turn * u) - expected).norm(), 1e-12); // coefficients as above
  }
}
} // namespace
} // namespace palpate::spherical_harmonic_projection_test
