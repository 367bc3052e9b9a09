#pragma once

#include "LayeredSphere.h"

#include <Eigen/Core>

namespace palpate::test
{
/// Frictionless contact of a rigid ball with an elastic layered sphere, without Hertz' assumptions
/// on the pressure: rings of constant pressure along the axis, none negative, that keep the mean
/// gap of each ring from being negative.
class UnilateralSphere
{
public:
  /// `reach` is the largest radius of the patch (mm), less than the sphere's.
  UnilateralSphere(const LayeredSphere& sphere, double reach, int rings);

  /// N, at a depth (mm).
  double Force(double ballRadius, double depth) const;

private:
  double SphereRadius;
  Eigen::VectorXd Edges;    // of the rings, mm
  Eigen::MatrixXd Softness; // mean displacement of rings under unit forces on rings, mm/N
};
} // namespace palpate::test
