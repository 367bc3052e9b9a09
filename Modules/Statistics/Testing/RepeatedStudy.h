#pragma once

#include "MixedModel.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace palpate::test
{
/// How the outcomes of a study with several visits of each subject are made.
struct RepeatedShape
{
  int Subjects = 12;
  int LeastVisits = 1;
  int MostVisits = 5;
  double Intercept = 1.0; ///< standard deviations; that of residuals is 1
  double Slope = 0.3;
  double Correlation = 0.3;
  double Scale = 1.0;
  double Shift = 0.0;
  bool HasSlopes = true;
};

/// Visits at about whole years, every second subject in group b, and a covariate of each visit.
struct RepeatedStudy
{
  std::vector<Eigen::Index> Subjects;
  Eigen::VectorXd Times;
  Eigen::MatrixXd Fixed; ///< 1, time, group b, covariate
  Eigen::VectorXd Outcome;
  bool HasSlopes;

  RepeatedStudy(const RepeatedShape& shape, unsigned seed) : HasSlopes(shape.HasSlopes)
  {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<std::array<double, 4>> rows;
    std::vector<double> values;
    for (int i = 0; i < shape.Subjects; ++i)
    {
      const int visits =
          std::uniform_int_distribution<int>(shape.LeastVisits, shape.MostVisits)(random);
      const double one = normal(random);
      const double two = normal(random);
      const double intercept = shape.Intercept * one;
      const double slope =
          shape.Slope *
          (shape.Correlation * one + std::sqrt(1.0 - shape.Correlation * shape.Correlation) * two);
      for (int visit = 0; visit < visits; ++visit)
      {
        const double time = visit + 0.1 * normal(random);
        rows.push_back({1.0, time, i % 2 == 0 ? 0.0 : 1.0, normal(random)});
        values.push_back(shape.Shift + shape.Scale * (intercept + slope * time + normal(random)));
        this->Subjects.push_back(i);
      }
    }
    const auto count = static_cast<Eigen::Index>(rows.size());
    this->Outcome = Eigen::Map<const Eigen::VectorXd>(values.data(), count);
    this->Fixed.resize(count, 4);
    for (Eigen::Index row = 0; row < count; ++row)
    {
      this->Fixed.row(row) =
          Eigen::Map<const Eigen::RowVector4d>(rows[static_cast<std::size_t>(row)].data());
    }
    this->Times = this->Fixed.col(1);
  }
  MixedModel Model() const
  {
    MixedModel model;
    const Status status = MixedModel::Make(
        this->Fixed, this->Subjects, this->HasSlopes ? this->Times : Eigen::VectorXd(), model);
    EXPECT_TRUE(status.IsOk()) << status.Message();
    return model;
  }
  MixedFit Fit() const { return this->Model().Fit(this->Outcome); }
};
} // namespace palpate::test
