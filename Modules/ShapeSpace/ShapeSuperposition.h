#pragma once

#include "OrganModel.h"
#include "SphereQuadrature.h"
#include "Vector3.h"

#include <Eigen/Core>

#include <vector>

namespace palpate
{
/// How a shape about the origin is turned. A surface X(u) becomes Body X(Parameters^T u); the
/// radius R(u) becomes R(Parameters^T u), which turns the body by Parameters.
struct SphereRotation
{
  Matrix3 Body = Matrix3::Identity(); ///< of surface models only
  Matrix3 Parameters = Matrix3::Identity();
};

/// Turns a shape about the origin, exactly up to rounding. Allocates.
OrganModel TurnShape(const OrganModel& shape, const SphereRotation& rotation);

/// The angle of a rotation, rad.
double AngleOf(const Matrix3& rotation);
/// Orientations closer than this to one are no others, rad.
constexpr double SmallestOtherTurn = 0.25 * M_PI;

/// RMS over the sphere (mm) of a shape's radius or distance from the origin: the length of its
/// coefficients over sqrt(4 pi).
double RmsSizeOf(const OrganModel& shape);

/// A shape that is turned towards a target.
struct SuperposedShape
{
  SphereRotation Rotation;
  double Residual = 0.0;      ///< RMS over the sphere of the difference in radius or position, mm
  double ShapeResidual = 0.0; ///< the same with the shape at the size that makes it smallest, mm
};

/// Rotations that bring shapes closest to a target: of radial models about the centre, of surface
/// models of body and parameter sphere at once (ordinary Procrustes analysis: Gower and
/// Dijksterhuis, Procrustes Problems, 2004). Reflections are no rotations, so mirrored shapes stay
/// different.
class ShapeSuperposition
{
public:
  /// `target` about the origin; shapes must be of its kind and of at most its degree.
  explicit ShapeSuperposition(const OrganModel& target);

  /// The local optimum reached from `start`: Newton's method on the rotation group for the integral
  /// of the product with the target. A quadrature evaluates it and its first two derivatives
  /// exactly (a rotation's generators are antisymmetric, so the second ones need first derivatives
  /// of both shapes only). Converges to some 1e-10 rad where the optimum is unique; turns without
  /// effect, as of a ball, are left out. Allocates.
  SuperposedShape Fit(const OrganModel& shape, const SphereRotation& start) const;

  /// The same by turns of the parameters alone: a surface's body stays as `start` turns it.
  SuperposedShape FitParameters(const OrganModel& shape, const SphereRotation& start) const;

  /// What `rotation` itself leaves. Allocates.
  SuperposedShape At(const OrganModel& shape, const SphereRotation& rotation) const;

  /// Parameters that bring a surface model's terms of degree 1 closest to the target's, once its
  /// body is turned by `body` (the polar factor; Kabsch, Acta Cryst. A 32, 1976). For radial
  /// models: `body`.
  SphereRotation StartFor(const OrganModel& shape, const Matrix3& body) const;

private:
  /// One column per coordinate, or one for the radius, and its derivatives by turns of the sphere
  /// about x, y and z: one row per direction of the quadrature.
  struct Field
  {
    Eigen::MatrixXd Values;
    std::vector<Eigen::MatrixXd> Turns;
  };
  /// Product with the target, its gradient and its second derivatives by turns of the parameters
  /// and of the body.
  struct Product
  {
    double Value = 0.0;
    Eigen::VectorXd Gradient;
    Eigen::MatrixXd Hessian;
  };

  SuperposedShape Climb(const OrganModel& shape, const SphereRotation& start, bool turnsBody) const;
  Field FieldOf(const std::vector<RadialModel>& series, const SphereRotation& rotation) const;
  SuperposedShape Compare(const Field& field, const SphereRotation& rotation) const;
  Product ProductWith(const Field& field, bool turnsBody) const;
  void AddBodyTurns(const Field& field, Product& product) const;

  SphereQuadrature Sphere;
  Eigen::VectorXd Weights;
  Field Target;
  OrganModel Shape;
};
} // namespace palpate
