#include "RadialEvaluator.h"

#include "EvaluatorCases.h"
#include "WorstCase.h"

#include <gtest/gtest.h>

namespace palpate::evaluation_batches_test
{
namespace
{
using test::AllEvaluatorKinds;
using test::EvaluatorCase;
using test::EvaluatorKind;
using test::WorstCase;

// The three batches of one evaluator, each with one row of numbers per direction and an additional
// row that no batch may change.
struct Batches
{
  using Evaluator = RadialEvaluator;
  static constexpr double Untouched = -77.0;

  Batches(const Evaluator& evaluator, const Vector3* directions, std::size_t count)
      : Radii(count + 1, Untouched), Samples(count + 1), SecondOrders(count + 1)
  {
    this->Samples.back().Radius = Untouched;
    this->SecondOrders.back().Radius = Untouched;
    evaluator.RadiusBatch(directions, count, this->Radii.data());
    evaluator.EvaluateBatch(directions, count, this->Samples.data());
    evaluator.EvaluateSecondOrderBatch(directions, count, this->SecondOrders.data());
  }
  bool EndIsUntouched() const
  {
    return this->Radii.back() == Untouched && this->Samples.back().Radius == Untouched &&
           this->SecondOrders.back().Radius == Untouched;
  }

  std::vector<double> Radii;
  std::vector<Evaluator::Sample> Samples;
  std::vector<Evaluator::SecondOrderSample> SecondOrders;
};

TEST(EvaluationBatches, AgreeWithSingleCalls)
{
  for (const int degree : {0, 1, 2, 3, 4, 5, 6, 7, 11, 12, 16, 21})
  {
    const EvaluatorCase c(degree);
    const std::vector<Vector3>& directions = c.Directions;
    for (const EvaluatorKind& kind : AllEvaluatorKinds())
    {
      const RadialEvaluator evaluator(degree, c.Coefficients, kind.Formulation, kind.Set);
      const Batches batches(evaluator, directions.data(), directions.size());
      WorstCase radius;
      WorstCase gradient;
      WorstCase hessian;
      for (std::size_t i = 0; i < directions.size(); ++i)
      {
        const auto single = evaluator.EvaluateSecondOrder(directions[i]);
        radius.Add(batches.Radii[i] - single.Radius);
        radius.Add(batches.Samples[i].Radius - single.Radius);
        radius.Add(batches.SecondOrders[i].Radius - single.Radius);
        gradient.Add((batches.Samples[i].SurfaceGradient - single.SurfaceGradient).norm());
        gradient.Add((batches.SecondOrders[i].SurfaceGradient - single.SurfaceGradient).norm());
        hessian.Add((batches.SecondOrders[i].SurfaceHessian - single.SurfaceHessian).norm());
      }
      // Twice what is promised for each, as both may err; at degree 21 the promise is weaker.
      const double bound = 2e-14 * (degree > 16 ? 2 : 1);
      EXPECT_LE(radius.Value(), bound * c.Scale()) << kind.Name() << " degree " << degree;
      EXPECT_LE(gradient.Value(), bound * c.GradientScale()) << kind.Name() << ' ' << degree;
      EXPECT_LE(hessian.Value(), bound * c.HessianScale()) << kind.Name() << ' ' << degree;
    }
  }
}

TEST(EvaluationBatches, AreIndependentOfCountAndPosition)
{
  const EvaluatorCase c(12);
  const std::vector<Vector3>& directions = c.Directions;
  for (const EvaluatorKind& kind : AllEvaluatorKinds())
  {
    const RadialEvaluator evaluator(12, c.Coefficients, kind.Formulation, kind.Set);
    const Batches all(evaluator, directions.data(), directions.size());
    for (std::size_t start = 0; start < 9; ++start)
    {
      for (const std::size_t count : {0U, 1U, 2U, 3U, 4U, 5U, 7U, 8U, 9U, 13U, 16U, 17U})
      {
        const Batches some(evaluator, directions.data() + start, count);
        EXPECT_TRUE(some.EndIsUntouched()) << count;
        for (std::size_t i = 0; i < count; ++i)
        {
          ASSERT_EQ(some.Radii[i], all.Radii[start + i]) << kind.Name();
          ASSERT_EQ(some.Samples[i].Radius, all.Samples[start + i].Radius);
          ASSERT_EQ(some.Samples[i].SurfaceGradient, all.Samples[start + i].SurfaceGradient);
          ASSERT_EQ(some.SecondOrders[i].SurfaceHessian,
                    all.SecondOrders[start + i].SurfaceHessian);
        }
      }
    }
  }
}

TEST(EvaluationBatches, InvalidDirectionAffectsOnlyItsOwnResult)
{
  for (const int degree : {0, 1, 12, 20})
  {
    const EvaluatorCase c(degree);
    for (const EvaluatorKind& kind : AllEvaluatorKinds())
    {
      const RadialEvaluator evaluator(degree, c.Coefficients, kind.Formulation, kind.Set);
      for (const Vector3& wrong : {Vector3(0, 0, 0), Vector3(std::nan(""), 0, 1), Vector3(0, 2, 0)})
      {
        std::vector<Vector3> directions = c.Directions;
        directions.resize(10);
        const Batches right(evaluator, directions.data(), directions.size());
        directions[5] = wrong;
        const Batches found(evaluator, directions.data(), directions.size());
        EXPECT_TRUE(std::isnan(found.Radii[5]) && std::isnan(found.Samples[5].Radius) &&
                    std::isnan(found.SecondOrders[5].Radius))
            << kind.Name() << " degree " << degree;
        EXPECT_TRUE(found.Samples[5].SurfaceGradient.array().isNaN().all()) << kind.Name();
        EXPECT_TRUE(found.SecondOrders[5].SurfaceGradient.array().isNaN().all()) << kind.Name();
        EXPECT_TRUE(found.SecondOrders[5].SurfaceHessian.array().isNaN().all()) << kind.Name();
        for (const std::size_t i : {0U, 4U, 6U, 9U})
        {
          EXPECT_EQ(found.Radii[i], right.Radii[i]);
          EXPECT_EQ(found.SecondOrders[i].SurfaceHessian, right.SecondOrders[i].SurfaceHessian);
        }
      }
    }
  }
}
} // namespace
} // namespace palpate::evaluation_batches_test
