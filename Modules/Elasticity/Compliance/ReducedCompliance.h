#pragma once

#include "HertzPatch.h"
#include "HexElasticity.h"
#include "KernelProgress.h"
#include "StarMesh.h"
#include "Status.h"

#include <Eigen/Core>

#include <vector>

namespace palpate
{
/// What is kept of an elastic organ: displacements of its surface under tractions, both in real
/// spherical harmonics of the organ's directions up to a degree. For tractions t(d) = sum t_lm
/// Y_lm(d) per solid angle (N/sr), u_lm = C t_lm is the projection of the displacement (mm), with
///
///     C = B' K^-1 B,   B_i,lm = integral of N_i Y_lm over the unit sphere
///
/// for the stiffness K and the shape functions N_i of the surface: symmetric and positive definite
/// by construction (Galerkin). Entry c (L+1)^2 + l(l+1) + m belongs to component c.
class ReducedCompliance
{
public:
  static constexpr int MostDegree = 24;

  /// `degree` from 0 to MostDegree. Fails where the equations have no solution, as of an organ that
  /// nothing holds, and if `progress` cancels. Allocates.
  static Status Make(const StarMesh& mesh, const StiffnessMatrix& stiffness, int degree,
                     const KernelProgress& progress, ReducedCompliance& compliance);

  /// Of a matrix of 3 (degree + 1)^2 rows, symmetric.
  static ReducedCompliance Of(int degree, Eigen::MatrixXd matrix);

  int Degree() const noexcept { return this->MaximumDegree; }
  /// mm/N times sr; 3 (L+1)^2 rows.
  const Eigen::MatrixXd& Matrix() const noexcept { return this->Values; }

  /// Up to a degree that is not higher.
  ReducedCompliance Truncated(int degree) const;

  /// Coefficients (mm) of the displacement's components, in columns, under a unit force on a patch
  /// against its normal; waves near the degree limit in part (Window), in force and displacement.
  /// Allocates.
  Eigen::MatrixX3d Displacement(const HertzPatch& patch) const;
  /// Mean of that displacement over the patch, against its normal, mm/N.
  double Compliance(const HertzPatch& patch) const;
  /// Of several patches with one normal. Allocates.
  std::vector<double> Compliances(const Vector3& normal,
                                  const std::vector<HertzPatch>& patches) const;

  /// How much of a wave belongs to the harmonics: 1 up to half the degree limit, 0 beyond the
  /// limit; `degree` need not be whole.
  static double Window(double degree, int degreeLimit) noexcept;

private:
  /// Against the normal, per solid angle, with the window; (L+1)^2 rows.
  Eigen::VectorXd Pressure(const HertzPatch& patch) const;

  int MaximumDegree = 0;
  Eigen::MatrixXd Values;
};
} // namespace palpate
