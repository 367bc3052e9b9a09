#include "ImageReadBack.h"

#include "ImageFormat.h"

#include <cstring>
#include <vector>

namespace palpate
{
bool HoldsVoxels(const std::filesystem::path& file, vtkDataArray* voxels)
{
  const std::unique_ptr<ImageFile> written = ImageFormatOf(file).Open(file);
  const int type = voxels->GetDataType();
  const auto size = static_cast<std::size_t>(voxels->GetNumberOfTuples()) *
                    static_cast<std::size_t>(voxels->GetDataTypeSize());
  if (written->ScalarType() != (type == VTK_CHAR ? VTK_SIGNED_CHAR : type) ||
      written->Grid().VoxelCount() != voxels->GetNumberOfTuples())
  {
    return false;
  }
  std::vector<char> back(size);
  written->ReadInto(back.data());
  return std::memcmp(back.data(), voxels->GetVoidPointer(0), size) == 0;
}
} // namespace palpate
