#pragma once

#include "SphericalHarmonicModel.h"

#include <memory>
#include <vector>

namespace palpate::bench
{
/// Other libraries' ways to a model's radius and surface gradient, each as its documentation
/// suggests, with all that does not depend on the direction done before.

/// GSL's arrays of normalised Legendre functions and their derivatives in theta; cos and sin of m
/// phi by rotation.
class GslEvaluator
{
public:
  explicit GslEvaluator(const SphericalHarmonicModel& model);
  double Radius(const Vector3& direction);
  SphericalHarmonicModel::Sample Evaluate(const Vector3& direction);

private:
  int Degree;
  std::vector<double> Coefficients;
  std::vector<double> Legendre;
  std::vector<double> Derivatives;
};

/// The C++17 standard library's std::sph_legendre, one call a term.
class StandardEvaluator
{
public:
  explicit StandardEvaluator(const SphericalHarmonicModel& model) : Model(model) {}
  double Radius(const Vector3& direction) const;
  SphericalHarmonicModel::Sample Evaluate(const Vector3& direction) const;

private:
  const SphericalHarmonicModel& Model;
};

/// libsharp's synthesis on a grid of Gauss-Legendre latitudes and equal longitudes, which shares
/// work between points of a ring. One thread.
class SharpGrid
{
public:
  SharpGrid(const SphericalHarmonicModel& model, int latitudes, int longitudes);
  ~SharpGrid();
  SharpGrid(const SharpGrid&) = delete;
  SharpGrid& operator=(const SharpGrid&) = delete;

  /// The points of the grid, in the order of the results.
  const std::vector<Vector3>& Directions() const { return this->Points; }
  /// Radii of all points.
  void Synthesise();
  /// Radii and derivatives along theta and phi.
  void SynthesiseWithSlopes();
  const std::vector<double>& Radii() const { return this->Values; }
  /// The last results in our form; not a part of the library's work.
  SphericalHarmonicModel::Sample SampleAt(std::size_t point) const;

private:
  struct Sharp;
  std::unique_ptr<Sharp> Library;
  std::vector<Vector3> Points;
  std::vector<double> Values;
  std::vector<double> AlongTheta;
  std::vector<double> AlongPhi;
};
} // namespace palpate::bench
