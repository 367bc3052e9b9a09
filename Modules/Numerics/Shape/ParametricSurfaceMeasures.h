#pragma once

#include "ParametricSphericalSurface.h"
#include "SphericalHarmonicMeasures.h"
#include "Status.h"

namespace palpate
{
/// Surface area (mm^2) as AreaOf(SphericalHarmonicModel): quadratures of degrees that grow by half
/// until two in a row agree to `relativeTolerance`, or the degree passes 8L + 128. Where the
/// surface has a tangent plane everywhere the error falls geometrically with the degree. Allocates.
double AreaOf(const ParametricSphericalSurface& surface, double relativeTolerance = 1e-9);

/// Volume, centroid and second moments by the divergence theorem: a quadrature of degree 5L, exact
/// for the integrands (X . N) X X^T with N = dX x dX. A surface that is parametrised inside out
/// encloses the same body. Parts that the surface winds around several times count as often. Fails
/// for non-finite coefficients and if the volume is zero up to rounding. Allocates.
Status MeasureBody(const ParametricSphericalSurface& surface, BodyMoments& moments);
} // namespace palpate
