#include "MaskOverlap.h"

#include "ImageIndexToWorld.h"
#include "LabelMask.h"
#include "SurfaceMaskOverlap.h"

#include "vtkImageData.h"

namespace palpate
{
WindingOverlap OverlapOfSurfaceAndMask(const IndexedMesh& surface, vtkImageData* mask, int label,
                                       int component)
{
  // A few times the image's own memory.
  const double most = 4.0 * static_cast<double>(mask->GetNumberOfPoints()) + 1e6;
  return OverlapOfSurfaceAndMask(surface, CopyComponent(mask, label, component, 0),
                                 IndexToWorldOf(mask), most);
}
} // namespace palpate
