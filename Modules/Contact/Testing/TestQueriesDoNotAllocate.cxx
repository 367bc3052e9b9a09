#include "AllocationCounter.h"
#include "ClosestPointSearch.h"
#include "EvaluatorCases.h"
#include "RandomShapes.h"
#include "SphericalHarmonicBasis.h"
#include "SurfaceCases.h"

#include <gtest/gtest.h>

namespace palpate::queries_do_not_allocate_test
{
namespace
{
using test::AllEvaluatorKinds;
using test::AllocationCount;
using test::EvaluatorCase;
using test::EvaluatorKind;

TEST(QueriesDoNotAllocate, CounterCounts)
{
  const std::size_t before = AllocationCount();
  const std::vector<double> numbers(3, 1.0);
  CacheLineVector<double> aligned;
  aligned.push_back(numbers[0]);
  EXPECT_EQ(AllocationCount(), before + 2);
}

TEST(QueriesDoNotAllocate, Evaluator)
{
  for (const int degree : {0, 12, 16, 40})
  {
    const EvaluatorCase c(degree);
    for (const EvaluatorKind& kind : AllEvaluatorKinds())
    {
      using Evaluator = RadialEvaluator;
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

TEST(QueriesDoNotAllocate, SurfaceEvaluator)
{
  for (const int degree : {0, 12, 20, 40})
  {
    const test::SurfaceCase c(degree);
    for (const EvaluatorKind& kind : AllEvaluatorKinds())
    {
      using Evaluator = SurfaceEvaluator;
      const Evaluator evaluator(degree, c.Coefficients, kind.Formulation, kind.Set);
      const SurfaceModel surface(degree, c.Coefficients);
      const std::size_t count = c.Directions().size();
      std::vector<Vector3> points(count);
      std::vector<Evaluator::Sample> samples(count);
      std::vector<Evaluator::SecondOrderSample> secondOrders(count);
      const std::size_t before = AllocationCount();
      for (std::size_t i = 0; i < count; ++i)
      {
        points[i] = surface.Normal(c.Directions()[i]);
      }
      evaluator.PointBatch(c.Directions().data(), count, points.data());
      evaluator.EvaluateBatch(c.Directions().data(), count, samples.data());
      evaluator.EvaluateSecondOrderBatch(c.Directions().data(), count, secondOrders.data());
      EXPECT_EQ(AllocationCount(), before) << kind.Name() << " degree " << degree;
    }
  }
}

TEST(QueriesDoNotAllocate, Basis)
{
  const SphericalHarmonicBasis basis(40);
  std::vector<double> values(basis.Size());
  const std::size_t before = AllocationCount();
  basis.Evaluate({0.6, 0.0, 0.8}, values.data());
  EXPECT_EQ(AllocationCount(), before);
}

TEST(QueriesDoNotAllocate, ClosestPoint)
{
  test::Random random(1301);
  const auto model = std::make_shared<const RadialModel>(test::RandomOrgan(random, 12));
  const ClosestPointSearch search(model);
  const Vector3 outside = model->CenterWorld() + Vector3(30.0, 10.0, -5.0);
  const std::size_t before = AllocationCount();
  ClosestPoint point = search.Nearest(outside);
  point = search.Track(outside + Vector3(0.1, 0.0, 0.0), point);
  const ToolContact contact = search.TouchAnywhere(outside, 2.0);
  EXPECT_EQ(AllocationCount(), before);
  EXPECT_TRUE(contact.Normal.allFinite());
}
} // namespace
} // namespace palpate::queries_do_not_allocate_test
