#include "SphericalHarmonicEvaluator.h"

#include "EvaluatorCases.h"
#include "WorstCase.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
using test::AllEvaluatorKinds;
using test::EvaluatorCase;
using test::EvaluatorKind;
using test::WorstCase;

// The three batches of one evaluator, each with one row of numbers per direction, plus a guard row
// that no batch may write.
template <typename Real>
struct Batches
{
  using Evaluator = SphericalHarmonicEvaluator<Real>;
  using Vector = typename Evaluator::Vector;
  static constexpr Real Untouched = Real(-77);

  Batches(const Evaluator& evaluator, const Vector* directions, std::size_t count)
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

  std::vector<Real> Radii;
  std::vector<typename Evaluator::Sample> Samples;
  std::vector<typename Evaluator::SecondOrderSample> SecondOrders;
};

template <typename Real>
std::vector<Eigen::Matrix<Real, 3, 1>> Directions(const EvaluatorCase& c)
{
  std::vector<Eigen::Matrix<Real, 3, 1>> directions;
  for (const Vector3& u : c.Directions)
  {
    directions.push_back(u.cast<Real>());
  }
  return directions;
}

template <typename Real>
class EvaluationBatches : public testing::Test
{
};
using Precisions = testing::Types<double, float>;
TYPED_TEST_SUITE(EvaluationBatches, Precisions, );

TYPED_TEST(EvaluationBatches, AgreeWithSingleCalls)
{
  using Real = TypeParam;
  for (const int degree : {0, 1, 2, 3, 4, 5, 6, 7, 11, 12, 16, 21})
  {
    const EvaluatorCase c(degree);
    const auto directions = Directions<Real>(c);
    for (const EvaluatorKind& kind : AllEvaluatorKinds())
    {
      const SphericalHarmonicEvaluator<Real> evaluator(degree, c.Coefficients, kind.Formulation,
                                                       kind.Set);
      const Batches<Real> batches(evaluator, directions.data(), directions.size());
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
      // Twice the documented error, as both may be off; at degree 21 the bound is weaker.
      const double bound = (sizeof(Real) == sizeof(double) ? 2e-14 : 8e-6) * (degree > 16 ? 2 : 1);
      EXPECT_LE(radius.Value(), bound * c.Scale()) << kind.Name() << " degree " << degree;
      EXPECT_LE(gradient.Value(), bound * c.GradientScale()) << kind.Name() << ' ' << degree;
      EXPECT_LE(hessian.Value(), bound * c.HessianScale()) << kind.Name() << ' ' << degree;
    }
  }
}

TYPED_TEST(EvaluationBatches, AreIndependentOfCountAndPosition)
{
  using Real = TypeParam;
  const EvaluatorCase c(12);
  const auto directions = Directions<Real>(c);
  for (const EvaluatorKind& kind : AllEvaluatorKinds())
  {
    const SphericalHarmonicEvaluator<Real> evaluator(12, c.Coefficients, kind.Formulation,
                                                     kind.Set);
    const Batches<Real> all(evaluator, directions.data(), directions.size());
    for (std::size_t start = 0; start < 9; ++start)
    {
      for (const std::size_t count : {0U, 1U, 2U, 3U, 4U, 5U, 7U, 8U, 9U, 13U, 16U, 17U})
      {
        const Batches<Real> some(evaluator, directions.data() + start, count);
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

TYPED_TEST(EvaluationBatches, InvalidDirectionAffectsOnlyItsResult)
{
  using Real = TypeParam;
  using Vector = Eigen::Matrix<Real, 3, 1>;
  for (const int degree : {0, 1, 12, 20})
  {
    const EvaluatorCase c(degree);
    for (const EvaluatorKind& kind : AllEvaluatorKinds())
    {
      const SphericalHarmonicEvaluator<Real> evaluator(degree, c.Coefficients, kind.Formulation,
                                                       kind.Set);
      for (const Vector& wrong : {Vector(0, 0, 0), Vector(std::nanf(""), 0, 1), Vector(0, 2, 0)})
      {
        std::vector<Vector> directions = Directions<Real>(c);
        directions.resize(10);
        const Batches<Real> right(evaluator, directions.data(), directions.size());
        directions[5] = wrong;
        const Batches<Real> found(evaluator, directions.data(), directions.size());
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
} // namespace palpate
