#pragma once

#include "ShapePrior.h"
#include "TouchEquations.h"

#include <memory>
#include <optional>
#include <vector>

namespace palpate
{
/// An organ's surface from a few touches and a prior: the most probable one (MAP), and how sure it
/// is. Gauss-Newton steps in the space of the observations (iterated Kalman filter, Bell and
/// Cathey, IEEE TAC 38, 1993), some with a former step's factor, each halved until the posterior
/// grows, from the last surface and, where touches stay off, from the prior's and from a sphere.
/// Not thread-safe.
class ShapeCompletion
{
public:
  static constexpr std::size_t MostTouches = SurfaceTouch::Most;
  static constexpr double CenterDeviation = 6.0; ///< of the click from the centroid, mm

  /// `clickWorld` (mm): near the organ's centre.
  ShapeCompletion(std::shared_ptr<const ShapePrior> prior, const Vector3& clickWorld);

  /// Completes the surface by all touches so far, none included, starting from that of the last
  /// call. Fails, and leaves everything as it was, for touches that CheckTouches refuses.
  /// Allocates little for as many touches as before.
  Status Update(const std::vector<SurfaceTouch>& touches);

  const LogSurface& Surface() const noexcept { return this->Last.Surface; }
  /// The same as a radial model of the prior's degree. Allocates.
  RadialModel Model() const;
  /// RMS of the distances of the points from the surface (mm), and the most that touches of an
  /// organ like those of the prior leave: beyond it, it is not star-shaped or they are wrong.
  double Distance() const noexcept { return this->Equations.Distance(); }
  double LargestDistance() const noexcept
  {
    return 1.2 * this->Equations.ExpectedDistance() + TouchEquations::ModelDeviation;
  }
  /// Fails if Distance is above LargestDistance.
  Status Judge() const;
  int Steps() const noexcept { return this->StepCount; } ///< of the last call

  const std::shared_ptr<const ShapePrior>& Prior() const noexcept { return this->Given; }
  /// The covariance between the state (coefficients, then centre) and the rows of touches, and the
  /// factor L of the touches' own: the posterior covariance of a linear function j of the state is
  /// j' P j - |L^-1 (rows j)|^2, with P the prior's. For DeviationMap.
  Eigen::Index Rows() const noexcept { return this->Equations.Rows(); }
  const Eigen::MatrixXd& Gain() const noexcept { return this->PriorBySlopes; }
  const Eigen::Matrix3Xd& CenterGain() const noexcept { return this->CenterBySlopes; }
  const Eigen::MatrixXd& Factor() const noexcept { return this->System; }

private:
  // A surface, and P^-1 times its difference from the prior's mean.
  struct State
  {
    LogSurface Surface;
    Eigen::VectorXd Pull;
    Vector3 CenterPull = Vector3::Zero();
    double Cost = 0.0;
  };

  bool FitsBadly() const noexcept;
  State PriorState() const;
  State SphereState(const std::vector<SurfaceTouch>& touches) const;
  void Descend(State& state);
  void Factorise();
  void FindTarget(const State& state);
  void FindCloser(const State& state);
  bool Approach(State& state);
  bool Step(State& state);
  void Close(State& state);
  double CostOf(const State& state);
  double ChangeBetween(const State& one, const State& other) const;

  std::shared_ptr<const ShapePrior> Given;
  Vector3 Click;
  TouchEquations Equations;
  State Last;
  State Target; // of the step
  State Trial;
  Eigen::MatrixXd PriorBySlopes;
  Eigen::Matrix3Xd CenterBySlopes;
  Eigen::MatrixXd System; // of the rows; its lower triangle becomes the factor
  // Of the rows when it was made:
  Eigen::MatrixXd Slopes;
  Eigen::Matrix3Xd CenterSlopes;
  Eigen::VectorXd Weights;
  Eigen::VectorXd Gradient; // of the cost by the coefficients
  int StepCount = 0;
};

/// A completion in one call. Without a prior: ShapePrior::Smooth about a sphere of the touches'
/// mean distance from the centre; without a click: the middle of their box. Fails as Update does,
/// and without a click for no touch on the surface. Does not judge.
Status CompleteSurface(const std::vector<SurfaceTouch>& touches,
                       std::shared_ptr<const ShapePrior> priorOrNull,
                       const std::optional<Vector3>& clickWorld,
                       std::unique_ptr<ShapeCompletion>& made);
} // namespace palpate
