#include "CompletionCases.h"

#include <gtest/gtest.h>

namespace palpate::touch_equations_test
{
namespace
{
using namespace palpate::test;

constexpr int Degree = 6;

// Near a lump of 20 mm, some with normals, some outside, some in strokes.
std::vector<SurfaceTouch> SomeTouches(Random& random, const LogSurface& surface)
{
  std::uniform_real_distribution<double> share(0.7, 1.4);
  std::vector<SurfaceTouch> touches;
  for (int n = 0; n < 40; ++n)
  {
    const Vector3 arm = PointOf(surface, RandomDirection(random)) - surface.CenterWorld;
    SurfaceTouch touch{surface.CenterWorld + share(random) * arm, 0.5 + 0.1 * (n % 7)};
    if (n % 3 == 0)
    {
      touch.Normal = 2.0 * RandomDirection(random);
    }
    touch.Stroke = n % 4;
    touch.IsOutside = n % 5 == 4;
    touches.push_back(touch);
  }
  return touches;
}

LogSurface Lump(Random& random)
{
  const std::vector<double> values = RandomCoefficients(random, Degree, 2.0);
  LogSurface surface{0.15 * Eigen::Map<const Eigen::VectorXd>(values.data(), 49), {3.0, -2.0, 5.0}};
  surface.Coefficients[0] = std::log(20.0) / ShapePrior::ConstantHarmonic;
  return surface;
}

TEST(TouchEquations, DerivativesAreThoseOfTheResiduals)
{
  Random random(3);
  const LogSurface surface = Lump(random);
  TouchEquations equations(Degree);
  equations.SetTouches(SomeTouches(random, surface));
  equations.Evaluate(surface);
  const Eigen::MatrixXd slopes = AllSlopes(equations);
  constexpr double Step = 1e-5; // second differences of some 100 mm: 1e-8
  const auto moved = [&](Eigen::Index unknown, double step)
  {
    LogSurface other = surface;
    (unknown < 49 ? other.Coefficients[unknown] : other.CenterWorld[unknown - 49]) += step;
    equations.Evaluate(other);
    return Eigen::VectorXd(equations.Residuals());
  };
  for (Eigen::Index unknown = 0; unknown < slopes.cols(); ++unknown)
  {
    const Eigen::VectorXd difference =
        (moved(unknown, Step) - moved(unknown, -Step)) / (2.0 * Step);
    EXPECT_LT((slopes.col(unknown) - difference).cwiseAbs().maxCoeff(), 1e-6) << unknown;
  }
}

TEST(TouchEquations, PointsNearASurfaceHaveTheirDistance)
{
  Random random(4);
  const LogSurface surface = Lump(random);
  std::vector<SurfaceTouch> touches = TouchesOf(surface, RandomDirections(random, 50), 1.0);
  TouchEquations equations(Degree);
  equations.SetTouches(touches);
  equations.Evaluate(surface);
  EXPECT_LT(equations.Residuals().cwiseAbs().maxCoeff(), 1e-12);
  // The slopes by the centre are the normals, against the way of the centre.
  constexpr double Lift = 0.01; // mm; curvature below 1/mm: 1e-4 mm of it
  for (std::size_t n = 0; n < touches.size(); ++n)
  {
    touches[n].PointWorld -= Lift * equations.ByCenter().col(static_cast<Eigen::Index>(n));
  }
  equations.SetTouches(touches);
  equations.Evaluate(surface);
  EXPECT_LT((equations.Residuals().array() - Lift).abs().maxCoeff(), 1e-4);
  EXPECT_NEAR(equations.Distance(), Lift, 1e-4);
}

TEST(TouchEquations, NormalsOfTheSurfaceLeaveNoResidualOnEitherSide)
{
  Random random(5);
  const LogSurface surface = Lump(random);
  std::vector<SurfaceTouch> touches = TouchesOf(surface, RandomDirections(random, 20), 1.0);
  TouchEquations equations(Degree);
  equations.SetTouches(touches);
  equations.Evaluate(surface);
  for (std::size_t n = 0; n < touches.size(); ++n)
  {
    touches[n].Normal =
        (n % 2 == 0 ? 3.0 : -1.0) * equations.ByCenter().col(static_cast<Eigen::Index>(n));
  }
  equations.SetTouches(touches);
  equations.Evaluate(surface);
  ASSERT_EQ(equations.Rows(), 60);
  EXPECT_LT(equations.Residuals().cwiseAbs().maxCoeff(), 1e-12);
}

TEST(TouchEquations, MisfitIsTheSquareOverTheCovariance)
{
  Random random(6);
  const LogSurface surface = Lump(random);
  TouchEquations equations(Degree);
  equations.SetTouches(SomeTouches(random, surface));
  equations.Evaluate(surface);
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(equations.Rows(), equations.Rows());
  equations.AddCovariance(covariance);
  const double square = equations.Residuals().dot(covariance.llt().solve(equations.Residuals()));
  EXPECT_NEAR(equations.Misfit(), square, 1e-9 * square);
}

TEST(TouchEquations, OutsideCountsOnlyWhereTheSurfaceReachesBeyond)
{
  Random random(7);
  const LogSurface surface = Lump(random);
  const Vector3 direction = RandomDirection(random);
  const Vector3 arm = PointOf(surface, direction) - surface.CenterWorld;
  TouchEquations equations(Degree);
  equations.SetTouches({{surface.CenterWorld + 1.1 * arm, 1.0, {}, 0, true},
                        {surface.CenterWorld + 0.9 * arm, 1.0, {}, 0, true}});
  equations.Evaluate(surface);
  EXPECT_EQ(equations.Residuals()[0], 0.0);
  EXPECT_EQ(equations.ByCoefficients().col(0).norm(), 0.0);
  EXPECT_LT(equations.Residuals()[1], 0.0);
  EXPECT_GT(equations.ByCoefficients().col(1).norm(), 0.0);
}
} // namespace
} // namespace palpate::touch_equations_test
