#pragma once

#include "ShapeModes.h"

#include <Eigen/Core>

#include <vector>

namespace palpate
{
/// A case as the modes of all other cases describe it.
struct LeftOutModes
{
  Eigen::VectorXd
      Variances;           ///< of the other cases' scores in each of their modes, mm^2, descending
  Eigen::VectorXd Squares; ///< of the case's scores in these modes, about the others' mean, mm^2
  double Outside = 0.0;    ///< squared distance from what all these modes can describe, mm^2
};

/// The modes of a group without some case, and its scores in them, without another decomposition:
/// the others' scatter is that of the group minus a matrix of rank one, so its eigenvalues are the
/// roots of a secular equation between those of the group, and a root's slope is the score (Golub,
/// SIAM Review 15, 1973; the iteration is the middle way of Li, LAPACK Working Note 89, 1993).
/// Exact up to rounding. Time grows with the square of the number of modes. Modes whose variances
/// are equal up to rounding are arbitrary, as in any decomposition.
class LeftOutSolver
{
public:
  /// `modes` must outlive the solver, whose memory grows with the number of modes only.
  explicit LeftOutSolver(const ShapeModes& modes);

  /// The modes without case (row of the scores) `leftOut`; none if there are fewer than three
  /// cases.
  LeftOutModes Solve(Eigen::Index leftOut);

private:
  /// Sums over the poles not below a root, and over those below it, with their derivatives.
  struct Sums
  {
    double Upper = 0.0;
    double UpperSlope = 0.0;
    double Lower = 0.0;
    double LowerSlope = 0.0;

    double Value() const { return 1.0 - this->Upper - this->Lower; }
    double Slope() const { return this->UpperSlope + this->LowerSlope; }
    double Size() const { return 1.0 + this->Upper - this->Lower; }
  };
  struct Root
  {
    double Scatter;
    double Square;
  };

  void Deflate(Eigen::Index leftOut);
  Sums SumsAt(Eigen::Index pole, double offset);
  void AddRoot(Eigen::Index pole);
  void AddLastRoot();
  double FindRoot(Eigen::Index pole, double low, double high, double start, Sums& sums);
  double Step(Eigen::Index pole, double offset, const Sums& sums) const;

  const ShapeModes& Modes;
  Eigen::Index Cases;
  double Factor;           // of the rank-one matrix: cases / (cases - 1)
  Eigen::VectorXd Scatter; // sums of squared scores of each mode
  // Of one case: the poles that count, the weights of their terms, and where a root is sought.
  Eigen::Index Count = 0;
  Eigen::ArrayXd Poles;
  Eigen::ArrayXd Weights;
  Eigen::ArrayXd Offsets; // of the poles from the origin of the search
  Eigen::ArrayXd Terms;
  Eigen::ArrayXd Differences;
  std::vector<Root> Roots;
};
} // namespace palpate
