#include "NiftiHeader.h"

#include "Refusal.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <zlib.h>

namespace palpate
{
namespace
{
constexpr std::size_t HeaderBytes = 348;

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
      Refuse(file, "ends or is damaged within its header", "copy or export it again");
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
  // The reader has swapped a NIfTI-2 header's size where it need not.
  if (size == 540 || size == 0x1c020000)
  {
    Refuse(file, "is a NIfTI-2 file, which is not read", "convert it to NIfTI-1");
  }
  if (size != static_cast<int>(HeaderBytes) || header.Mark() != "n+1")
  {
    Refuse(file, "is no NIfTI-1 file or its header is damaged", "copy or export it again");
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
    Refuse(file, "is two-dimensional", "give a volume of at least two slices");
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
             "has a voxel spacing of " + NumberText(spacing) + " along axis " +
                 std::to_string(axis),
             "correct its header: spacings must be positive");
    }
  }
}

void CheckVoxelType(const std::filesystem::path& file, const HeaderReader& header)
{
  const int type = header.At<std::int16_t>(70);
  if (type == 128 || type == 2304)
  {
    Refuse(file, "holds colours", "convert it to one grey value or label per voxel");
  }
  if (type == 32 || type == 1792 || type == 2048)
  {
    Refuse(file, "holds complex numbers", "convert it to magnitudes");
  }
}

void CheckLength(const std::filesystem::path& file, const HeaderReader& header)
{
  double needed = std::max(0.0, static_cast<double>(header.At<float>(108)));
  double data = header.At<std::int16_t>(72) / 8.0;
  for (std::size_t axis = 1; axis <= 3; ++axis)
  {
    data *= header.Dimension(axis);
  }
  needed += data;
  const double length = static_cast<double>(std::filesystem::file_size(file));
  if (!header.IsCompressed() && length < needed)
  {
    Refuse(file,
           "is truncated: its header promises " + std::to_string(std::llround(needed)) +
               " bytes and it has " + std::to_string(std::llround(length)),
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

NiftiOrientation CheckNiftiHeader(const std::filesystem::path& file)
{
  const HeaderReader header(file);
  CheckMark(file, header);
  CheckDimensions(file, header);
  CheckSpacings(file, header);
  CheckVoxelType(file, header);
  CheckLength(file, header);
  NiftiOrientation orientation;
  orientation.QFormCode = header.At<std::int16_t>(252);
  orientation.SFormCode = header.At<std::int16_t>(254);
  orientation.QFormWorld = ToWorld(QForm(header), MillimetersPerUnit(header));
  orientation.SFormWorld = ToWorld(SForm(header), MillimetersPerUnit(header));
  return orientation;
}
} // namespace palpate
