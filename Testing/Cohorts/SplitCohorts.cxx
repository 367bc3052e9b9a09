#include "SplitCohorts.h"

#include "LinearModel.h"
#include "MultivariateTest.h"
#include "PermutationTest.h"
#include "ShapeModes.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace palpate::test
{
namespace
{
constexpr int Frequency = 8; // 642 points
constexpr Eigen::Index Scores = 10;

LinearDesign DesignOf(const std::vector<std::string>& groups, const std::vector<double>& volumes)
{
  CovariateTable table(groups);
  table.Add("group", groups);
  std::vector<std::string> texts;
  for (const double volume : volumes)
  {
    texts.push_back(std::to_string(volume));
  }
  table.Add("volume", texts);
  ModelFormula formula;
  LinearDesign design;
  const Status parsed = ModelFormula::Parse("~ group + volume", formula);
  const Status made = MakeLinearDesign(table, formula, {}, design);
  if (!parsed.IsOk() || !made.IsOk())
  {
    throw std::runtime_error(made.Message());
  }
  return design;
}
} // namespace

SplitCohorts::SplitCohorts(CohortGroup group, std::uint64_t seed)
    : Group(std::move(group)),
      Mean(FindNormalDisplacement(ShapeOf(this->Group, -1, 0.0), Frequency)),
      Coefficients(CoefficientsOf(this->Group)), Random(seed)
{
}

Eigen::VectorXd SplitCohorts::BumpCoefficients(const SplitSettings& settings, std::size_t center)
{
  Eigen::VectorXd bump(static_cast<Eigen::Index>(this->Mean.Points.size()));
  for (std::size_t p = 0; p < this->Mean.Points.size(); ++p)
  {
    const double distance =
        (this->Mean.Points[p] - this->Mean.Points[center]).norm() / settings.Extent;
    const double cosine = distance < 0.5 ? std::cos(M_PI * distance) : 0.0;
    bump[static_cast<Eigen::Index>(p)] = settings.Bump * cosine * cosine;
  }
  return Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(this->Mean.PerCoefficient)
      .solve(bump);
}

SplitResult SplitCohorts::Next(const SplitSettings& settings)
{
  std::vector<Eigen::Index> order(this->Group.Rows.size());
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  for (std::size_t left = order.size(); left > 1; --left)
  {
    std::swap(order[left - 1], order[this->Random() % left]);
  }
  const Eigen::Index count = 2 * Eigen::Index{settings.PerGroup};
  const std::size_t center = this->Random() % this->Mean.Points.size();
  const Eigen::VectorXd bump = this->BumpCoefficients(settings, center);
  Eigen::MatrixXd drawn(count, this->Coefficients.cols());
  std::vector<std::string> groups;
  std::vector<double> volumes;
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const Eigen::Index row = order[static_cast<std::size_t>(i)];
    drawn.row(i) = this->Coefficients.row(row);
    groups.push_back(i % 2 == 0 ? "a" : "b");
    volumes.push_back(this->Group.Bodies[static_cast<std::size_t>(row)].Volume / 1000.0);
    if (i % 2 == 1)
    {
      drawn.row(i) += bump.transpose();
    }
  }
  const LinearDesign design = DesignOf(groups, volumes);
  const Eigen::MatrixXd moved = drawn * this->Mean.PerCoefficient.transpose();
  ShapeModes modes;
  MultivariateTest scores;
  PermutationTest points;
  PermutationSettings permutations;
  permutations.Count = settings.Permutations;
  permutations.Seed = this->Random();
  if (!FindShapeModes(drawn, modes).IsOk() ||
      !TestTogether(design, design.Terms[0], modes.Scores.leftCols(Scores), scores).IsOk() ||
      !TestByPermutation(FindEffectSpace(design, design.Terms[0]), moved,
                         {this->Mean.Areas, this->Mean.Edges}, permutations, {}, points)
           .IsOk())
  {
    throw std::runtime_error("a test failed");
  }
  const Eigen::VectorXd place = this->Mean.PerCoefficient * bump;
  const Eigen::MatrixXd known = moved * place;
  const double ideal =
      settings.Bump > 0.0
          ? TestTerm(design, design.Terms[0], FitLinearModel(design, known), known).P[0]
          : 1.0;
  return {scores.Pillai.P,
          points.WholeP,
          points.FamilyP.minCoeff(),
          points.EnhancedP.minCoeff(),
          ideal,
          points.P[static_cast<Eigen::Index>(center)]};
}
} // namespace palpate::test
