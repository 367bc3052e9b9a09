#pragma once

#include "PalpateIOModule.h"
#include "TriangleMesh.h"

#include <string>

namespace palpate
{
/// The points and triangles of a GIfTI surface's text, in RAS and mm as the file states them. A
/// transform to the scanner's space is applied; one to an atlas is not. Other arrays are skipped,
/// external data files refused. Indices may exceed the points; TrianglesOf checks them. Memory is
/// bounded by the text: compressed values that would be more than a hundred times their bytes are
/// refused. Throws InputError, naming `fileName`.
/// Source: GIfTI Surface Data Format 1.0 (https://www.nitrc.org/projects/gifti).
PALPATEIO_EXPORT TriangleMesh MeshFromGifti(const std::string& text, const std::string& fileName);
} // namespace palpate
