#pragma once

#include "CenteredSurface.h"
#include "ClosestPointSearch.h"
#include "Vector3.h"

namespace palpate
{
/// The radius (mm) of the largest sphere, up to `largest` > 0, that touches a surface model at
/// the point of `sample` on the side of the unit normal, is no wider than the surface is curved
/// there and meets no other part of it. By trials, not by proof. Takes some microseconds; does not
/// allocate.
///
/// This is the sphere of Ma, Bae and Choi, "3D medial axis point approximation using nearest
/// neighbors and the normal field", The Visual Computer 28 (2012): through a point that is d away
/// and rises above the tangent plane by h goes the sphere of the radius d^2 / 2h. The smallest one
/// through the middles of the parts of the search's tree is found by one descent of the tree, since
/// a sphere that touches a ball of the radius b has (d^2 - b^2) / 2 (h + b). Then it shrinks to the
/// nearest point of the surface around that middle, a few times.
double LargestTangentSphere(const ClosestPointSearchOf<CenteredSurface>& search,
                            const CenteredSurface::SecondOrderSample& sample, const Vector3& normal,
                            double largest) noexcept;
} // namespace palpate
