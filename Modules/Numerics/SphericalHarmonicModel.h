#pragma once

#include "PolynomialKernel.h"
#include "PolynomialTable.h"
#include "SphericalHarmonicRecurrence.h"
#include "Vector3.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// A star-shaped surface: around a centre, the radius R(u) = sum c_lm Y_lm(u) (mm) along each unit
/// direction u. Immutable; every query is const, thread-safe and free of allocation unless it says
/// otherwise. Convention of the coefficients: see SphericalHarmonicBasis. The model's axes are the
/// axes of the frame that the centre is given in (patient LPS, mm).
///
/// Up to degree 16 the radius is evaluated by polynomials made for this model (PolynomialTable),
/// with the fastest instructions that the processor has; above, by the normalised recurrence.
class SphericalHarmonicModel
{
public:
  enum class Formulation
  {
    Automatic,  ///< polynomials up to HighestPolynomialDegree
    Polynomial, ///< loses digits above degree 16 or so
    Recurrence  ///< good at every degree
  };
  static constexpr int HighestPolynomialDegree = 16;

  /// The sphere of radius 0 at the origin.
  SphericalHarmonicModel() : SphericalHarmonicModel(0, {0.0}, Vector3::Zero()) {}
  /// `coefficients` has (degree + 1)^2 entries in mm; `centerWorld` is in mm.
  SphericalHarmonicModel(int degree, std::vector<double> coefficients, const Vector3& centerWorld,
                         Formulation formulation = Formulation::Automatic);

  int Degree() const noexcept { return this->Recurrence.Degree(); }
  const std::vector<double>& Coefficients() const noexcept { return this->Values; }
  const Vector3& CenterWorld() const noexcept { return this->Center; }

  /// Radius in mm along a unit vector.
  double Radius(const Vector3& direction) const noexcept;

  struct Sample
  {
    double Radius;           ///< mm
    Vector3 SurfaceGradient; ///< gradient of R on the unit sphere (mm/rad), tangent to it
  };
  Sample Evaluate(const Vector3& direction) const noexcept;

  struct SecondOrderSample
  {
    double Radius;           ///< mm
    Vector3 SurfaceGradient; ///< as in Sample
    /// Covariant Hessian of R on the unit sphere (mm/rad^2): symmetric, and zero along the
    /// direction. For tangent unit vectors t it is the second derivative of R along the great
    /// circle of t.
    Matrix3 SurfaceHessian;
  };
  SecondOrderSample EvaluateSecondOrder(const Vector3& direction) const noexcept;

  /// Evaluate for `count` unit vectors; several at once, so a third faster or more.
  void EvaluateBatch(const Vector3* directions, std::size_t count, Sample* samples) const noexcept;

  /// centre + R(u) u, mm.
  Vector3 PointWorld(const Vector3& direction) const noexcept;
  /// Unit normal of the surface, outward where R > 0: (R u - grad R) / |R u - grad R|.
  Vector3 Normal(const Vector3& direction) const noexcept;

  /// Enclosed volume (mm^3), exact up to rounding: VolumeOf. Allocates.
  double Volume() const;
  /// Surface area (mm^2) to 1e-9 relative where R > 0: AreaOf, which gives its error too.
  /// Allocates.
  double Area() const;
  /// Sum of squared coefficients (mm^2) of each degree 0..L. Allocates.
  std::vector<double> PowerSpectrum() const;
  /// The same surface with all terms above `degree` left out (or zeros added up to it). Allocates.
  SphericalHarmonicModel WithDegree(int degree) const;

private:
  double RadiusByRecurrence(const Vector3& direction) const noexcept;
  Sample EvaluateByRecurrence(const Vector3& direction) const noexcept;

  SphericalHarmonicRecurrence Recurrence;
  std::vector<double> Values;
  Vector3 Center;
  const polynomial::Kernel* Kernel = nullptr; // null: by recurrence
  PolynomialTable Table;
  // Cosine and sine coefficients, order by order, as the recurrence visits them.
  struct Pair
  {
    double Cosine;
    double Sine;
  };
  std::vector<Pair> Pairs;
};
} // namespace palpate
