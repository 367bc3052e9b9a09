#include "ProofCount.h"
#include "RProgram.h"
#include "RepeatedStudy.h"

#include <array>
#include <map>

namespace palpate::test
{
namespace
{
constexpr std::array<RepeatedShape, 9> JudgedShapes{
    {{12, 1, 5, 1.0, 0.3, 0.3, 1.0, 0.0, true},    // unbalanced
     {15, 4, 4, 1.0, 0.3, -0.5, 1.0, 0.0, true},   // as many visits of each
     {30, 1, 3, 1.0, 0.5, 0.0, 1.0, 0.0, false},   // one visit of some, intercepts alone
     {20, 3, 3, 0.0, 0.0, 0.0, 1.0, 0.0, false},   // subjects alike
     {14, 2, 5, 0.0, 0.0, 0.0, 1.0, 0.0, true},    // alike, with slopes
     {10, 3, 6, 30.0, 5.0, 0.9, 1e-3, 1e3, true},  // large variances, small units
     {40, 2, 4, 0.5, 0.2, 0.99, 1e5, -1e6, true},  // large units
     {25, 2, 3, 300.0, 0.0, 0.0, 1.0, 0.0, false}, // hardly any residuals
     {60, 1, 8, 1.0, 0.4, 0.2, 1.0, 50.0, true}}};

// All in one table, as R takes seconds to start.
class JudgedStudies
{
public:
  explicit JudgedStudies(unsigned seeds)
  {
    for (const RepeatedShape& shape : JudgedShapes)
    {
      for (unsigned seed = 0; seed < seeds; ++seed)
      {
        this->Add(RepeatedStudy(shape, seed));
      }
    }
  }
  std::vector<double> Ask(const std::string& what) const
  {
    CovariateTable table(this->Columns.at("study"));
    for (const auto& [name, texts] : this->Columns)
    {
      table.Add(name, texts);
    }
    const RProgram judge;
    const std::vector<double> said = judge.Run(
        table,
        Eigen::Map<const Eigen::VectorXd>(this->Outcomes.data(),
                                          static_cast<Eigen::Index>(this->Outcomes.size())),
        "library(lme4)\nd$y <- y[, 1]\n"
        "judge <- function(d) { m <- suppressMessages(suppressWarnings(lmer(if (d$slopes[1] == 1) "
        "y ~ time + group + x + (time | subject) else y ~ time + group + x + (1 | subject), d, "
        "control = lmerControl(optimizer = 'bobyqa', optCtrl = list(rhoend = 1e-9, maxfun = "
        "1e5)))))\n" +
            what + " }\nfor (i in seq_len(max(d$study))) judge(droplevels(d[d$study == i, ]))");
    EXPECT_FALSE(said.empty()) << judge.Log();
    return said;
  }

  std::vector<RepeatedStudy> Studies;

private:
  void Add(const RepeatedStudy& study)
  {
    this->Studies.push_back(study);
    for (Eigen::Index row = 0; row < study.Fixed.rows(); ++row)
    {
      const auto subject = study.Subjects[static_cast<std::size_t>(row)];
      this->Columns["study"].push_back(std::to_string(this->Studies.size()));
      this->Columns["slopes"].emplace_back(study.HasSlopes ? "1" : "0");
      this->Columns["subject"].push_back("s" + std::to_string(subject));
      this->Columns["time"].push_back(ExactText(study.Fixed(row, 1)));
      this->Columns["group"].emplace_back(study.Fixed(row, 2) == 0.0 ? "a" : "b");
      this->Columns["x"].push_back(ExactText(study.Fixed(row, 3)));
      this->Outcomes.push_back(study.Outcome[row]);
    }
  }

  std::map<std::string, std::vector<std::string>> Columns;
  std::vector<double> Outcomes;
};

bool HasPackage(const std::string& name)
{
  const std::string command = "Rscript --vanilla -e 'library(" + name + ")' >/dev/null 2>&1";
  return std::system(command.c_str()) == 0; // NOLINT: a fixed text
}

// The judge stops at 1e-9 of its parameters, so estimates differ by parts of 1e-5 where the
// criterion is flat.
constexpr double JudgeTolerance = 1e-4;

TEST(MixedModelAgainstR, FindsNoWorseCriterionAndTheSameEstimates)
{
  if (!HasPackage("lme4"))
  {
    GTEST_SKIP() << "R's lme4 (r-cran-lme4), the judge, is not installed";
  }
  const JudgedStudies judged(static_cast<unsigned>(ProofCount(5, 60)));
  const std::vector<double> all =
      judged.Ask("v <- VarCorr(m)[[1]]; out(c(REMLcrit(m), fixef(m), sqrt(diag(as.matrix("
                 "vcov(m)))), sigma(m), v, rep(0, 4 - length(v))))");
  ASSERT_EQ(all.size(), 14 * judged.Studies.size());
  std::size_t stuck = 0;
  for (std::size_t i = 0; i < judged.Studies.size(); ++i)
  {
    const double* said = all.data() + 14 * i;
    const MixedFit fit = judged.Studies[i].Fit();
    EXPECT_LT(fit.Criterion, said[0] + 1e-6) << i;
    if (fit.Criterion < said[0] - 1e-8)
    {
      ++stuck; // the judge has not reached the minimum
      continue;
    }
    for (Eigen::Index k = 0; k < 4; ++k)
    {
      const double error = said[5 + k];
      EXPECT_NEAR(fit.Coefficients[k], said[1 + k], JudgeTolerance * error) << i;
      EXPECT_NEAR(std::sqrt(fit.PlainCovariance(k, k)), error, JudgeTolerance * error) << i;
    }
    EXPECT_NEAR(std::sqrt(fit.ResidualVariance), said[9], JudgeTolerance * said[9]) << i;
    for (Eigen::Index k = 0; k < 4; ++k)
    {
      const double size = std::sqrt(said[10 + k / 2 * 3] * said[10 + k % 2 * 3]);
      EXPECT_NEAR(fit.SubjectCovariance.data()[k], said[10 + k],
                  JudgeTolerance * (10.0 * said[9] * said[9] + size))
          << i;
    }
  }
  EXPECT_LE(stuck, judged.Studies.size() / 20);
}

TEST(MixedModelAgainstR, AgreesInTheTestsOfKenwardAndRoger)
{
  if (!HasPackage("pbkrtest"))
  {
    GTEST_SKIP() << "R's pbkrtest (r-cran-pbkrtest), the judge, is not installed";
  }
  const JudgedStudies judged(1);
  const std::vector<double> all = judged.Ask(
      "library(pbkrtest); out(diag(as.matrix(vcovAdj(m)))); for (l in list(c(0, 1, 0, 0), c(0, 0, "
      "1, 0), rbind(c(0, "
      "1, 0, 0), c(0, 0, 1, 0)))) { t <- KRmodcomp(m, rbind(l))$test['Ftest', ]; out(c(t$stat, "
      "t$ddf, t$p.value)) }");
  ASSERT_EQ(all.size(), 13 * judged.Studies.size());
  const std::array<std::pair<Eigen::Index, Eigen::Index>, 3> terms{{{1, 1}, {2, 1}, {1, 2}}};
  for (std::size_t i = 0; i < judged.Studies.size(); ++i)
  {
    const double* said = all.data() + 13 * i;
    const MixedFit fit = judged.Studies[i].Fit();
    for (Eigen::Index k = 0; k < 4; ++k)
    {
      EXPECT_NEAR(fit.Covariance(k, k) / said[k], 1.0, 10.0 * JudgeTolerance) << i;
    }
    for (std::size_t k = 0; k < terms.size(); ++k)
    {
      const FixedTest test = MixedModel::Test(fit, terms[k].first, terms[k].second);
      EXPECT_NEAR(test.F / said[4 + 3 * k], 1.0, 10.0 * JudgeTolerance) << i;
      EXPECT_NEAR(test.DenominatorDegrees / said[5 + 3 * k], 1.0, 10.0 * JudgeTolerance) << i;
      EXPECT_NEAR(test.P, said[6 + 3 * k], 10.0 * JudgeTolerance) << i;
    }
  }
}
} // namespace
} // namespace palpate::test
