#pragma once

#include "RadialModel.h"
#include "Status.h"
#include "SurfaceModel.h"
#include "Vector3.h"

#include <Eigen/Core>

namespace palpate
{
/// Enclosed volume (mm^3), the integral of R^3 / 3 over the directions: exact up to rounding, since
/// the quadrature is exact for R^3, a polynomial of degree 3L. Parts with negative R count as
/// negative. Allocates.
double VolumeOf(const RadialModel& model);

/// Surface area (mm^2), of |R| sqrt(R^2 + |grad R|^2) or of |N| with N = dX x dX, which are not
/// polynomials: quadratures of degrees that grow by half until two in a row agree to
/// `relativeTolerance`, or the degree passes 8L + 128. The value is that of the finer quadrature,
/// so the error is usually far smaller than the last change: where the surface has a tangent plane
/// everywhere it falls geometrically with the degree. A radial model that passes through its centre
/// has a kink there, and the error is large. Allocates.
double AreaOf(const RadialModel& model, double relativeTolerance = 1e-9);
double AreaOf(const SurfaceModel& surface, double relativeTolerance = 1e-9);

/// A body of uniform density 1 (per mm^3), in the frame of the model (patient LPS).
struct BodyMoments
{
  double Volume;         ///< mm^3
  Vector3 CentroidWorld; ///< mm
  /// Integral of (x - centroid)(x - centroid)^T over the body (mm^5).
  Eigen::Matrix3d SecondMoments;
  /// Columns are unit vectors, right-handed, along which the body extends most, less and least; the
  /// signs of the first two are such that the largest component is positive.
  Eigen::Matrix3d PrincipalAxes;
  /// Semi-axes (mm) of the ellipsoid with the same volume and the same second moments, except for a
  /// common factor: sqrt(5 moment / volume). Exact for an ellipsoid.
  Vector3 SemiAxes;
};

/// Volume, centroid and second moments by a quadrature that is exact for the integrands, of degree
/// 5L + 2 for R^3, R^4 u and R^5 u u^T, and 5L for (X . N) X X^T (divergence theorem); rounding
/// about 1e-14 relative. A surface that is parametrised inside out encloses the same body; parts
/// that it winds around several times count as often. Fails for non-finite coefficients, if the
/// volume of a radial model is not positive, and if that of a surface is zero up to rounding, since
/// no centroid exists then. Allocates.
Status MeasureBody(const RadialModel& model, BodyMoments& moments);
Status MeasureBody(const SurfaceModel& surface, BodyMoments& moments);
} // namespace palpate
