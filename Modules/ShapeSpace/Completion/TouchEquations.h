#pragma once

#include "HarmonicTurns.h"
#include "SphericalHarmonicBasis.h"
#include "SurfaceTouch.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace palpate
{
/// A surface about a centre: ln(radius / mm) as harmonics.
struct LogSurface
{
  Eigen::VectorXd Coefficients;
  Vector3 CenterWorld = Vector3::Zero(); ///< mm
};

/// How touches disagree with a surface, in mm and rad, and the derivatives. With u, r direction and
/// distance of a point from the centre, f the logarithm and v = u - grad f, the outward normal's
/// direction: a point's residual is its distance from the surface to first order,
/// r (ln r - f(u)) / |v|; those of a normal are the cosines between v and two tangents. A point
/// outside has a residual only while the surface reaches beyond it. All derivatives are exact, so
/// that a Gauss-Newton step always descends.
class TouchEquations
{
public:
  /// What a surface of a degree leaves out, mm: part of each point's variance.
  static constexpr double ModelDeviation = 0.4;
  /// Of normals, 0.2 of the touch and as much as such a surface leaves out, rad.
  static constexpr double NormalDeviation = 0.3;
  static constexpr double StrokeDeviation = SurfaceTouch::StrokeDeviation; ///< mm

  explicit TouchEquations(int degree);

  /// Keeps a copy. Allocates if there are more of them than ever before.
  void SetTouches(const std::vector<SurfaceTouch>& touches);
  Eigen::Index Rows() const noexcept { return this->Values.size(); }
  std::size_t TouchCount() const noexcept { return this->Touches.size(); }

  /// Evaluates the residuals and their derivatives. Does not allocate.
  void Evaluate(const LogSurface& surface) noexcept;

  const Eigen::VectorXd& Residuals() const noexcept { return this->Values; }
  /// Derivatives by the coefficients, a column each row of the equations, and by the centre.
  const Eigen::MatrixXd& ByCoefficients() const noexcept { return this->Slopes; }
  const Eigen::Matrix3Xd& ByCenter() const noexcept { return this->CenterSlopes; }
  /// Adds the residuals' covariance.
  void AddCovariance(Eigen::MatrixXd& matrix) const noexcept;
  /// The inverse of that covariance times the residuals.
  const Eigen::VectorXd& Weights() const noexcept { return this->Weighted; }
  /// The residuals' square in units of their covariance.
  double Misfit() const noexcept { return this->Values.dot(this->Weighted); }

  /// RMS of the distances of the points on the surface, and what their noise makes likely; mm.
  double Distance() const noexcept;
  double ExpectedDistance() const noexcept { return palpate::ExpectedDistance(this->Touches); }

private:
  struct Place;
  Place PlaceOf(const SurfaceTouch& touch, const LogSurface& surface) noexcept;
  void PointRow(const Place& place, Eigen::Index row) noexcept;
  void TangentRow(const Place& place, const Vector3& tangent, Eigen::Index row) noexcept;
  void Weigh() noexcept;
  void PrepareDerivatives(const LogSurface& surface) noexcept;

  SphericalHarmonicBasis Basis;
  HarmonicTurns Turns;
  std::vector<SurfaceTouch> Touches;
  std::vector<int> StrokeOf; // of each row, from 0; -1: none
  Eigen::Index StrokeCount = 0;
  std::array<Eigen::VectorXd, 3> First;  // D f
  std::array<Eigen::VectorXd, 9> Second; // D D f, the first D fastest
  Eigen::VectorXd Harmonics;             // at a touch
  Eigen::VectorXd Turned;
  Eigen::VectorXd Values;
  Eigen::VectorXd Variances;
  Eigen::VectorXd Weighted;
  Eigen::VectorXd StrokeSums; // a residual and a weight for each stroke
  Eigen::MatrixXd Slopes;
  Eigen::Matrix3Xd CenterSlopes;
};
} // namespace palpate
