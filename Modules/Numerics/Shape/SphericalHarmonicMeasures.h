#pragma once

#include "SphericalHarmonicModel.h"
#include "Status.h"
#include "Vector3.h"

#include <Eigen/Core>

namespace palpate
{
/// Enclosed volume (mm^3), the integral of R^3 / 3 over the directions: exact up to rounding, since
/// R^3 is a polynomial of degree 3L and the quadrature is exact for those. Where R is negative its
/// part counts negative. Allocates.
double VolumeOf(const SphericalHarmonicModel& model);

struct SurfaceArea
{
  double Value;         ///< mm^2
  double ErrorEstimate; ///< mm^2; an estimate and no proof, see AreaOf
};

/// The integral of |R| sqrt(R^2 + |grad R|^2), no polynomial: quadratures of degrees that grow by a
/// half until two in a row agree to `relativeTolerance`, or the degree passes 8L + 128. The error
/// estimate is the last change, and 1e-14 of the area for rounding; the value is that of the finer
/// quadrature, so the true error is usually far smaller: where R > 0 it falls geometrically with
/// the degree. Where the surface passes through the centre it has a kink, and the estimate says how
/// little is known. Allocates.
SurfaceArea AreaOf(const SphericalHarmonicModel& model, double relativeTolerance = 1e-9);

/// A body of uniform density 1 (per mm^3), in the frame of the model (patient LPS).
struct BodyMoments
{
  double Volume;         ///< mm^3
  Vector3 CentroidWorld; ///< mm
  /// Integral of (x - centroid)(x - centroid)^T over the body (mm^5).
  Eigen::Matrix3d SecondMoments;
  /// About the centroid (mm^5): trace(SecondMoments) times the identity minus SecondMoments.
  Eigen::Matrix3d Inertia;
  /// Columns are unit vectors, right-handed, along which the body extends most, less and least; of
  /// both signs that one whose largest component is positive, but for the last.
  Eigen::Matrix3d PrincipalAxes;
  /// Semi-axes (mm) of the ellipsoid with the same volume and the same second moments, except for a
  /// common factor: sqrt(5 moment / volume). An ellipsoid's own.
  Vector3 SemiAxes;
};

/// Volume, centroid and second moments by a quadrature of degree 5L + 2, exact for the integrands
/// R^3, R^4 u and R^5 u u^T; rounding about 1e-14 relative. Fails where coefficients are not finite
/// and where the volume is not positive, as no centroid exists then. Allocates.
Status MeasureBody(const SphericalHarmonicModel& model, BodyMoments& moments);
} // namespace palpate
