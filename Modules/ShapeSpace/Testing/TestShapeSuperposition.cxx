#include "ShapeSuperposition.h"

#include "ModelMeasures.h"
#include "RandomOrientation.h"
#include "RandomShapes.h"
#include "SurfacePhantoms.h"
#include "WorstCase.h"

#include <Eigen/Geometry>

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::shape_superposition_test
{
namespace
{
using test::Random;
using test::WorstCase;

/// A random rotation by `angle` (rad).
Matrix3 Turn(Random& random, double angle)
{
  return Eigen::AngleAxisd(angle, test::RandomDirection(random)).toRotationMatrix();
}

OrganModel Centred(const RadialModel& organ)
{
  return RadialModel(organ.Degree(), organ.Coefficients(), Vector3::Zero());
}

OrganModel Centred(const SurfaceModel& surface)
{
  BodyMoments body;
  EXPECT_TRUE(MeasureBody(surface, body).IsOk());
  return surface.Transformed(Matrix3::Identity(), -body.CentroidWorld);
}

TEST(ShapeSuperposition, KnownRotationOfARadialModelIsRecovered)
{
  Random random(71);
  WorstCase worst;
  WorstCase residual;
  for (int trial = 0; trial < 20; ++trial)
  {
    const OrganModel organ = Centred(test::RandomOrgan(random, 3 + trial % 8));
    const Matrix3 turn = Turn(random, 0.5);
    const OrganModel turned = TurnShape(organ, {Matrix3::Identity(), turn});
    const SuperposedShape found = ShapeSuperposition(organ).Fit(turned, {});
    worst.Add((found.Rotation.Parameters * turn - Matrix3::Identity()).norm());
    residual.Add(found.Residual);
  }
  // Rounding of the gradient over the curvature, which is that of a relief of 4 mm on 20 mm.
  EXPECT_LE(worst.Value(), 1e-9);
  EXPECT_LE(residual.Value(), 1e-9); // mm
}

TEST(ShapeSuperposition, KnownRotationsOfBodyAndParametersAreRecovered)
{
  Random random(72);
  WorstCase worst;
  for (int trial = 0; trial < 5; ++trial)
  {
    const OrganModel tube = Centred(test::BumpyTube(random, 6));
    const SphereRotation turn{Turn(random, 0.3), Turn(random, 0.4)};
    const SuperposedShape found = ShapeSuperposition(tube).Fit(TurnShape(tube, turn), {});
    worst.Add((found.Rotation.Body * turn.Body - Matrix3::Identity()).norm());
    worst.Add((found.Rotation.Parameters * turn.Parameters - Matrix3::Identity()).norm());
    worst.Add(found.Residual);
  }
  EXPECT_LE(worst.Value(), 1e-9); // rad and mm
}

TEST(ShapeSuperposition, PolarFactorFindsAnyRotationOfTheParameters)
{
  Random random(73);
  WorstCase worst;
  for (int trial = 0; trial < 5; ++trial)
  {
    const OrganModel tube = Centred(test::BumpyTube(random, 6));
    const OrganModel turned =
        TurnShape(tube, {Matrix3::Identity(), test::RandomOrientation(random)});
    const ShapeSuperposition target(tube);
    worst.Add(target.Fit(turned, target.StartFor(turned, Matrix3::Identity())).Residual);
  }
  EXPECT_LE(worst.Value(), 1e-9); // mm
}

// Of different shapes: no small turn about any axis comes closer.
template <typename Shapes>
void ExpectOptimum(const Shapes& shape, bool hasBody, Random& random)
{
  const OrganModel target = shape();
  const OrganModel other = shape();
  const ShapeSuperposition superposition(target);
  const SuperposedShape found = superposition.Fit(other, {});
  for (int trial = 0; trial < 20; ++trial)
  {
    SphereRotation near = found.Rotation;
    near.Parameters = Turn(random, 1e-3) * near.Parameters;
    if (hasBody)
    {
      near.Body = Turn(random, 1e-3) * near.Body;
    }
    const OrganModel turned = TurnShape(other, near);
    double squares = 0.0;
    const SphereQuadrature sphere(2 * DegreeOf(target));
    for (std::size_t i = 0; i < sphere.Directions.size(); ++i)
    {
      const auto point = [&](const OrganModel& model)
      {
        const auto* radial = std::get_if<RadialModel>(&model);
        return radial != nullptr
                   ? Vector3(radial->Radius(sphere.Directions[i]) * sphere.Directions[i])
                   : std::get<SurfaceModel>(model).Point(sphere.Directions[i]);
      };
      squares += sphere.Weights[i] * (point(turned) - point(target)).squaredNorm();
    }
    EXPECT_GT(std::sqrt(squares / (4.0 * M_PI)), found.Residual);
  }
}

TEST(ShapeSuperposition, DifferentShapesReachAnOptimum)
{
  Random random(74);
  ExpectOptimum([&] { return Centred(test::RandomOrgan(random, 5)); }, false, random);
  ExpectOptimum([&] { return Centred(test::BumpyTube(random, 5)); }, true, random);
}

TEST(ShapeSuperposition, TurnedShapeHasTheSameBody)
{
  Random random(75);
  const OrganModel tube = Centred(test::BumpyTube(random, 5));
  const SphereRotation turn{test::RandomOrientation(random), test::RandomOrientation(random)};
  const auto turned = std::get<SurfaceModel>(TurnShape(tube, turn));
  const Vector3 parameter = test::RandomDirection(random);
  const Vector3 expected =
      turn.Body * std::get<SurfaceModel>(tube).Point(turn.Parameters.transpose() * parameter);
  EXPECT_LE((turned.Point(parameter) - expected).norm(), 1e-11);
  EXPECT_NEAR(RmsSizeOf(turned), RmsSizeOf(tube), 1e-11);
}

TEST(ShapeSuperposition, BallStaysAsItIs)
{
  const RadialModel ball(
      4,
      []
      {
        std::vector<double> c(25, 0.0);
        c[0] = 70.0;
        return c;
      }(),
      Vector3::Zero());
  const SuperposedShape found = ShapeSuperposition(ball).Fit(ball, {});
  EXPECT_LE((found.Rotation.Parameters - Matrix3::Identity()).norm(), 1e-6);
  EXPECT_LE(found.Residual, 1e-12);
}
} // namespace
} // namespace palpate::shape_superposition_test
