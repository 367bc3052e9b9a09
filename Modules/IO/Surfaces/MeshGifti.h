#pragma once

#include "PalpateIOModule.h"
#include "TriangleMesh.h"

#include <string>

namespace palpate
{
/// GIfTI surface (.surf.gii): points in RAS, mm, in the scanner's space, and triangles; single
/// precision, as text. Source: GIFTI Surface Data Format, version 1.0.
PALPATEIO_EXPORT std::string MeshToGifti(const TriangleMesh& mesh);

/// GIfTI shape file (.shape.gii): the point arrays of a surface without its points.
PALPATEIO_EXPORT std::string ValuesToGifti(const TriangleMesh& mesh);
} // namespace palpate
