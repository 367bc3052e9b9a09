#include "VoxelCheck.h"

#include "Refusal.h"

#include <cmath>
#include <string>

namespace palpate
{
namespace
{
template <typename T>
vtkIdType CountNotFinite(const void* data, vtkIdType count)
{
  const T* values = static_cast<const T*>(data);
  vtkIdType found = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    found += std::isfinite(values[i]) ? 0 : 1;
  }
  return found;
}
} // namespace

void CheckFinite(const std::filesystem::path& file, vtkDataArray* voxels)
{
  const vtkIdType count = voxels->GetNumberOfValues();
  vtkIdType found = 0;
  if (voxels->GetDataType() == VTK_FLOAT)
  {
    found = CountNotFinite<float>(voxels->GetVoidPointer(0), count);
  }
  else if (voxels->GetDataType() == VTK_DOUBLE)
  {
    found = CountNotFinite<double>(voxels->GetVoidPointer(0), count);
  }
  if (found > 0)
  {
    Refuse(file, "holds " + std::to_string(found) + " voxels that are NaN or infinite",
           "replace them, for example by 0");
  }
}
} // namespace palpate
