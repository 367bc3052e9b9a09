#include "ParameterCorrespondence.h"

#include "ModelMeasures.h"
#include "RandomShapes.h"
#include "ShapeVector.h"
#include "SurfacePhantoms.h"

#include <Eigen/Geometry>

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::parameter_correspondence_test
{
namespace
{
using test::Random;

Matrix3 HalfTurn(int axis)
{
  return Eigen::AngleAxisd(M_PI, Vector3::Unit(axis)).toRotationMatrix();
}

/// Variants of a shape about the origin, with a relief of some `size` mm.
std::vector<OrganModel> VariantsOf(const OrganModel& shape, Random& random, int count, double size)
{
  std::vector<OrganModel> shapes;
  const Eigen::VectorXd mean = VectorOf(shape);
  const Eigen::Index series = std::holds_alternative<RadialModel>(shape) ? 1 : 3;
  for (int i = 0; i < count; ++i)
  {
    Eigen::VectorXd values = mean;
    for (Eigen::Index s = 0; s < series; ++s)
    {
      const std::vector<double> relief = test::RandomCoefficients(random, DegreeOf(shape), 1.0);
      for (std::size_t k = 1; k < relief.size(); ++k)
      {
        values[s * static_cast<Eigen::Index>(relief.size()) + static_cast<Eigen::Index>(k)] +=
            size * relief[k];
      }
    }
    shapes.push_back(ShapeFrom(values, shape));
  }
  return shapes;
}

OrganModel CentredTube(Random& random, int degree)
{
  const SurfaceModel tube = test::BumpyTube(random, degree);
  BodyMoments body;
  EXPECT_TRUE(MeasureBody(tube, body).IsOk());
  return tube.Transformed(Matrix3::Identity(), -body.CentroidWorld);
}

std::vector<ParameterCorrespondence> Compare(const std::vector<OrganModel>& shapes)
{
  std::vector<ParameterCorrespondence> cases;
  const Status status = CompareParameters(shapes, {}, cases);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return cases;
}

// Of three, the other two have weights in inverse proportion to their distances from the median.
TEST(ParameterCorrespondence, DistanceIsThatFromTheWeightedMeanOfTheOthers)
{
  Random random(301);
  const OrganModel organ =
      RadialModel(4, test::RandomOrgan(random, 4).Coefficients(), Vector3::Zero());
  const Eigen::VectorXd mean = VectorOf(organ);
  const Eigen::VectorXd step = Eigen::VectorXd::Unit(mean.size(), 6);
  const auto at = [&](double place) { return ShapeFrom(mean + place * step, organ); };
  // On a line the median is the third shape, whose weight is bounded: 100 over the mean distance.
  const auto cases = Compare({at(-3.0), at(1.0), at(0.0)});
  const double heavy = 75.0;
  const double first = 3.0 + 1.0 / (1.0 + heavy);
  const double second = 1.0 + 1.0 / (1.0 / 3.0 + heavy);
  // mm; the median is found to 1e-6.
  EXPECT_NEAR(cases[0].Distance * std::sqrt(4.0 * M_PI), first, 1e-6);
  EXPECT_NEAR(cases[1].Distance * std::sqrt(4.0 * M_PI), second, 1e-6);
  EXPECT_NEAR(cases[2].Distance, 0.0, 1e-6);
}

TEST(ParameterCorrespondence, FlippedShapesHardlyMoveWhatTheOthersAreComparedWith)
{
  Random random(306);
  std::vector<OrganModel> shapes = VariantsOf(CentredTube(random, 6), random, 9, 0.2);
  const auto before = Compare(shapes);
  for (const std::size_t flipped : {0U, 4U, 8U})
  {
    shapes[flipped] = TurnShape(shapes[flipped], {Matrix3::Identity(), HalfTurn(2)});
  }
  const auto after = Compare(shapes);
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    EXPECT_EQ(after[i].IsFlipped(), i % 4 == 0) << i << " " << after[i].TurnRatio();
    if (i % 4 != 0)
    {
      EXPECT_LT(after[i].Distance, before[i].Distance + 0.3) << i; // mm; a mean moves by 5 mm
    }
  }
}

TEST(ParameterCorrespondence, FlippedParametersAreFoundAboutEachAxisAndOthersAreNot)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    Random random(302);
    std::vector<OrganModel> shapes = VariantsOf(CentredTube(random, 8), random, 8, 0.4);
    shapes[3] = TurnShape(shapes[3], {Matrix3::Identity(), HalfTurn(axis)});
    const auto cases = Compare(shapes);
    for (std::size_t i = 0; i < shapes.size(); ++i)
    {
      EXPECT_EQ(cases[i].IsFlipped(), i == 3) << axis << " " << i << " " << cases[i].TurnRatio();
    }
    EXPECT_FALSE(cases[3].TurnsBody);
    EXPECT_GT(cases[3].TurnAngle(), 0.9 * M_PI);
    EXPECT_GT(cases[3].TurnRatio(), 3.0);
  }
}

TEST(ParameterCorrespondence, BodyTurnedWithItsParametersIsFound)
{
  Random random(303);
  std::vector<OrganModel> shapes = VariantsOf(CentredTube(random, 8), random, 8, 0.2);
  shapes[5] = TurnShape(shapes[5], {HalfTurn(1), HalfTurn(1)});
  const auto cases = Compare(shapes);
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    EXPECT_EQ(cases[i].IsFlipped(), i == 5) << i << " " << cases[i].TurnRatio();
  }
  EXPECT_TRUE(cases[5].TurnsBody);
}

TEST(ParameterCorrespondence, ArbitraryLargeTurnOfTheParametersIsFound)
{
  for (int trial = 0; trial < 10; ++trial)
  {
    Random random(310 + trial);
    std::vector<OrganModel> shapes = VariantsOf(CentredTube(random, 6), random, 5, 0.1);
    const double angle = 1.0 + 0.2 * trial; // rad
    shapes[0] = TurnShape(
        shapes[0], {Matrix3::Identity(),
                    Eigen::AngleAxisd(angle, test::RandomDirection(random)).toRotationMatrix()});
    const auto cases = Compare(shapes);
    EXPECT_TRUE(cases[0].IsFlipped());
    EXPECT_NEAR(cases[0].TurnAngle(), angle, 0.05) << trial; // what the relief turns
    EXPECT_FALSE(cases[1].IsFlipped());
  }
}

TEST(ParameterCorrespondence, FlippedRadialModelIsFound)
{
  Random random(304);
  const OrganModel organ =
      RadialModel(6, test::RandomOrgan(random, 6).Coefficients(), Vector3::Zero());
  std::vector<OrganModel> shapes = VariantsOf(organ, random, 8, 0.2);
  shapes[7] = TurnShape(shapes[7], {Matrix3::Identity(), HalfTurn(2)});
  const auto cases = Compare(shapes);
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    EXPECT_EQ(cases[i].IsFlipped(), i == 7) << i << " " << cases[i].TurnRatio();
  }
}

TEST(ParameterCorrespondence, BallsHaveNoFlips)
{
  std::vector<OrganModel> shapes;
  for (const double radius : {70.0, 80.0, 90.0})
  {
    std::vector<double> coefficients(16, 0.0);
    coefficients[0] = radius;
    shapes.emplace_back(RadialModel(3, coefficients, Vector3::Zero()));
  }
  for (const ParameterCorrespondence& one : Compare(shapes))
  {
    EXPECT_FALSE(one.IsFlipped());
    EXPECT_LE(one.OwnDistance, 1e-9); // mm; rounding
  }
}

TEST(ParameterCorrespondence, FailsForTwoShapesAndIfCancelled)
{
  Random random(305);
  const std::vector<OrganModel> shapes = VariantsOf(CentredTube(random, 3), random, 3, 0.1);
  std::vector<ParameterCorrespondence> cases;
  EXPECT_FALSE(CompareParameters({shapes[0], shapes[1]}, {}, cases).IsOk());
  EXPECT_FALSE(CompareParameters(
                   shapes, [](double done) { return done < 0.5; }, cases)
                   .IsOk());
}

TEST(UpperLogFence, IsTukeysFenceOfLogarithms)
{
  std::vector<double> values;
  for (int k = 0; k <= 8; ++k)
  {
    values.push_back(std::exp2(k)); // quartiles 2^2 and 2^6
  }
  EXPECT_NEAR(UpperLogFence(values), std::exp2(12.0), 1e-9);
  values.resize(7);
  EXPECT_TRUE(std::isinf(UpperLogFence(values)));
  EXPECT_TRUE(std::isfinite(UpperLogFence(std::vector<double>(8, 0.0))));
}
} // namespace
} // namespace palpate::parameter_correspondence_test
