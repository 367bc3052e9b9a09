#pragma once

#include "IndexedMesh.h"

namespace palpate
{
/// Whether three points are on one line, exactly.
bool AreCollinear(const Vector3& a, const Vector3& b, const Vector3& c) noexcept;

/// Whether two triangles of a mesh have more in common than the points whose indices they share, or
/// the edge between two such points. Without common indices a touch in a single point counts; two
/// triangles of the same three points always cross. Exact for the coordinates of ExactSign. Neither
/// triangle may have its points on one line.
bool TrianglesCross(const IndexedMesh& mesh, int one, int other) noexcept;
} // namespace palpate
