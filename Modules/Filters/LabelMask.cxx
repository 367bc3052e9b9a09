#include "LabelMask.h"

#include "MaskComponents.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <array>
#include <type_traits>

namespace palpate
{
LabelMask CopyLabelMask(vtkImageData* image, int label, int rim)
{
  LabelMask copied;
  std::array<int, 3> size{};
  std::array<double, 3> spacing{};
  image->GetDimensions(size.data());
  image->GetSpacing(spacing.data());
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const auto extract = [&](const auto* voxels)
  {
    using Voxel = std::remove_cv_t<std::remove_pointer_t<decltype(voxels)>>;
    const auto wanted = static_cast<Voxel>(label);
    LabelBounds bounds = FindLabelBounds(voxels, size, wanted);
    copied.TouchesFace = bounds.Touches(size);
    if (!bounds.IsEmpty())
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        bounds.First[axis] -= rim;
        bounds.Last[axis] += rim;
      }
      copied.Mask = CopyLabel(voxels, size, spacing, bounds, wanted);
    }
  };
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(extract(static_cast<const VTK_TT*>(scalars->GetVoidPointer(0))));
  default:
    break;
  }
  return copied;
}

VoxelMask CopyComponent(vtkImageData* image, int label, int component, int rim)
{
  VoxelMask mask = CopyLabelMask(image, label, rim).Mask;
  if (component > 0)
  {
    MaskComponents(mask).Keep(component - 1, mask);
  }
  return mask;
}
} // namespace palpate
