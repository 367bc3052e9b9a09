#include "FalseDiscovery.h"
#include "LinearModel.h"
#include "MultivariateTest.h"
#include "ProbabilityDistributions.h"
#include "RProgram.h"
#include "RandomStudy.h"

namespace palpate::test
{
namespace
{
// Both codes solve well-conditioned systems; R prints 17 digits.
constexpr double Agreement = 1e-8;

void ExpectAgreement(const std::vector<double>& judge, const std::vector<double>& ours)
{
  ASSERT_EQ(judge.size(), ours.size());
  for (std::size_t i = 0; i < judge.size(); ++i)
  {
    EXPECT_NEAR(ours[i], judge[i], Agreement * std::max(1.0, std::abs(judge[i]))) << i;
    EXPECT_NEAR(std::log(std::abs(ours[i])), std::log(std::abs(judge[i])), Agreement) << i;
  }
}

void Append(const Eigen::MatrixXd& values, std::vector<double>& all)
{
  all.insert(all.end(), values.data(), values.data() + values.size());
}

class LinearModelAgainstR : public ::testing::Test
{
protected:
  void SetUp() override
  {
    if (!RProgram::IsThere())
    {
      GTEST_SKIP() << "R (r-base-core), the judge, is not installed";
    }
  }
};

TEST_F(LinearModelAgainstR, AgreesInCoefficientsErrorsAndIntervals)
{
  const CovariateTable table = RandomCovariates(60, 1);
  const Eigen::MatrixXd outcomes = RandomOutcomes(60, 4, 2);
  const LinearDesign design = DesignOf(table, "~ age + log(psa) + center * sex");
  const LinearModel model = FitLinearModel(design, outcomes);
  std::vector<double> ours;
  for (Eigen::Index k = 0; k < outcomes.cols(); ++k)
  {
    Append(model.Coefficients.col(k), ours);
    Append(model.StandardErrors.col(k), ours);
    Append(model.Coefficients.col(k) - model.ConfidenceWidths(0.95).col(k), ours);
  }
  const RProgram judge;
  ExpectAgreement(
      judge.Run(table, outcomes,
                "for (k in 1:4) { m <- lm(y[, k] ~ age + log(psa) + center * sex, d)\n"
                "s <- summary(m)$coefficients; out(s[, 1]); out(s[, 2]); out(confint(m)[, 1]) }"),
      ours);
}

TEST_F(LinearModelAgainstR, AgreesInTestsOfTerms)
{
  const CovariateTable table = RandomCovariates(50, 5);
  const Eigen::MatrixXd outcomes = RandomOutcomes(50, 3, 6);
  const LinearDesign design = DesignOf(table, "~ I(age^2) + sqrt(psa) + center + sex");
  const LinearModel model = FitLinearModel(design, outcomes);
  std::vector<double> ours;
  for (const DesignTerm& term : design.Terms)
  {
    const TermTest test = TestTerm(design, term, model, outcomes);
    Append(test.F, ours);
    Append(test.P, ours);
  }
  const RProgram judge;
  ExpectAgreement(
      judge.Run(
          table, outcomes,
          "f <- lapply(1:3, function(k) drop1(lm(y[, k] ~ I(age^2) + sqrt(psa) + center + sex, d),"
          " test = 'F'))\n"
          "for (i in 2:5) { out(sapply(f, function(t) t[i, 5])); out(sapply(f, function(t) t[i, "
          "6])) }"),
      ours);
}

TEST_F(LinearModelAgainstR, AgreesInMultivariateTests)
{
  const CovariateTable table = RandomCovariates(80, 9);
  const std::vector<std::pair<std::string, int>> cases{
      {"center", 1}, {"center", 2}, {"center", 5}, {"age", 4}};
  for (const auto& [tested, count] : cases)
  {
    const Eigen::MatrixXd outcomes = RandomOutcomes(80, count, 10);
    const std::string formula = tested == "age" ? "center + sex + age" : "age + sex + center";
    const LinearDesign design = DesignOf(table, "~ " + formula);
    MultivariateTest test;
    ASSERT_TRUE(TestTogether(design, design.Terms.back(), outcomes, test).IsOk());
    std::vector<double> ours;
    for (const MultivariateStatistic& one :
         {test.Pillai, test.Wilks, test.HotellingLawley, test.Roy})
    {
      ours.insert(ours.end(),
                  {one.Value, one.F, one.NumeratorDegrees, one.DenominatorDegrees, one.P});
    }
    const RProgram judge;
    // R's manova needs two outcomes; for one, its analysis of variance gives the same F.
    const std::string script = count == 1
                                   ? "a <- anova(lm(y[, 1] ~ " + formula +
                                         ", d)); i <- 3; f <- a[i, 4]; h <- f * a[i, 1] / a[4, 1]\n"
                                         "for (v in c(h / (1 + h), 1 / (1 + h), h, h)) { out(v); "
                                         "out(f); out(a[i, 1]); out(a[4, 1]); out(a[i, 5]) }"
                                   : "m <- manova(y ~ " + formula +
                                         ", d)\n"
                                         "for (t in c('Pillai', 'Wilks', 'Hotelling-Lawley', "
                                         "'Roy')) out(summary(m, test = t)$stats[3, 2:6])";
    ExpectAgreement(judge.Run(table, outcomes, script), ours);
  }
}

TEST_F(LinearModelAgainstR, AgreesInFalseDiscoveryRatesAndDistributions)
{
  const Eigen::MatrixXd p =
      RandomOutcomes(200, 1, 3).unaryExpr([](double x) { return 0.5 * std::erfc(x); });
  std::vector<double> ours;
  Append(FalseDiscoveryRates(p.col(0)), ours);
  for (const double degrees : {1.0, 3.0, 17.0, 158.0})
  {
    for (const double value : {0.01, 0.7, 2.3, 9.0, 40.0})
    {
      ours.push_back(StudentTwoSided(-value, degrees));
      ours.push_back(FisherUpper(value, 3.0, degrees));
    }
    ours.push_back(StudentQuantile(0.95, degrees));
    ours.push_back(FisherUpperQuantile(0.001, 3.0, degrees));
  }
  const RProgram judge;
  ExpectAgreement(
      judge.Run(RandomCovariates(3, 1), p,
                "out(p.adjust(y[, 1], 'BH'))\n"
                "for (n in c(1, 3, 17, 158)) { for (v in c(0.01, 0.7, 2.3, 9, 40)) {\n"
                "out(2 * pt(-v, n)); out(pf(v, 3, n, lower.tail = FALSE)) }; out(qt(0.975, n)); "
                "out(qf(0.001, 3, n, lower.tail = FALSE)) }"),
      ours);
}

TEST(LinearModel, FindsWhatTheOutcomesAreMadeOf)
{
  const LinearDesign design = DesignOf(RandomCovariates(30, 2), "~ age + center");
  const Eigen::MatrixXd truth = RandomOutcomes(4, 6, 3);
  const LinearModel model = FitLinearModel(design, Eigen::MatrixXd(design.Matrix * truth));
  EXPECT_LT((model.Coefficients - truth).cwiseAbs().maxCoeff(), 1e-10); // a condition of some 1e3
  EXPECT_EQ(model.FreeDegrees, 26);
}

// An average shifted by a constant changes neither errors nor tests of the others.
TEST(LinearModel, IsIndifferentToShiftsOfOutcomes)
{
  const CovariateTable table = RandomCovariates(25, 4);
  const LinearDesign design = DesignOf(table, "~ age + sex");
  const Eigen::MatrixXd outcomes = RandomOutcomes(25, 3, 5);
  const Eigen::MatrixXd shifted = outcomes.array() + 1000.0;
  const TermTest one =
      TestTerm(design, design.Terms[0], FitLinearModel(design, outcomes), outcomes);
  const TermTest other =
      TestTerm(design, design.Terms[0], FitLinearModel(design, shifted), shifted);
  EXPECT_LT((one.F - other.F).cwiseAbs().maxCoeff(), 1e-7 * one.F.maxCoeff());
}

TEST(MultivariateTest, IsIndifferentToLinearMapsOfOutcomes)
{
  const LinearDesign design = DesignOf(RandomCovariates(40, 6), "~ age + center");
  const Eigen::MatrixXd outcomes = RandomOutcomes(40, 5, 7);
  MultivariateTest one;
  MultivariateTest other;
  ASSERT_TRUE(TestTogether(design, design.Terms[1], outcomes, one).IsOk());
  ASSERT_TRUE(TestTogether(design, design.Terms[1], 1e6 * outcomes * RandomOutcomes(5, 5, 8), other)
                  .IsOk());
  EXPECT_NEAR(one.Wilks.P, other.Wilks.P, 1e-9);
  EXPECT_NEAR(one.Pillai.F, other.Pillai.F, 1e-9 * one.Pillai.F);
}

TEST(MultivariateTest, RefusesMoreOutcomesThanDegreesAndDependentOnes)
{
  const LinearDesign design = DesignOf(RandomCovariates(12, 6), "~ age");
  MultivariateTest test;
  EXPECT_FALSE(TestTogether(design, design.Terms[0], RandomOutcomes(12, 11, 7), test).IsOk());
  Eigen::MatrixXd twice = RandomOutcomes(12, 2, 7);
  twice.col(1) = 3.0 * twice.col(0);
  EXPECT_FALSE(TestTogether(design, design.Terms[0], twice, test).IsOk());
}
} // namespace
} // namespace palpate::test
