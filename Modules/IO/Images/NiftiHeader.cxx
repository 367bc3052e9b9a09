#include "NiftiHeader.h"

#include "DecimalText.h"
#include "ForeignFile.h"
#include "Refusal.h"
#include "ZlibCheck.h"

#include "vtkDataArray.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <utility>
#include <zlib.h>

namespace palpate
{
namespace
{
constexpr std::size_t HeaderBytes = 348;

// Codes of the header, and VTK's types.
constexpr std::array<std::pair<int, int>, 10> VoxelTypes{{{2, VTK_UNSIGNED_CHAR},
                                                          {4, VTK_SHORT},
                                                          {8, VTK_INT},
                                                          {16, VTK_FLOAT},
                                                          {64, VTK_DOUBLE},
                                                          {256, VTK_SIGNED_CHAR},
                                                          {512, VTK_UNSIGNED_SHORT},
                                                          {768, VTK_UNSIGNED_INT},
                                                          {1024, VTK_LONG},
                                                          {1280, VTK_UNSIGNED_LONG}}};

// The header's bytes, and reading of numbers in the file's byte order.
class HeaderReader
{
public:
  explicit HeaderReader(const std::filesystem::path& file)
  {
    // gzread passes files that are not compressed through as they are.
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> stream(gzopen(file.c_str(), "rb"), gzclose);
    const int got = stream ? gzread(stream.get(), this->Bytes.data(), HeaderBytes) : 0;
    this->Compressed = stream && gzdirect(stream.get()) == 0;
    if (got < static_cast<int>(HeaderBytes))
    {
      RefuseContent(file, "has a truncated or damaged header", "copy or export it again");
    }
    this->Swap = this->At<std::int32_t>(0) != static_cast<int>(HeaderBytes);
  }

  template <typename T>
  T At(std::size_t offset) const
  {
    std::array<unsigned char, sizeof(T)> raw;
    std::copy_n(this->Bytes.begin() + static_cast<std::ptrdiff_t>(offset), sizeof(T), raw.begin());
    if (this->Swap)
    {
      std::reverse(raw.begin(), raw.end());
    }
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    return value;
  }

  std::string Mark() const { return {this->Bytes.begin() + 344, this->Bytes.begin() + 347}; }
  bool IsCompressed() const { return this->Compressed; }
  bool IsSwapped() const { return this->Swap; }
  int Dimension(std::size_t i) const { return this->At<std::int16_t>(40 + 2 * i); }
  double PixelDimension(std::size_t i) const
  {
    return static_cast<double>(this->At<float>(76 + 4 * i));
  }

private:
  std::array<unsigned char, HeaderBytes> Bytes{};
  bool Compressed = false;
  bool Swap = false;
};

void CheckMark(const std::filesystem::path& file, const HeaderReader& header)
{
  const auto size = header.At<std::int32_t>(0);
  // The reader may have swapped the size of a NIfTI-2 header.
  if (size == 540 || size == 0x1c020000)
  {
    Refuse(file, "is a NIfTI-2 file, which is not supported", "convert it to NIfTI-1");
  }
  if (size != static_cast<int>(HeaderBytes) || header.Mark() != "n+1")
  {
    RefuseContent(file, "is not a NIfTI-1 file, or its header is damaged",
                  "copy or export it again");
  }
}

void CheckDimensions(const std::filesystem::path& file, const HeaderReader& header)
{
  const int count = header.Dimension(0);
  if (count < 1 || count > 7)
  {
    Refuse(file, "has a damaged header", "copy or export it again");
  }
  for (int axis = 1; axis <= count; ++axis)
  {
    const int size = header.Dimension(static_cast<std::size_t>(axis));
    if (size < 1)
    {
      Refuse(file, "has " + std::to_string(size) + " voxels along axis " + std::to_string(axis),
             "copy or export it again");
    }
    if (axis > 3 && size > 1)
    {
      Refuse(file,
             "has " + std::to_string(count) + " dimensions (" + std::to_string(size) +
                 " along axis " + std::to_string(axis) + ")",
             "extract one three-dimensional volume of it");
    }
  }
  if (count < 3)
  {
    Refuse(file, "is two-dimensional", "use a volume of at least two slices");
  }
}

void CheckSpacings(const std::filesystem::path& file, const HeaderReader& header)
{
  for (std::size_t axis = 1; axis <= 3; ++axis)
  {
    const double spacing = header.PixelDimension(axis);
    if (!(std::isfinite(spacing) && spacing > 0.0))
    {
      Refuse(file,
             "has a voxel spacing of " + SignificantText(spacing) + " along axis " +
                 std::to_string(axis),
             "correct its header: spacings must be positive");
    }
  }
}

int VoxelType(const std::filesystem::path& file, const HeaderReader& header)
{
  const int code = header.At<std::int16_t>(70);
  if (code == 128 || code == 2304)
  {
    Refuse(file, "holds colours", "convert it to one grey value or label per voxel");
  }
  if (code == 32 || code == 1792 || code == 2048)
  {
    Refuse(file, "holds complex numbers", "convert it to magnitudes");
  }
  const auto* found =
      std::find_if(VoxelTypes.begin(), VoxelTypes.end(),
                   [code](const std::pair<int, int>& type) { return type.first == code; });
  if (found == VoxelTypes.end())
  {
    Refuse(file, "has voxels of a type that is not supported (code " + std::to_string(code) + ")",
           "convert it to integers or floating-point numbers");
  }
  return found->second;
}

// The data of a single file cannot start within its header, whatever the header states.
std::size_t VoxelOffset(const std::filesystem::path& file, const HeaderReader& header)
{
  const double offset = header.At<float>(108);
  if (!std::isfinite(offset) || offset > 1e9)
  {
    Refuse(file, "has a damaged header (vox_offset)", "copy or export it again");
  }
  return std::max(HeaderBytes, static_cast<std::size_t>(std::max(0.0, offset)));
}

void CheckLength(const std::filesystem::path& file, bool isCompressed, const NiftiHeader& header)
{
  const auto bytesPerVoxel =
      static_cast<std::size_t>(vtkDataArray::GetDataTypeSize(header.VoxelType));
  const std::size_t needed = header.VoxelOffset + static_cast<std::size_t>(header.Size[0]) *
                                                      static_cast<std::size_t>(header.Size[1]) *
                                                      static_cast<std::size_t>(header.Size[2]) *
                                                      bytesPerVoxel;
  const std::uintmax_t length = std::filesystem::file_size(file);
  if (isCompressed)
  {
    CheckInflatedSize(file, static_cast<double>(length), static_cast<double>(needed));
  }
  if (!isCompressed && length < needed)
  {
    Refuse(file,
           "is truncated: its header declares " + std::to_string(needed) + " bytes but it has " +
               std::to_string(length),
           "copy or export it again");
  }
}

double MillimetersPerUnit(const HeaderReader& header)
{
  switch (header.At<char>(123) & 7)
  {
  case 1:
    return 1000.0;
  case 3:
    return 0.001;
  default:
    return 1.0;
  }
}

// A slope or an intercept that is NaN or infinite counts as absent.
double FiniteOrZero(float value)
{
  return std::isfinite(value) ? static_cast<double>(value) : 0.0;
}

// From RAS in the file's unit to LPS in mm.
Eigen::Matrix<double, 3, 4> ToWorld(const Eigen::Matrix<double, 3, 4>& form, double unit)
{
  return (unit * Vector3(-1.0, -1.0, 1.0)).asDiagonal() * form;
}

Eigen::Matrix<double, 3, 4> QForm(const HeaderReader& header)
{
  const Vector3 imaginary(header.At<float>(256), header.At<float>(260), header.At<float>(264));
  const double real = std::sqrt(std::max(0.0, 1.0 - imaginary.squaredNorm()));
  const Eigen::Quaterniond turn(real, imaginary[0], imaginary[1], imaginary[2]);
  const double lastSign = header.PixelDimension(0) < 0.0 ? -1.0 : 1.0;
  const Vector3 steps(header.PixelDimension(1), header.PixelDimension(2),
                      lastSign * header.PixelDimension(3));
  Eigen::Matrix<double, 3, 4> form;
  form << turn.normalized().toRotationMatrix() * steps.asDiagonal(),
      Vector3(header.At<float>(268), header.At<float>(272), header.At<float>(276));
  return form;
}

Eigen::Matrix<double, 3, 4> SForm(const HeaderReader& header)
{
  Eigen::Matrix<double, 3, 4> form;
  for (int entry = 0; entry < 12; ++entry)
  {
    form(entry / 4, entry % 4) =
        static_cast<double>(header.At<float>(280 + 4 * static_cast<std::size_t>(entry)));
  }
  return form;
}
} // namespace

NiftiHeader ReadNiftiHeader(const std::filesystem::path& file)
{
  const HeaderReader reader(file);
  CheckMark(file, reader);
  CheckDimensions(file, reader);
  CheckSpacings(file, reader);
  NiftiHeader header;
  const double unit = MillimetersPerUnit(reader);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    header.Size[axis] = reader.Dimension(axis + 1);
    header.Spacing[static_cast<Eigen::Index>(axis)] = unit * reader.PixelDimension(axis + 1);
  }
  header.VoxelType = VoxelType(file, reader);
  header.VoxelOffset = VoxelOffset(file, reader);
  header.Slope = FiniteOrZero(reader.At<float>(112));
  header.Slope = header.Slope == 0.0 ? 1.0 : header.Slope;
  header.Intercept = FiniteOrZero(reader.At<float>(116));
  header.IsSwapped = reader.IsSwapped();
  header.Orientation.QFormCode = reader.At<std::int16_t>(252);
  header.Orientation.SFormCode = reader.At<std::int16_t>(254);
  header.Orientation.QFormWorld = ToWorld(QForm(reader), unit);
  header.Orientation.SFormWorld = ToWorld(SForm(reader), unit);
  CheckLength(file, reader.IsCompressed(), header);
  return header;
}
} // namespace palpate
