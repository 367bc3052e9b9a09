#include "ProbabilityDistributions.h"
#include "ProofCount.h"
#include "RepeatedStudy.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <array>
#include <functional>

namespace palpate::test
{
namespace
{
// -2 log restricted likelihood by dense matrices, as the textbook has it (Pinheiro and Bates,
// Mixed-Effects Models in S and S-PLUS, 2000, section 2.2.5).
double DenseCriterion(const RepeatedStudy& study, double residual, const Eigen::Matrix2d& subject)
{
  const Eigen::Index count = study.Outcome.size();
  Eigen::MatrixXd v = residual * Eigen::MatrixXd::Identity(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    for (Eigen::Index j = 0; j < count; ++j)
    {
      if (study.Subjects[static_cast<std::size_t>(i)] ==
          study.Subjects[static_cast<std::size_t>(j)])
      {
        const Eigen::Vector2d one(1.0, study.Times[i]);
        const Eigen::Vector2d two(1.0, study.Times[j]);
        v(i, j) += one.dot(subject * two);
      }
    }
  }
  const Eigen::MatrixXd inverse = v.inverse();
  const Eigen::MatrixXd normal = study.Fixed.transpose() * inverse * study.Fixed;
  const Eigen::VectorXd rest =
      study.Outcome -
      study.Fixed * normal.inverse() * (study.Fixed.transpose() * inverse * study.Outcome);
  return static_cast<double>(count - study.Fixed.cols()) * std::log(2.0 * M_PI) +
         std::log(v.determinant()) + std::log(normal.determinant()) + rest.dot(inverse * rest);
}

TEST(MixedModel, CriterionIsTheDenseOneAndNoNeighbourHasALowerOne)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    RepeatedShape shape;
    shape.HasSlopes = seed % 2 == 0;
    const RepeatedStudy study(shape, seed);
    const MixedFit fit = study.Fit();
    // Rounding of some 1e-16 in sums near 100.
    EXPECT_NEAR(fit.Criterion, DenseCriterion(study, fit.ResidualVariance, fit.SubjectCovariance),
                1e-9);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 100; ++i)
    {
      const double size = std::pow(10.0, -2.0 + 2.5 * (i % 10) / 9.0);
      Eigen::Matrix2d change;
      change << normal(random), 0.0, normal(random), normal(random);
      change *= shape.HasSlopes ? size : 0.0;
      change(0, 0) += shape.HasSlopes ? 0.0 : size * normal(random);
      const Eigen::Matrix2d part = (1.0 - std::min(size, 1.0)) * fit.SubjectCovariance;
      EXPECT_GT(DenseCriterion(study, fit.ResidualVariance * std::exp(size * normal(random)),
                               part + change * change.transpose()),
                fit.Criterion - 1e-9)
          << seed;
    }
  }
}

// A study with another minimum, 1.63 higher, where variances are smaller.
TEST(MixedModel, IsTheLowestOfSeveralMinima)
{
  const RepeatedStudy study({10, 1, 5, 1.0, 0.5, 0.3, 1.0, 0.0, true}, 1271);
  Eigen::Matrix2d higher;
  higher << 0.936509, 0.305678, 0.305678, 0.0997735;
  EXPECT_NEAR(DenseCriterion(study, 1.45492, higher), 87.600844, 1e-5);
  EXPECT_NEAR(study.Fit().Criterion, 85.971431, 1e-5);
}

// Searle, Casella and McCulloch, Variance Components, 1992, section 4.4.
TEST(MixedModel, OfBalancedSubjectsIsTheAnalysisOfVariance)
{
  int singular = 0;
  for (unsigned seed = 0; seed < 30; ++seed)
  {
    RepeatedStudy study({9, 4, 4, 0.4, 0.0, 0.0, 1.0, 3.0, false}, seed);
    study.Fixed = Eigen::MatrixXd::Ones(36, 1);
    const MixedFit fit = study.Fit();
    const Eigen::Map<const Eigen::MatrixXd> table(study.Outcome.data(), 4, 9);
    const Eigen::RowVectorXd means = table.colwise().mean();
    const double within = (table.rowwise() - means).squaredNorm() / 27.0;
    const double between = 4.0 * (means.array() - table.mean()).square().sum() / 8.0;
    const bool isSingular = between < within;
    singular += isSingular ? 1 : 0;
    EXPECT_EQ(fit.IsSingular, isSingular);
    // The criterion is flat to 1e-11 at its minimum, so parameters are right to about 1e-6.
    EXPECT_NEAR(fit.SubjectCovariance(0, 0), std::max(0.0, 0.25 * (between - within)), 1e-5);
    EXPECT_NEAR(fit.ResidualVariance, isSingular ? (27.0 * within + 8.0 * between) / 35.0 : within,
                1e-5);
    EXPECT_NEAR(fit.Coefficients[0], table.mean(), 1e-12);
  }
  EXPECT_GT(singular, 3);
  EXPECT_LT(singular, 27);
}

double StudentT(const Eigen::ArrayXd& values)
{
  const auto count = static_cast<double>(values.size());
  return values.mean() * std::sqrt(count * (count - 1.0)) /
         (values - values.mean()).matrix().norm();
}

// Twenty subjects before and after: within subjects the paired t-test, between subjects the t-test
// of their means.
TEST(MixedModel, TestsOfBalancedSubjectsAreThoseOfStudent)
{
  RepeatedStudy study({20, 2, 2, 3.0, 0.0, 0.0, 1.0, 0.0, false}, 4);
  Eigen::ArrayXd change(20);
  Eigen::ArrayXd odd(10);
  Eigen::ArrayXd even(10);
  for (Eigen::Index i = 0; i < 20; ++i)
  {
    study.Fixed(2 * i, 1) = 0.0;
    study.Fixed(2 * i + 1, 1) = 1.0;
    change[i] = study.Outcome[2 * i + 1] - study.Outcome[2 * i];
    (i % 2 == 0 ? even : odd)[i / 2] = study.Outcome.segment(2 * i, 2).mean();
  }
  study.Fixed.conservativeResize(Eigen::NoChange, 3);
  const MixedFit fit = study.Fit();
  const FixedTest within = MixedModel::Test(fit, 1, 1);
  EXPECT_NEAR(within.DenominatorDegrees, 19.0, 1e-6);
  EXPECT_NEAR(within.F, std::pow(StudentT(change), 2), 1e-5 * within.F);
  EXPECT_NEAR(within.P, StudentTwoSided(StudentT(change), 19.0), 1e-6);
  const FixedTest between = MixedModel::Test(fit, 2, 1);
  const double rest =
      ((odd - odd.mean()).square().sum() + (even - even.mean()).square().sum()) / 18.0;
  EXPECT_NEAR(between.DenominatorDegrees, 18.0, 1e-6);
  EXPECT_NEAR(between.F, std::pow(odd.mean() - even.mean(), 2) / (0.2 * rest), 1e-5 * between.F);
  EXPECT_NEAR(MixedModel::ConfidenceWidth(fit, 2, 0.95),
              StudentQuantile(0.95, 18.0) * std::sqrt(0.2 * rest), 1e-5);
}

TEST(MixedModel, FollowsScalesAndShiftsOfOutcomeAndTime)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const RepeatedStudy study(RepeatedShape(), seed);
    RepeatedStudy other = study;
    other.Outcome = 1e4 * study.Outcome + study.Fixed * Eigen::Vector4d(1e5, -2e4, 3e3, 7.0);
    other.Times = (0.1 * study.Times).array() + 50.0;
    const MixedFit one = study.Fit();
    const MixedFit two = other.Fit();
    const double change = static_cast<double>(study.Outcome.size() - 4) * 2.0 * std::log(1e4);
    EXPECT_NEAR(two.Criterion, one.Criterion + change, 1e-8); // of about 500
    EXPECT_EQ(one.IsSingular, two.IsSingular);
    Eigen::Matrix2d toOther; // time = 10 other - 500
    toOther << 1.0, -500.0, 0.0, 10.0;
    const Eigen::Matrix2d expected = 1e8 * toOther * one.SubjectCovariance * toOther.transpose();
    EXPECT_LT((two.SubjectCovariance - expected).norm(), 1e-4 * expected.norm());
    const Eigen::Vector4d coefficients =
        1e4 * one.Coefficients + Eigen::Vector4d(1e5, -2e4, 3e3, 7.0);
    for (Eigen::Index k = 0; k < 4; ++k)
    {
      const double error = 1e4 * std::sqrt(one.Covariance(k, k));
      EXPECT_NEAR(two.Coefficients[k], coefficients[k], 1e-5 * error) << seed;
      EXPECT_NEAR(MixedModel::Test(one, k, 1).DenominatorDegrees,
                  MixedModel::Test(two, k, 1).DenominatorDegrees, 1e-3);
    }
  }
}

TEST(MixedModel, OrderOfRowsDoesNotMatter)
{
  const RepeatedStudy study(RepeatedShape(), 3);
  RepeatedStudy reversed = study;
  std::reverse(reversed.Subjects.begin(), reversed.Subjects.end());
  reversed.Times.reverseInPlace();
  reversed.Fixed = study.Fixed.colwise().reverse().eval();
  reversed.Outcome.reverseInPlace();
  EXPECT_NEAR(study.Fit().Criterion, reversed.Fit().Criterion, 1e-10);
}

TEST(MixedModel, FindsNothingInAnOutcomeWithoutResiduals)
{
  const RepeatedStudy study({12, 2, 4, 1.0, 0.0, 0.0, 1.0, 0.0, false}, 1);
  const MixedModel model = study.Model();
  Eigen::VectorXd ofSubjects(study.Outcome.size());
  for (Eigen::Index row = 0; row < ofSubjects.size(); ++row)
  {
    ofSubjects[row] =
        std::sin(1.0 + static_cast<double>(study.Subjects[static_cast<std::size_t>(row)]));
  }
  for (const Eigen::VectorXd& outcome :
       {ofSubjects, Eigen::VectorXd(study.Fixed * Eigen::Vector4d(1.0, 2.0, 3.0, 4.0)),
        Eigen::VectorXd(Eigen::VectorXd::Constant(ofSubjects.size(), NAN)),
        Eigen::VectorXd(Eigen::VectorXd::Zero(ofSubjects.size()))})
  {
    const MixedFit fit = model.Fit(outcome);
    EXPECT_FALSE(fit.IsFound);
    EXPECT_TRUE(std::isnan(fit.Coefficients[0]));
    EXPECT_TRUE(std::isnan(MixedModel::Test(fit, 1, 1).P));
    EXPECT_TRUE(std::isnan(MixedModel::ConfidenceWidth(fit, 1, 0.95)));
  }
}

TEST(MixedModel, RefusesVariancesThatCannotBeToldApart)
{
  const auto refusal =
      [](const RepeatedShape& shape, const std::function<void(RepeatedStudy&)>& change)
  {
    RepeatedStudy study(shape, 2);
    change(study);
    MixedModel model;
    return MixedModel::Make(study.Fixed, study.Subjects,
                            study.HasSlopes ? study.Times : Eigen::VectorXd(), model)
        .Message();
  };
  const auto nothing = [](RepeatedStudy&) {};
  EXPECT_NE(refusal({12, 1, 1, 1.0, 0.0, 0.0, 1.0, 0.0, false}, nothing).find("none has several"),
            std::string::npos);
  EXPECT_NE(refusal({1, 12, 12, 1.0, 0.0, 0.0, 1.0, 0.0, false},
                    [](RepeatedStudy& study) { study.Fixed.conservativeResize(12, 2); })
                .find("none has several"),
            std::string::npos);
  const auto atTwoTimes = [](RepeatedStudy& study)
  {
    for (Eigen::Index row = 0; row < study.Times.size(); ++row)
    {
      study.Times[row] = static_cast<double>(row % 2);
    }
  };
  EXPECT_NE(
      refusal({12, 2, 2, 1.0, 0.0, 0.0, 1.0, 0.0, true}, atTwoTimes).find("the times are too few"),
      std::string::npos);
  EXPECT_NE(refusal({12, 3, 3, 1.0, 0.0, 0.0, 1.0, 0.0, true},
                    [](RepeatedStudy& study) { study.Times.setConstant(5.0); })
                .find("the times are too few"),
            std::string::npos);
  EXPECT_EQ(refusal({12, 3, 3, 1.0, 0.0, 0.0, 1.0, 0.0, true}, nothing), "");
}

// How many of the null studies the tests of time, group, covariate and all three reject at 5 %.
std::array<int, 4> CountRejections(const RepeatedShape& shape, int count)
{
  std::array<int, 4> rejected{};
  for (int i = 0; i < count; ++i)
  {
    const MixedFit fit = RepeatedStudy(shape, static_cast<unsigned>(1000 + i)).Fit();
    for (Eigen::Index k = 0; k < 3; ++k)
    {
      rejected[static_cast<std::size_t>(k)] += MixedModel::Test(fit, k + 1, 1).P < 0.05 ? 1 : 0;
    }
    rejected[3] += MixedModel::Test(fit, 1, 3).P < 0.05 ? 1 : 0;
  }
  return rejected;
}

// Within 3.3 standard deviations of the binomial distribution, which one of a thousand counts
// leaves by chance.
double BinomialMargin(int count)
{
  return 3.3 * std::sqrt(0.05 * 0.95 * count);
}

TEST(MixedModelTypeOne, IsFivePercentWhereVariancesAreFound)
{
  const int count = ProofCount(2000, 20000);
  for (const RepeatedShape& shape : {RepeatedShape{40, 1, 5, 1.0, 0.5, 0.3, 1.0, 0.0, true},
                                     RepeatedShape{30, 4, 4, 1.0, 0.5, -0.3, 1.0, 0.0, true},
                                     RepeatedShape{24, 1, 3, 2.0, 0.0, 0.0, 1.0, 0.0, false},
                                     RepeatedShape{12, 3, 3, 2.0, 0.0, 0.0, 1.0, 0.0, false}})
  {
    for (const int rejected : CountRejections(shape, count))
    {
      EXPECT_NEAR(rejected, 0.05 * count, BinomialMargin(count)) << shape.Subjects;
    }
  }
}

// Half of these fits are singular. As the estimate of a variance of 0 is too large on average, and
// its uncertainty takes degrees of freedom away, such tests reject less.
TEST(MixedModelTypeOne, IsAtMostFivePercentWhereFitsAreSingular)
{
  const int count = ProofCount(1000, 10000);
  for (const RepeatedShape& shape : {RepeatedShape{10, 1, 5, 1.0, 0.5, 0.3, 1.0, 0.0, true},
                                     RepeatedShape{20, 2, 4, 1.0, 0.1, 0.0, 1.0, 0.0, true},
                                     RepeatedShape{20, 3, 3, 0.0, 0.0, 0.0, 1.0, 0.0, false}})
  {
    for (const int rejected : CountRejections(shape, count))
    {
      EXPECT_LT(rejected, 0.05 * count + BinomialMargin(count)) << shape.Subjects;
    }
  }
}
} // namespace
} // namespace palpate::test
