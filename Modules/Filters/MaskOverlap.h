#pragma once

#include "IndexedMesh.h"
#include "PalpateFiltersModule.h"
#include "WindingNumbers.h"

class vtkImageData;

namespace palpate
{
/// Compares a closed surface (world mm) with a label, or one of its components (CopyComponent), on
/// the label map's own grid: a voxel belongs to the surface if its centre lies inside (winding
/// number > 0). Voxels beyond the image's border count as well; those of a surface that reaches
/// farther than a few sizes of the image are estimated from its volume. A surface with coordinates
/// that are not finite encloses nothing.
PALPATEFILTERS_EXPORT WindingOverlap OverlapOfSurfaceAndMask(const IndexedMesh& surface,
                                                             vtkImageData* mask, int label,
                                                             int component = 0);
} // namespace palpate
