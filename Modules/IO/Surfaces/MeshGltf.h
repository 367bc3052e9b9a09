#pragma once

#include "PalpateIOModule.h"
#include "TriangleMesh.h"

#include <string>

namespace palpate
{
/// A triangle mesh as self-contained glTF 2.0: positions, and normals and colours if it has them.
/// Coordinates are patient LPS in mm (single precision); the mesh's node has the matrix to glTF's
/// frame: metres, x to the patient's left, y up to the head, z to the front.
/// Source: Khronos Group, glTF 2.0 Specification (2021).

/// The text form, with its buffer in base64.
PALPATEIO_EXPORT std::string MeshToGltf(const TriangleMesh& mesh);
/// The binary form (.glb).
PALPATEIO_EXPORT std::string MeshToGlb(const TriangleMesh& mesh);
} // namespace palpate
