#pragma once

#include "RadialEvaluator.h"
#include "Vector3.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// A radial model: around a centre, the radius R(u) = sum c_lm Y_lm(u) (mm) along each unit
/// direction u. Immutable; every query is const, thread-safe and allocation-free unless stated
/// otherwise. Convention of the coefficients: see SphericalHarmonicBasis. The model's axes are
/// those of the frame of its centre (patient LPS, mm).
///
/// What a direction must be and how exact the results are: see RadialEvaluator.
class RadialModel
{
public:
  using Formulation = EvaluationFormulation;
  /// mm, mm/rad.
  using Sample = RadialEvaluator::Sample;
  /// mm, mm/rad, mm/rad^2.
  using SecondOrderSample = RadialEvaluator::SecondOrderSample;

  /// The sphere of radius 0 at the origin.
  RadialModel() : RadialModel(0, {0.0}, Vector3::Zero()) {}
  /// `coefficients` has (degree + 1)^2 entries in mm; `centerWorld` is in mm.
  RadialModel(int degree, std::vector<double> coefficients, const Vector3& centerWorld,
              Formulation formulation = Formulation::Automatic);

  int Degree() const noexcept { return this->MaximumDegree; }
  const std::vector<double>& Coefficients() const noexcept { return this->Values; }
  const Vector3& CenterWorld() const noexcept { return this->Center; }
  /// The tables that queries read.
  std::size_t TableBytes() const noexcept { return this->Evaluator.TableBytes(); }

  /// Radius in mm along a unit vector.
  double Radius(const Vector3& direction) const noexcept
  {
    return this->Evaluator.Radius(direction);
  }
  Sample Evaluate(const Vector3& direction) const noexcept
  {
    return this->Evaluator.Evaluate(direction);
  }
  SecondOrderSample EvaluateSecondOrder(const Vector3& direction) const noexcept
  {
    return this->Evaluator.EvaluateSecondOrder(direction);
  }

  /// Evaluate for `count` unit vectors; several at once, so a third faster or more.
  void EvaluateBatch(const Vector3* directions, std::size_t count, Sample* samples) const noexcept
  {
    this->Evaluator.EvaluateBatch(directions, count, samples);
  }
  /// The same with second derivatives, and for radii only.
  void EvaluateSecondOrderBatch(const Vector3* directions, std::size_t count,
                                SecondOrderSample* samples) const noexcept
  {
    this->Evaluator.EvaluateSecondOrderBatch(directions, count, samples);
  }
  void RadiusBatch(const Vector3* directions, std::size_t count, double* radii) const noexcept
  {
    this->Evaluator.RadiusBatch(directions, count, radii);
  }

  /// centre + R(u) u, mm.
  Vector3 PointWorld(const Vector3& direction) const noexcept;
  /// Unit normal of the surface, outward where R > 0: (R u - grad R) / |R u - grad R|.
  Vector3 Normal(const Vector3& direction) const noexcept;

  /// Sum of squared coefficients (mm^2) of each degree 0..L. Allocates.
  std::vector<double> PowerSpectrum() const;
  /// The same surface truncated to `degree` (or padded with zeros up to it). Allocates.
  RadialModel WithDegree(int degree) const;

private:
  RadialModel(std::vector<double> coefficients, const Vector3& centerWorld, int degree,
              Formulation formulation);

  RadialEvaluator Evaluator; // first: with the next one, what a tick reads
  Vector3 Center;
  int MaximumDegree;
  std::vector<double> Values;
};
} // namespace palpate
