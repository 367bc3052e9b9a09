#include "ImageReadBack.h"

#include "FileKind.h"
#include "ItkImageReader.h"
#include "NiftiVoxels.h"

#include <cstring>
#include <vector>

namespace palpate
{
namespace
{
bool IsType(int type, vtkDataArray* voxels)
{
  const int expected = voxels->GetDataType();
  return type == (expected == VTK_CHAR ? VTK_SIGNED_CHAR : expected);
}

// Empty where the file has another type.
std::vector<char> ReadBack(const std::filesystem::path& file, vtkDataArray* voxels)
{
  std::vector<char> bytes;
  const auto size = static_cast<std::size_t>(voxels->GetNumberOfTuples()) *
                    static_cast<std::size_t>(voxels->GetDataTypeSize());
  const FileKind kind = DetectFileKind(file);
  if (kind == FileKind::Nifti)
  {
    const NiftiVoxels reader(file, ReadNiftiHeader(file));
    if (IsType(reader.ScalarType(), voxels))
    {
      bytes.resize(size);
      reader.ReadInto(bytes.data());
    }
    return bytes;
  }
  ItkImageReader reader(file, kind);
  if (IsType(reader.Header().VtkType, voxels))
  {
    bytes.resize(size);
    reader.ReadInto(bytes.data());
  }
  return bytes;
}
} // namespace

bool HoldsVoxels(const std::filesystem::path& file, vtkDataArray* voxels)
{
  const std::vector<char> back = ReadBack(file, voxels);
  return !back.empty() && std::memcmp(back.data(), voxels->GetVoidPointer(0), back.size()) == 0;
}
} // namespace palpate
