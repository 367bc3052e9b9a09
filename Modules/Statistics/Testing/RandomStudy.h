#pragma once

#include "Covariates.h"
#include "LinearDesign.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace palpate::test
{
/// Cases with an age (years), a PSA (log-normal, ng/ml), one of three centres and a sex.
inline CovariateTable RandomCovariates(int count, unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<std::string> names;
  std::vector<std::string> ages;
  std::vector<std::string> psas;
  std::vector<std::string> centers;
  std::vector<std::string> sexes;
  for (int i = 0; i < count; ++i)
  {
    names.push_back("case" + std::to_string(i));
    ages.push_back(std::to_string(65.0 + 7.0 * normal(random)));
    psas.push_back(std::to_string(std::exp(2.0 + 0.6 * normal(random))));
    centers.push_back(std::vector<std::string>{"PCNN", "RUMC", "ZGT"}[random() % 3]);
    sexes.push_back(std::vector<std::string>{"f", "m"}[random() % 2]);
  }
  CovariateTable table(names);
  table.Add("age", ages);
  table.Add("psa", psas);
  table.Add("center", centers);
  table.Add("sex", sexes);
  return table;
}

inline Eigen::MatrixXd RandomOutcomes(Eigen::Index rows, Eigen::Index columns, unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

inline ModelFormula FormulaOf(const std::string& text)
{
  ModelFormula formula;
  const Status status = ModelFormula::Parse(text, formula);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return formula;
}

inline LinearDesign DesignOf(const CovariateTable& table, const std::string& formula)
{
  LinearDesign design;
  const Status status = MakeLinearDesign(table, FormulaOf(formula), {}, design);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return design;
}

/// The sentence with which a formula or its design is refused; empty if it is not.
inline std::string RefusalOf(const CovariateTable& table, const std::string& text,
                             const std::map<std::string, std::string>& references = {})
{
  ModelFormula formula;
  LinearDesign design;
  Status status = ModelFormula::Parse(text, formula);
  if (status.IsOk())
  {
    status = MakeLinearDesign(table, formula, references, design);
  }
  return status.Message();
}
} // namespace palpate::test
