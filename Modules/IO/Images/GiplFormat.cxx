#include "GiplFormat.h"

#include "ForeignFile.h"
#include "HeaderBytes.h"
#include "Refusal.h"
#include "StoredImageFile.h"

#include <algorithm>
#include <array>
#include <utility>

namespace palpate
{
namespace
{
// Bytes in front of the voxels. Numbers are big-endian. Read as ITK 5.2 does (GiplImageIO), but
// without ITK, which does not notice that voxels are missing.
constexpr std::size_t GiplHeaderBytes = 256;
constexpr std::array<std::uint32_t, 2> Marks{{0xefffe9b0, 0x2ae389b8}};

constexpr std::array<std::pair<int, int>, 9> GiplTypes{{{1, VTK_UNSIGNED_CHAR},
                                                        {7, VTK_SIGNED_CHAR},
                                                        {8, VTK_UNSIGNED_CHAR},
                                                        {15, VTK_SHORT},
                                                        {16, VTK_UNSIGNED_SHORT},
                                                        {31, VTK_UNSIGNED_INT},
                                                        {32, VTK_INT},
                                                        {64, VTK_FLOAT},
                                                        {65, VTK_DOUBLE}}};

HeaderBytes ReadBytes(const std::filesystem::path& file)
{
  HeaderBytes bytes(file, GiplHeaderBytes);
  bytes.SetBigEndian();
  if (bytes.Size() < GiplHeaderBytes)
  {
    RefuseContent(file, "has a truncated or damaged header", "copy or export it again");
  }
  if (std::find(Marks.begin(), Marks.end(), bytes.At<std::uint32_t>(252)) == Marks.end())
  {
    RefuseContent(file, "is not a GIPL file, or its header is damaged", "copy or export it again");
  }
  return bytes;
}

ImageGrid GridOf(const HeaderBytes& bytes)
{
  ImageGrid grid;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    // A size of 0 marks an unused axis.
    grid.Size[axis] = std::max<int>(1, bytes.At<std::uint16_t>(2 * axis));
    const auto i = static_cast<Eigen::Index>(axis);
    grid.Spacing[i] = bytes.At<float>(10 + 4 * axis);
    grid.OriginWorld[i] = bytes.At<double>(204 + 8 * axis);
  }
  return grid;
}

VoxelLayout LayoutOf(const std::filesystem::path& file, const HeaderBytes& bytes)
{
  const int code = bytes.At<std::uint16_t>(8);
  const auto* const type = std::find_if(GiplTypes.begin(), GiplTypes.end(),
                                        [code](const auto& known) { return known.first == code; });
  if (type == GiplTypes.end())
  {
    Refuse(file, "has voxels of a type that is not supported (code " + std::to_string(code) + ")",
           "convert it to integers or floating-point numbers");
  }
  VoxelLayout layout;
  layout.File = file;
  layout.Type = type->second;
  layout.Offset = GiplHeaderBytes;
  layout.Voxels = CountVoxels(file, GridOf(bytes).Size);
  layout.Volumes = std::max<std::int64_t>(1, bytes.At<std::uint16_t>(6));
  layout.IsSwapped = bytes.IsSwapped();
  return layout;
}

class GiplFile : public StoredImageFile
{
public:
  GiplFile(const std::filesystem::path& file, const HeaderBytes& bytes)
      : StoredImageFile(file, LayoutOf(file, bytes))
  {
    this->FileGrid = GridOf(bytes);
    this->FileGrid.IsOriented = false;
    this->HeaderNotes = {"GIPL files give no orientation; the index axes were taken as L, P, S, as "
                         "ITK does: check left and right."};
  }
};
} // namespace

ImageFormat GiplFormat()
{
  return {{"GIPL", {".gipl", ".gipl.gz"}, {}},
          [](const std::filesystem::path& file)
          { return std::make_unique<GiplFile>(file, ReadBytes(file)); },
          nullptr};
}
} // namespace palpate
