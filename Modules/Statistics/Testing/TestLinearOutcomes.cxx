#include "LinearOutcomes.h"

#include "PermutationTest.h"
#include "RandomStudy.h"

namespace palpate::test
{
namespace
{
// 150 cases, 5 factors, 30 outcomes on a strip.
class LinearOutcomesTest : public testing::Test
{
protected:
  PermutationTest Permuted(const LinearOutcomes& outcomes) const
  {
    SurfaceGraph strip;
    strip.Areas.assign(30, 1.0);
    for (int i = 0; i < 29; ++i)
    {
      strip.Edges.emplace_back(i, i + 1);
    }
    PermutationSettings settings;
    settings.Count = 99;
    PermutationTest test;
    EXPECT_TRUE(TestByPermutation(FindEffectSpace(this->Design, this->Design.Terms[0]), outcomes,
                                  strip, settings, {}, test)
                    .IsOk());
    return test;
  }

  const LinearDesign Design = DesignOf(RandomCovariates(150, 4), "~ age + center");
  const Eigen::MatrixXd Factors = RandomOutcomes(150, 5, 5);
  const Eigen::MatrixXd PerFactor = RandomOutcomes(5, 30, 6);
  const LinearOutcomes Factored{this->Factors, this->PerFactor};
  const LinearOutcomes Dense{Eigen::MatrixXd(this->Factors * this->PerFactor)};
};

// Sums of 150 products, each right to 1e-16 of numbers up to 100.
constexpr double Rounding = 1e-11;

TEST_F(LinearOutcomesTest, ModelIsThatOfTheOutcomesThemselves)
{
  const LinearModel ours = FitLinearModel(this->Design, this->Factored);
  const LinearModel theirs = FitLinearModel(this->Design, this->Dense);
  EXPECT_TRUE(ours.Coefficients.isApprox(theirs.Coefficients, Rounding));
  EXPECT_TRUE(ours.StandardErrors.isApprox(theirs.StandardErrors, Rounding));
  const DesignTerm& term = this->Design.Terms[1];
  EXPECT_TRUE(TestTerm(this->Design, term, ours, this->Factored)
                  .F.isApprox(TestTerm(this->Design, term, theirs, this->Dense).F, Rounding));
}

TEST_F(LinearOutcomesTest, PermutationsAreThoseOfTheOutcomesThemselves)
{
  const PermutationTest ours = this->Permuted(this->Factored);
  const PermutationTest theirs = this->Permuted(this->Dense);
  EXPECT_TRUE(ours.Statistic.isApprox(theirs.Statistic, Rounding));
  EXPECT_EQ(ours.P, theirs.P);
  EXPECT_EQ(ours.FamilyP, theirs.FamilyP);
  EXPECT_EQ(ours.EnhancedP, theirs.EnhancedP);
  EXPECT_EQ(ours.WholeP, theirs.WholeP);
}

TEST_F(LinearOutcomesTest, SumsOfSquaresAreOverAllCases)
{
  const Eigen::VectorXd sums =
      (this->Factors * this->PerFactor).colwise().squaredNorm().transpose();
  EXPECT_TRUE(this->Factored.SquaredNorms(this->Factored.Factors()).isApprox(sums, Rounding));
  EXPECT_TRUE(this->Dense.SquaredNorms(this->Dense.Factors()).isApprox(sums, Rounding));
}

TEST_F(LinearOutcomesTest, MemoryIsThatOfFactorsOnlyWhereTheseAreFewer)
{
  EXPECT_EQ(this->Factored.Factors().cols(), 5);
  const LinearOutcomes few(RandomOutcomes(4, 5, 7), this->PerFactor);
  EXPECT_EQ(few.Factors().cols(), 30);
  EXPECT_EQ(this->Factored.OutcomeCount(), 30);
  EXPECT_EQ(few.OutcomeCount(), 30);
}
} // namespace
} // namespace palpate::test
