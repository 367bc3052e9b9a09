#pragma once

#include "PalpateFiltersModule.h"
#include "Vector3.h"

#include <vector>

namespace palpate
{
/// Length of the line through points, mm; 0 for fewer than two.
PALPATEFILTERS_EXPORT double PolylineLength(const std::vector<Vector3>& points);

/// The point halfway along such a line; there must be a point.
PALPATEFILTERS_EXPORT Vector3 PolylineMiddle(const std::vector<Vector3>& points);

/// Angle at `vertex` between two points, rad, 0..pi; accurate also near both ends. 0 if a point is
/// at the vertex.
PALPATEFILTERS_EXPORT double AngleAt(const Vector3& vertex, const Vector3& one,
                                     const Vector3& other);

/// Unit normal of the plane through three points, by the right-hand rule; zero if they lie on a
/// line.
PALPATEFILTERS_EXPORT Vector3 PlaneNormal(const Vector3& a, const Vector3& b, const Vector3& c);
} // namespace palpate
