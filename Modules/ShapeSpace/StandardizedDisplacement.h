#pragma once

#include "NormalDisplacement.h"
#include "ShapeModes.h"

#include <Eigen/Core>

namespace palpate
{
/// Where on the surface a case is unusual: at each point of the group's mean, the case's
/// displacement along the normal from the mean of all other cases, over these others' standard
/// deviation there.
class StandardizedDisplacement
{
public:
  /// `mean` of the group's mean shape.
  StandardizedDisplacement(const NormalDisplacement& mean, const ShapeModes& modes);

  /// Standard deviation of all cases at each point, mm.
  Eigen::VectorXd Deviations() const;
  /// Of a case (row of the scores): positive outside. If displacements are normal, a value times
  /// sqrt((n - 1) / n) has Student's distribution with n - 2 degrees of freedom, for n cases.
  /// Deviations below a nanometre count as a nanometre; 0 everywhere if there are fewer than three
  /// cases.
  Eigen::VectorXd Of(Eigen::Index leftOut) const;

private:
  Eigen::MatrixXd PerScore; // points x modes
  Eigen::MatrixXd Scores;   // modes x cases
  Eigen::ArrayXd Squares;   // of all cases together at each point, mm^2
};
} // namespace palpate
