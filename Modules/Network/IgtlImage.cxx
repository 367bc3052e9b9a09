#include "IgtlImage.h"

#include "IgtlHeaderVersion.h"

#include <algorithm>
#include <cstring>
#include <igtl_image.h>
#include <igtl_util.h>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::size_t ImageHeaderBytes = IGTL_IMAGE_HEADER_SIZE;

bool TypeOf(int code, ScalarType& type)
{
  static constexpr std::array<std::pair<int, ScalarType>, 8> All{
      {{IGTL_IMAGE_STYPE_TYPE_INT8, ScalarType::Int8},
       {IGTL_IMAGE_STYPE_TYPE_UINT8, ScalarType::UInt8},
       {IGTL_IMAGE_STYPE_TYPE_INT16, ScalarType::Int16},
       {IGTL_IMAGE_STYPE_TYPE_UINT16, ScalarType::UInt16},
       {IGTL_IMAGE_STYPE_TYPE_INT32, ScalarType::Int32},
       {IGTL_IMAGE_STYPE_TYPE_UINT32, ScalarType::UInt32},
       {IGTL_IMAGE_STYPE_TYPE_FLOAT32, ScalarType::Float32},
       {IGTL_IMAGE_STYPE_TYPE_FLOAT64, ScalarType::Float64}}};
  const auto* const found = std::find_if(All.begin(), All.end(),
                                         [code](const auto& known) { return known.first == code; });
  if (found == All.end())
  {
    return false;
  }
  type = found->second;
  return true;
}

// Why the header is that of no whole image with one value a voxel; empty if it is.
std::string Flaw(const igtl_image_header& header)
{
  constexpr int NewestImage = 2;
  const int version = IgtlHeaderVersion(header);
  if (version < 1 || version > NewestImage)
  {
    return "it has an unknown version";
  }
  if (header.num_components != 1)
  {
    return "it has " + std::to_string(header.num_components) + " values a voxel instead of one";
  }
  if (header.endian != IGTL_IMAGE_ENDIAN_BIG && header.endian != IGTL_IMAGE_ENDIAN_LITTLE)
  {
    return "it has an unknown byte order";
  }
  if (header.coord != IGTL_IMAGE_COORD_RAS && header.coord != IGTL_IMAGE_COORD_LPS)
  {
    return "it has unknown axes";
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (header.size[axis] == 0 || header.subvol_offset[axis] != 0 ||
        header.subvol_size[axis] != header.size[axis])
    {
      return "only whole images are taken";
    }
  }
  return "";
}

// Axes, spacing and origin. Returns false if an axis has no length or is not finite.
bool PlaceImage(const igtl_image_header& header, IgtlImage& image)
{
  const Vector3 toLps =
      header.coord == IGTL_IMAGE_COORD_RAS ? Vector3(-1.0, -1.0, 1.0) : Vector3(1.0, 1.0, 1.0);
  Matrix3 steps;
  Vector3 center;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      steps(row, column) = header.matrix[3 * column + row];
    }
    center[row] = header.matrix[9 + row];
  }
  steps = toLps.asDiagonal() * steps;
  center = toLps.asDiagonal() * center;
  image.Spacing = steps.colwise().norm().transpose();
  if (!steps.allFinite() || !center.allFinite() || !(image.Spacing.minCoeff() > 0.0))
  {
    return false;
  }
  image.Direction = steps * image.Spacing.cwiseInverse().asDiagonal();
  const Vector3 half = 0.5 * Vector3(image.Size[0] - 1.0, image.Size[1] - 1.0, image.Size[2] - 1.0);
  image.OriginWorld = center - steps * half;
  return true;
}

void SwapBytes(std::vector<std::uint8_t>& voxels, std::size_t bytes)
{
  for (auto voxel = voxels.begin(); voxel != voxels.end();
       voxel += static_cast<std::ptrdiff_t>(bytes))
  {
    std::reverse(voxel, voxel + static_cast<std::ptrdiff_t>(bytes));
  }
}
} // namespace

Status ReadIgtlImage(IgtlMessage message, IgtlImage& image)
{
  const auto failure = [](const std::string& why)
  { return Status::Failure("An image that was sent is not used: " + why + "."); };
  igtl_image_header header;
  if (message.Content.size() < ImageHeaderBytes)
  {
    return failure("its message is too short");
  }
  std::memcpy(&header, message.Content.data(), ImageHeaderBytes);
  igtl_image_convert_byte_order(&header);
  std::string flaw = Flaw(header);
  IgtlImage read;
  if (flaw.empty() && !TypeOf(header.scalar_type, read.Type))
  {
    flaw = "it has an unknown type of voxels";
  }
  if (!flaw.empty())
  {
    return failure(flaw);
  }
  std::copy(header.size, header.size + 3, read.Size.begin());
  const std::size_t bytes = BytesOf(read.Type);
  const std::uint64_t count = std::uint64_t{header.size[0]} * header.size[1] * header.size[2];
  if (count * bytes != message.Content.size() - ImageHeaderBytes)
  {
    return failure("it has another number of voxels than it states");
  }
  if (!PlaceImage(header, read))
  {
    return failure("its axes have no length");
  }
  read.Voxels = std::move(message.Content);
  read.Voxels.erase(read.Voxels.begin(), read.Voxels.begin() + ImageHeaderBytes);
  if ((header.endian == IGTL_IMAGE_ENDIAN_LITTLE) != (igtl_is_little_endian() != 0))
  {
    SwapBytes(read.Voxels, bytes);
  }
  image = std::move(read);
  return Status::Success();
}
} // namespace palpate
