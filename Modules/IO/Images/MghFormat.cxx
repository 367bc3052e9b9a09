#include "MghFormat.h"

#include "ForeignFile.h"
#include "HeaderBytes.h"
#include "Refusal.h"
#include "StoredImageFile.h"

#include <limits>

namespace palpate
{
namespace
{
// Bytes in front of the voxels, most of which are unused. Numbers are big-endian.
// Source: FreeSurfer's wiki, FsTutorial/MghFormat; the transform is that of its MRIread.
constexpr std::size_t MghHeaderBytes = 284;

struct MghHeader
{
  ImageGrid Grid;
  VoxelLayout Voxels;
  std::vector<std::string> Notes;
};

int MghType(const std::filesystem::path& file, int code)
{
  switch (code)
  {
  case 0:
    return VTK_UNSIGNED_CHAR;
  case 1:
    return VTK_INT;
  case 3:
    return VTK_FLOAT;
  case 4:
    return VTK_SHORT;
  default:
    Refuse(file, "has voxels of a type that is not supported (code " + std::to_string(code) + ")",
           "convert it to 8, 16 or 32-bit integers or to floating-point numbers (mri_convert)");
  }
}

int SizeAt(const std::filesystem::path& file, const HeaderBytes& bytes, std::size_t offset)
{
  const auto size = bytes.At<std::int32_t>(offset);
  if (size < 1)
  {
    Refuse(file, "has a damaged header (a size of " + std::to_string(size) + ")",
           "copy or export it again");
  }
  return size;
}

Vector3 VectorAt(const HeaderBytes& bytes, std::size_t offset)
{
  return {bytes.At<float>(offset), bytes.At<float>(offset + 4), bytes.At<float>(offset + 8)};
}

// From RAS, with the position of the centre, to LPS.
void PlaceGrid(const HeaderBytes& bytes, MghHeader& header)
{
  Eigen::Matrix3d axesRas;
  axesRas << -1, 0, 0, 0, 0, 1, 0, -1, 0; // FreeSurfer's default: coronal, 1 mm
  Vector3 centerRas = Vector3::Zero();
  if (bytes.At<std::int16_t>(28) > 0)
  {
    header.Grid.Spacing = VectorAt(bytes, 30);
    axesRas << VectorAt(bytes, 42), VectorAt(bytes, 54), VectorAt(bytes, 66);
    centerRas = VectorAt(bytes, 78);
  }
  else
  {
    header.Grid.IsOriented = false;
    header.Notes.emplace_back("The file gives no orientation; FreeSurfer's default was taken "
                              "(coronal slices, voxels of 1 mm).");
  }
  const Vector3 half(0.5 * header.Grid.Size[0], 0.5 * header.Grid.Size[1],
                     0.5 * header.Grid.Size[2]);
  const Vector3 originRas = centerRas - axesRas * header.Grid.Spacing.cwiseProduct(half);
  const Vector3 toLps(-1.0, -1.0, 1.0);
  header.Grid.OriginWorld = toLps.cwiseProduct(originRas);
  header.Grid.Direction = toLps.asDiagonal() * axesRas;
}

MghHeader ReadMghHeader(const std::filesystem::path& file)
{
  HeaderBytes bytes(file, MghHeaderBytes);
  bytes.SetBigEndian();
  if (bytes.Size() < MghHeaderBytes)
  {
    RefuseContent(file, "has a truncated or damaged header", "copy or export it again");
  }
  if (bytes.At<std::int32_t>(0) != 1)
  {
    RefuseContent(file, "is not a FreeSurfer volume, or its header is damaged",
                  "copy or export it again");
  }
  MghHeader header;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    header.Grid.Size[axis] = SizeAt(file, bytes, 4 + 4 * axis);
  }
  header.Voxels.File = file;
  header.Voxels.Type = MghType(file, bytes.At<std::int32_t>(20));
  header.Voxels.Offset = MghHeaderBytes;
  header.Voxels.Voxels = CountVoxels(file, header.Grid.Size);
  header.Voxels.Volumes = SizeAt(file, bytes, 16);
  header.Voxels.IsSwapped = bytes.IsSwapped();
  PlaceGrid(bytes, header);
  return header;
}

class MghFile : public StoredImageFile
{
public:
  MghFile(const std::filesystem::path& file, const MghHeader& header)
      : StoredImageFile(file, header.Voxels)
  {
    this->FileGrid = header.Grid;
    this->HeaderNotes = header.Notes;
  }
};
} // namespace

ImageFormat MghFormat()
{
  return {{"FreeSurfer", {".mgz", ".mgh", ".mgh.gz"}, {}},
          [](const std::filesystem::path& file)
          { return std::make_unique<MghFile>(file, ReadMghHeader(file)); },
          nullptr};
}
} // namespace palpate
