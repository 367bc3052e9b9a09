#pragma once

#include "PalpateIOModule.h"
#include "TriangleMesh.h"

#include <string>

/// Writers of a triangle mesh, one for each surface format. Coordinates are patient LPS in mm,
/// which the file states if its format has comments (3D Slicer looks for "SPACE=LPS").
namespace palpate
{
/// Binary STL: single precision, triangles without shared points, no point normals.
PALPATEIO_EXPORT std::string MeshToStl(const TriangleMesh& mesh);

/// Binary little-endian PLY: points in their own precision, normals, colours, and every
/// one-component point array as a property of the vertex.
PALPATEIO_EXPORT std::string MeshToPly(const TriangleMesh& mesh);

/// Wavefront OBJ: points in full precision, and normals.
PALPATEIO_EXPORT std::string MeshToObj(const TriangleMesh& mesh);

/// X3D 3.0 (Interchange profile), an IndexedFaceSet with Coordinate and, if the mesh has them,
/// Normal and Color; single precision.
PALPATEIO_EXPORT std::string MeshToX3d(const TriangleMesh& mesh);
} // namespace palpate
