#pragma once

#include "IndexToWorld.h"
#include "PalpateFiltersModule.h"

class vtkImageData;

namespace palpate
{
/// Index (0, 0, 0) is the image's first voxel, whatever its extent.
PALPATEFILTERS_EXPORT IndexToWorld IndexToWorldOf(vtkImageData* image);
} // namespace palpate
