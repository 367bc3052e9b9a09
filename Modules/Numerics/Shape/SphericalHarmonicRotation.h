#pragma once

#include "SphericalHarmonicModel.h"
#include "Status.h"
#include "Vector3.h"

#include <Eigen/Core>
#include <vector>

namespace palpate
{
/// The action of a rotation Q on coefficients: the rotated function has at Q u the value that the
/// original one has at u. Degrees do not mix: one orthogonal block each.
///
/// Every block is Z(alpha) J Z(-beta) J Z(gamma), where the Z rotate about the polar axis, mixing
/// only the cosine and sine of one order, and J is the constant matrix that exchanges y and z
/// (Pinchon and Hoggan, J. Phys. A 40, 2007). J follows from Wigner's d at a right angle by the
/// recurrence of Trapani and Navaza (Acta Cryst. A62, 2006) in long double, so that errors do not
/// grow with the degree beyond those of the angles: blocks are orthogonal to 1e-13 up to degree 200
/// at least. The angles are computed from the quaternion, which avoids gimbal lock.
class SphericalHarmonicRotation
{
public:
  /// The identity of degree 0.
  SphericalHarmonicRotation();

  /// `rotation` maps old directions to new ones; its entries may be off by rounding (up to 1e-6)
  /// and it is replaced by the rotation of its normalised quaternion. Fails for a negative degree
  /// and for a matrix that is not a rotation: not finite, not orthogonal, or a reflection. Time and
  /// memory grow as degree^3 / 3 numbers: 7 KB at degree 12, 21 MB at degree 200.
  static Status Make(int degree, const Eigen::Matrix3d& rotation,
                     SphericalHarmonicRotation& result);

  int Degree() const noexcept { return this->MaximumDegree; }
  /// The matrix that rotates directions.
  const Eigen::Matrix3d& Matrix() const noexcept { return this->Rotation; }

  /// Rotates (Degree() + 1)^2 coefficients in the convention of SphericalHarmonicBasis. Both may be
  /// the same array. Allocates.
  void Apply(const double* coefficients, double* rotated) const;
  /// The matrix of one degree, 2l+1 rows and columns, orders -l..l. Allocates.
  Eigen::MatrixXd Block(int degree) const;

  /// The surface rotated about its own centre, as a model of degree Degree(): higher terms are
  /// omitted. Allocates.
  SphericalHarmonicModel Apply(const SphericalHarmonicModel& model) const;
  /// The same, rotated about a point of the world (mm): the centre moves too.
  SphericalHarmonicModel ApplyAbout(const Vector3& pivotWorld,
                                    const SphericalHarmonicModel& model) const;

private:
  // cos(m angle) and sin(m angle), m = 0..degree.
  struct Turn
  {
    std::vector<double> Cosines;
    std::vector<double> Sines;
  };
  // Coefficients of one degree as separate cosines and sines, m = 0..l.
  struct Orders;

  SphericalHarmonicRotation(int degree, const Eigen::Matrix3d& rotation);
  static Turn MakeTurn(int degree, long double angle);
  static void Rotate(const Turn& turn, int degree, Orders& orders);
  void Exchange(int degree, const Orders& from, Orders& to) const;
  void ApplyToDegree(int degree, Orders& orders, Orders& scratch) const;

  int MaximumDegree;
  Eigen::Matrix3d Rotation;
  Turn First;  // gamma
  Turn Middle; // -beta
  Turn Last;   // alpha
  // J of each degree: entry (m, k) couples order k to order m. Parity determines whether it couples
  // cosines or sines, see Exchange.
  std::vector<Eigen::MatrixXd> Exchanges;
};
} // namespace palpate
