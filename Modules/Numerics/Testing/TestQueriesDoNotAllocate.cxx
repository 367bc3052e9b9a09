#include "AllocationCounter.h"
#include "EvaluatorCases.h"
#include "SphericalHarmonicBasis.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
using test::AllEvaluatorKinds;
using test::AllocationCount;
using test::EvaluatorCase;
using test::EvaluatorKind;

TEST(QueriesDoNotAllocate, TheCounterCounts)
{
  const std::size_t before = AllocationCount();
  const std::vector<double> numbers(3, 1.0);
  EvaluationTable<double> aligned;
  aligned.push_back(numbers[0]);
  EXPECT_EQ(AllocationCount(), before + 2);
}

TEST(QueriesDoNotAllocate, OfEvaluators)
{
  for (const int degree : {0, 12, 16, 40})
  {
    const EvaluatorCase c(degree);
    for (const EvaluatorKind& kind : AllEvaluatorKinds())
    {
      using Evaluator = SphericalHarmonicEvaluator<double>;
      const Evaluator evaluator(degree, c.Coefficients, kind.Formulation, kind.Set);
      const std::size_t count = c.Directions.size();
      std::vector<double> radii(count);
      std::vector<Evaluator::Sample> samples(count);
      std::vector<Evaluator::SecondOrderSample> secondOrders(count);
      const std::size_t before = AllocationCount();
      for (std::size_t i = 0; i < count; ++i)
      {
        radii[i] = evaluator.Radius(c.Directions[i]);
        samples[i] = evaluator.Evaluate(c.Directions[i]);
        secondOrders[i] = evaluator.EvaluateSecondOrder(c.Directions[i]);
      }
      evaluator.RadiusBatch(c.Directions.data(), count, radii.data());
      evaluator.EvaluateBatch(c.Directions.data(), count, samples.data());
      evaluator.EvaluateSecondOrderBatch(c.Directions.data(), count, secondOrders.data());
      EXPECT_EQ(AllocationCount(), before) << kind.Name() << " degree " << degree;
    }
  }
}

TEST(QueriesDoNotAllocate, OfTheBasis)
{
  const SphericalHarmonicBasis basis(40);
  std::vector<double> values(basis.Size());
  const std::size_t before = AllocationCount();
  basis.Evaluate({0.6, 0.0, 0.8}, values.data());
  EXPECT_EQ(AllocationCount(), before);
}
} // namespace
} // namespace palpate
