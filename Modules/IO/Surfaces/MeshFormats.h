#pragma once

#include "PalpateIOModule.h"
#include "TriangleMesh.h"

#include <string>

/// A triangle mesh in the words of one surface format each. Coordinates stay patient LPS in mm, and
/// the file says so wherever its format has a comment ("SPACE=LPS" is what 3D Slicer looks for).
namespace palpate
{
/// Binary STL: single precision, triangles without common points, no normals of points.
PALPATEIO_EXPORT std::string MeshToStl(const TriangleMesh& mesh);

/// Binary little-endian PLY: points in their own precision, normals, colours, and every
/// one-component point array as a property of the vertex.
PALPATEIO_EXPORT std::string MeshToPly(const TriangleMesh& mesh);

/// Wavefront OBJ: points with all their digits, and normals.
PALPATEIO_EXPORT std::string MeshToObj(const TriangleMesh& mesh);

/// X3D 3.0 (Interchange profile), an IndexedFaceSet with Coordinate and, where the mesh has them,
/// Normal and Color; single precision.
PALPATEIO_EXPORT std::string MeshToX3d(const TriangleMesh& mesh);
} // namespace palpate
