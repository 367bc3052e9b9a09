#pragma once

#include "Vector3.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

/// Image files for tests, written byte by byte from the formats' definitions, so that the tests are
/// independent of the readers' libraries (DICOM goes through DCMTK's data set writer).
namespace palpate::test
{
/// Values in memory order.
template <typename T>
std::string BytesOf(const std::vector<T>& values)
{
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// 0, 1, 2, ...
template <typename T>
std::vector<T> Counting(std::size_t count)
{
  std::vector<T> values(count);
  std::iota(values.begin(), values.end(), T(0));
  return values;
}

/// A NIfTI-1 header's fields (nifti1.h); the defaults are a 4 x 5 x 6 volume of bytes, 2 mm.
struct NiftiSpec
{
  std::array<short, 8> Dimensions{{3, 4, 5, 6, 1, 1, 1, 1}};
  short Type = 2; ///< 2 unsigned char, 4 short, 8 int, 16 float, 64 double, 512 unsigned short
  short Bits = 8;
  std::array<float, 4> PixelDimensions{{1, 2, 2, 2}};
  short QFormCode = 0;
  short SFormCode = 1;
  std::array<float, 12> SForm{{2, 0, 0, 10, 0, 2, 0, 20, 0, 0, 2, 30}}; ///< rows, RAS
  std::array<float, 6> QForm{{0, 0, 0, 10, 20, 30}}; ///< quaternion b, c, d; offset, RAS
  float Slope = 0;
  float Intercept = 0;

  std::size_t VoxelCount() const;
};

std::string NiftiBytes(const NiftiSpec& spec, const std::string& voxels);
/// Zeros for voxels.
std::string NiftiBytes(const NiftiSpec& spec);
/// Such a file with an extension of its header: a text under this code.
std::string WithNiftiExtension(std::string bytes, const std::string& text, std::int32_t code);

/// All 48 assignments of three index axes to three world axes, with signs; columns are index axes.
std::vector<Eigen::Matrix3d> AllAxisOrders();

/// A header of lines, an empty line, the data.
std::string NrrdBytes(const std::vector<std::string>& lines, const std::string& voxels);
/// Header of a raw 4 x 5 x 6 NRRD of a type, LPS, 2 mm.
std::vector<std::string> PlainNrrdLines(const std::string& type);

/// Lines of a MetaImage with its data in the same file; 4 x 5 x 6, 2 mm.
std::string MetaImageBytes(const std::string& type, const std::string& voxels,
                           const std::string& moreLines = "");

std::string Gzipped(const std::string& bytes);
/// zlib's own wrapper, as in MetaImage.
std::string Deflated(const std::string& bytes);

/// An uncompressed slice of a DICOM MR series; the default has 4 columns, 3 rows, 16 bits, and one
/// stored value for all pixels.
struct DicomSliceSpec
{
  std::string SeriesUid = "1.2.3";
  std::string Description = "synthetic";
  int SeriesNumber = 1;
  std::string Date; ///< of the series, omitted if empty
  Vector3 PositionWorld = Vector3::Zero();
  Vector3 RowWorld = Vector3::UnitX();
  Vector3 ColumnWorld = Vector3::UnitY();
  int Columns = 4;
  int Rows = 3;
  std::uint16_t Value = 0;
  std::vector<int> Pixels; ///< if not empty, used instead of Value; stored in BitsStored bits
  int BitsAllocated = 16;  ///< or 8
  int BitsStored = 16;
  bool IsSigned = false;
  std::string Slope; ///< omitted if empty, as is the intercept
  std::string Intercept;
};
void WriteDicomSlice(const std::filesystem::path& file, const DicomSliceSpec& spec);

/// A DICOM segmentation object: 2 mm, 4 columns and 3 rows by default; a frame has a value for each
/// pixel.
struct DicomSegmentationSpec
{
  struct Frame
  {
    int SegmentNumber = 1;
    double Height = 0.0; ///< mm along the slice normal
    std::vector<int> Pixels = std::vector<int>(12, 0);
  };
  struct Description
  {
    int Number = 1;
    std::string Name;
  };
  int Columns = 4;
  int Rows = 3;
  std::string Kind = "BINARY";
  int BitsAllocated = 1;
  double StatedStep = 3.0; ///< mm; omitted if 0
  std::vector<Description> Segments;
  std::vector<Frame> Frames;
};
void WriteDicomSegmentation(const std::filesystem::path& file, const DicomSegmentationSpec& spec);
} // namespace palpate::test
