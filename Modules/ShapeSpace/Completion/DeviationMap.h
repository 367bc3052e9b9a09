#pragma once

#include "ShapeCompletion.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// How sure a completed surface is, along directions from its centre: standard deviations of its
/// displacement along its normals. Keeps what depends on prior and directions alone. Not
/// thread-safe.
class DeviationMap
{
public:
  /// What a surface of the prior's degree leaves out, mm: part of every standard deviation.
  static constexpr double LeftOut = 0.3;

  /// At the directions of an icosahedron of this frequency (8: 642 directions).
  DeviationMap(std::shared_ptr<const ShapePrior> prior, int frequency);

  const std::vector<Vector3>& Directions() const noexcept { return this->Rays; }

  /// Standard deviations (mm), one for each direction. `completion` must have the same prior, or
  /// one of the same covariance, as all of ShapePrior::Smooth are.
  /// Allocates little for as many touches as before.
  const Eigen::VectorXd& Evaluate(const ShapeCompletion& completion);
  /// Where to touch next, mm: `count` points of the surface in these directions, each as
  /// ChooseTouches has them. Before any touch, the places depend on the prior alone. Allocates;
  /// some ten ms for 362 directions.
  std::vector<Vector3> NextTouches(const ShapeCompletion& completion, int count);

private:
  void Locate(const LogSurface& surface);

  std::shared_ptr<const ShapePrior> Given;
  HarmonicTurns Turns;
  std::vector<Vector3> Rays;
  std::vector<double> SolidAngles;
  Eigen::MatrixXd Harmonics;      // coefficients x directions
  Eigen::VectorXd PriorVariances; // of the logarithm
  Eigen::MatrixX3d Turned;        // of the last surface
  // The same for each direction:
  Eigen::VectorXd Radii;
  Eigen::Matrix3Xd Normals;
  Eigen::VectorXd Lengths; // by what a change of the logarithm moves the surface, mm
  Eigen::MatrixXd Known;   // L^-1 times the covariance of rows and directions
  Eigen::VectorXd Deviations;
};

/// The places, first the best one, of which each touch, of standard deviation 1 mm, makes the
/// variance over the surface's area least, given the former ones (A-optimal design, Chaloner and
/// Verdinelli, Statistical Science 10, 1995). `covariance` (mm^2) is that of the displacements at
/// all places.
std::vector<Eigen::Index> ChooseTouches(Eigen::MatrixXd covariance, const Eigen::VectorXd& areas,
                                        int count);
} // namespace palpate
