#pragma once

#include "PalpateIOModule.h"
#include "TriangleMesh.h"

#include <string>

namespace palpate
{
/// The mesh of a PLY file's bytes, text or binary of either byte order: points, normals (nx, ny,
/// nz), colours (red, green, blue as uchar), every other scalar property of a vertex as point
/// values; polygons are cut into fans. Unlike VTK 9.1's reader it keeps double precision and point
/// values and detects a truncated file. Indices may exceed the points; TrianglesOf checks them.
/// Source: Turk, The PLY Polygon File Format (1994). Throws InputError, naming `fileName`.
PALPATEIO_EXPORT TriangleMesh MeshFromPly(const std::string& bytes, const std::string& fileName);
} // namespace palpate
