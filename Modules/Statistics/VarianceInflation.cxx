#include "VarianceInflation.h"

#include "DecimalText.h"

#include <Eigen/Dense>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double NotedInflation = 5.0;

/// The columns of terms, each with a mean of 0 and the length 1.
Eigen::MatrixXd Standardised(const LinearDesign& design, const DesignTerm& term)
{
  Eigen::MatrixXd columns = design.Matrix.middleCols(term.First, term.Count);
  columns.rowwise() -= columns.colwise().mean().eval();
  columns.colwise().normalize();
  return columns;
}

/// The name of the other term that has the column most correlated with one of the term's.
std::string NearestTerm(const LinearDesign& design, const DesignTerm& term)
{
  const Eigen::MatrixXd columns = Standardised(design, term);
  double most = -1.0;
  std::string name;
  for (const DesignTerm& other : design.Terms)
  {
    const double correlation =
        other.First == term.First
            ? -1.0
            : (columns.transpose() * Standardised(design, other)).cwiseAbs().maxCoeff();
    if (correlation > most)
    {
      most = correlation;
      name = other.Name;
    }
  }
  return name;
}
} // namespace

double VarianceInflation(const LinearDesign& design, const DesignTerm& term)
{
  const Eigen::MatrixXd columns = Standardised(design, term);
  Eigen::MatrixXd others(design.Matrix.rows(), 0);
  for (const DesignTerm& other : design.Terms)
  {
    if (other.First != term.First)
    {
      others.conservativeResize(Eigen::NoChange, others.cols() + other.Count);
      others.rightCols(other.Count) = Standardised(design, other);
    }
  }
  if (term.IsInteraction || others.cols() == 0)
  {
    return 1.0;
  }
  const Eigen::MatrixXd rest = columns - others * others.householderQr().solve(columns);
  const double inflation =
      (columns.transpose() * columns).determinant() / (rest.transpose() * rest).determinant();
  return std::pow(inflation, 1.0 / static_cast<double>(term.Count));
}

std::vector<std::string> InflationNotes(const LinearDesign& design)
{
  std::vector<std::string> notes;
  for (const DesignTerm& term : design.Terms)
  {
    const double inflation = term.IsTested ? VarianceInflation(design, term) : 1.0;
    if (inflation > NotedInflation)
    {
      notes.push_back(term.Name + " is nearly a combination of the other covariates (variance " +
                      "inflation " + SignificantText(inflation, 3) + ", most correlated with " +
                      NearestTerm(design, term) +
                      "): their effects cannot be told apart, and neither may be significant; " +
                      "leave one of them out");
    }
  }
  return notes;
}
} // namespace palpate
