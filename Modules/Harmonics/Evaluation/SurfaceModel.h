#pragma once

#include "RadialModel.h"
#include "SurfaceEvaluator.h"
#include "Vector3.h"

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/// A closed surface X(u) = (x, y, z)(u) (mm) over the parameter sphere, each coordinate a sum of
/// spherical harmonics: the surface of Brechbuhler, Gerig and Kubler (1995) that SPHARM-PDM
/// writes. Unlike a RadialModel it needs no centre and need not be star-shaped.
/// Immutable; every query is const, thread-safe and allocation-free unless stated otherwise. What a
/// parameter must be and how exact the results are: see SurfaceEvaluator. Volume,
/// centroid and moments are in ModelMeasures, curvature in SurfaceCurvature.
class SurfaceModel
{
public:
  /// mm, mm/rad.
  using Sample = SurfaceEvaluator::Sample;
  /// mm, mm/rad, mm/rad^2.
  using SecondOrderSample = SurfaceEvaluator::SecondOrderSample;

  /// Coefficients of the three coordinates, (degree + 1)^2 each, in Palpate's convention (see
  /// SphericalHarmonicBasis); missing ones count as 0.
  SurfaceModel(int degree, const std::array<std::vector<double>, 3>& coefficients);

  /// The radial model centre + R(u) u in parametric form: exact, since each coordinate of
  /// R(u) u is a sum of harmonics one degree higher.
  static SurfaceModel FromModel(const RadialModel& model);

  int Degree() const noexcept { return this->MaximumDegree; }
  /// Coefficients of coordinate 0, 1 or 2 (mm).
  const std::vector<double>& Coefficients(int coordinate) const noexcept
  {
    return this->Values[static_cast<std::size_t>(coordinate)];
  }
  /// The tables that queries read.
  std::size_t TableBytes() const noexcept { return this->Evaluator.TableBytes(); }

  /// The surface point (mm) of a unit parameter vector; with first and second derivatives.
  Vector3 Point(const Vector3& parameter) const noexcept
  {
    return this->Evaluator.Point(parameter);
  }
  Sample Evaluate(const Vector3& parameter) const noexcept
  {
    return this->Evaluator.Evaluate(parameter);
  }
  SecondOrderSample EvaluateSecondOrder(const Vector3& parameter) const noexcept
  {
    return this->Evaluator.EvaluateSecondOrder(parameter);
  }
  /// The same for `count` unit vectors, with the same bits.
  void PointBatch(const Vector3* parameters, std::size_t count, Vector3* points) const noexcept
  {
    this->Evaluator.PointBatch(parameters, count, points);
  }
  void EvaluateBatch(const Vector3* parameters, std::size_t count, Sample* samples) const noexcept
  {
    this->Evaluator.EvaluateBatch(parameters, count, samples);
  }
  void EvaluateSecondOrderBatch(const Vector3* parameters, std::size_t count,
                                SecondOrderSample* samples) const noexcept
  {
    this->Evaluator.EvaluateSecondOrderBatch(parameters, count, samples);
  }

  /// X_a x X_b (mm^2 per sr), oriented like the parameter sphere.
  static Vector3 AreaVector(const Sample& sample) noexcept
  {
    return sample.First[0].cross(sample.First[1]);
  }
  /// Unit normal: the cross product of two tangents, oriented like the parameter sphere. Zero where
  /// the surface has no tangent plane.
  Vector3 Normal(const Vector3& parameter) const noexcept;

  /// Enclosed volume (mm^3), negative if the surface is parametrised inside out: a third of the
  /// integral of X . (dX x dX), a polynomial that the quadrature integrates exactly. Allocates.
  double Volume() const;
  /// Surface area (mm^2), by quadrature of degree 4L + 16, since the integrand is not a polynomial;
  /// to a given accuracy: AreaOf. Allocates.
  double Area() const;

  /// Sum of the squared coefficients (mm^2) of each degree 0..L, of the three coordinates together:
  /// unchanged by rotations of space and of the parameter sphere. Allocates.
  std::vector<double> PowerSpectrum() const;
  /// The same surface truncated to `degree` (or padded with zeros up to it). Allocates.
  SurfaceModel WithDegree(int degree) const;
  /// The surface `linear` X + `translation` (mm), exact up to rounding: a rotation, a scale, a
  /// mirror or any other matrix. One of negative determinant turns the surface inside out;
  /// Reparametrized by a reflection turns it back. Allocates.
  SurfaceModel Transformed(const Matrix3& linear, const Vector3& translation) const;
  /// The same points with other parameters: u -> X(orthogonal u), for a rotation or a reflection.
  /// Exact up to rounding, by projection; NaN if the matrix is not orthogonal. Allocates.
  SurfaceModel Reparametrized(const Matrix3& orthogonal) const;

private:
  SurfaceEvaluator Evaluator; // first: what a tick reads
  int MaximumDegree;
  std::array<std::vector<double>, 3> Values;
};
} // namespace palpate
