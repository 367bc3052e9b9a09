#include "NiftiHeader.h"

#include "CaretLabels.h"
#include "DecimalText.h"
#include "FileFormat.h"
#include "HeaderBytes.h"
#include "NiftiFields.h"
#include "PositiveNumber.h"
#include "Refusal.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <system_error>
#include <utility>

namespace palpate
{
namespace
{
// Codes of the header, and VTK's types.
constexpr std::array<std::pair<int, int>, 10> NiftiTypes{{{2, VTK_UNSIGNED_CHAR},
                                                          {4, VTK_SHORT},
                                                          {8, VTK_INT},
                                                          {16, VTK_FLOAT},
                                                          {64, VTK_DOUBLE},
                                                          {256, VTK_SIGNED_CHAR},
                                                          {512, VTK_UNSIGNED_SHORT},
                                                          {768, VTK_UNSIGNED_INT},
                                                          {1024, VTK_LONG},
                                                          {1280, VTK_UNSIGNED_LONG}}};

void CheckKind(const std::filesystem::path& file, const NiftiFields& fields, bool isPair)
{
  if (fields.IsPair != isPair)
  {
    Refuse(file,
           isPair ? "is not the header of a pair of files, but a NIfTI file with its voxels"
                  : "is the header of a pair of files, or is damaged",
           isPair ? "give it the ending .nii" : "give it the ending .hdr, next to its .img");
  }
}

void CheckDimensions(const std::filesystem::path& file, const NiftiFields& fields)
{
  const std::int64_t count = fields.Dimensions[0];
  if (count < 1 || count > 7)
  {
    Refuse(file, "has a damaged header", "copy or export it again");
  }
  for (std::size_t axis = 1; axis <= static_cast<std::size_t>(count); ++axis)
  {
    const std::int64_t size = fields.Dimensions[axis];
    // Some programs that write Analyze leave the size of the unused fourth axis at 0.
    const bool isUnused = axis > 3 && size == 0 && fields.Kind == NiftiFields::Version::Analyze;
    if ((size < 1 && !isUnused) || size > std::numeric_limits<int>::max())
    {
      Refuse(file, "has " + std::to_string(size) + " voxels along axis " + std::to_string(axis),
             "copy or export it again");
    }
    if (axis > 4 && size > 1)
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

void CheckSpacings(const std::filesystem::path& file, const NiftiFields& fields)
{
  for (std::size_t axis = 1; axis <= 3; ++axis)
  {
    const double spacing = fields.PixelDimensions[axis];
    if (!IsPositive(spacing))
    {
      Refuse(file,
             "has a voxel spacing of " + SignificantText(spacing) + " along axis " +
                 std::to_string(axis),
             "correct its header: spacings must be positive");
    }
  }
}

int NiftiType(const std::filesystem::path& file, int code)
{
  if (code == 128 || code == 2304)
  {
    Refuse(file, "holds colours", "convert it to one grey value or label per voxel");
  }
  if (code == 32 || code == 1792 || code == 2048)
  {
    Refuse(file, "holds complex numbers", "convert it to magnitudes");
  }
  const auto* found =
      std::find_if(NiftiTypes.begin(), NiftiTypes.end(),
                   [code](const std::pair<int, int>& type) { return type.first == code; });
  if (found == NiftiTypes.end())
  {
    Refuse(file, "has voxels of a type that is not supported (code " + std::to_string(code) + ")",
           "convert it to integers or floating-point numbers");
  }
  return found->second;
}

// Four bytes after the header say whether extensions follow.
constexpr std::size_t MarkBytes = 4;

// Where the extensions of a single file's header end: chained blocks of their size, a multiple of
// 16, and a code, which is even. Follows the chain up to `end`; equals the first block's start if
// there is none, whatever the mark says. Takes the first table of labels.
// Source: nifti1.h, "Extended header"; codes: nifti1_io.h.
std::uint64_t ExtensionEnd(const std::filesystem::path& file, const NiftiFields& fields,
                           std::uint64_t end, LabelTable& labels)
{
  constexpr std::size_t LargestCode = 1024;
  constexpr std::size_t Read = std::size_t{1} << 20;
  const std::size_t mark = fields.HeaderBytes();
  HeaderBytes bytes(file, std::min<std::size_t>(end, Read) + 2 * sizeof(std::int32_t));
  bytes.SetSwapped(fields.IsSwapped);
  std::size_t place = mark + MarkBytes;
  if (bytes.Size() <= mark || bytes.At<char>(mark) == 0)
  {
    return place;
  }
  do
  {
    if (place + 2 * sizeof(std::int32_t) > bytes.Size())
    {
      return place;
    }
    const auto size = bytes.At<std::int32_t>(place);
    const auto code = bytes.At<std::uint32_t>(place + sizeof(size));
    if (size < 16 || size % 16 != 0 || code % 2 != 0 || code > LargestCode)
    {
      return place;
    }
    const std::size_t next = place + static_cast<std::size_t>(size);
    if (labels.empty() && next <= bytes.Size())
    {
      labels = LabelsOfCaret(bytes.TextAt(place + 8, next)).value_or(LabelTable());
    }
    place = next;
  } while (place < end);
  return place;
}

// The data of a single file start behind its header and its extensions.
std::uint64_t VoxelOffset(const std::filesystem::path& file, const NiftiFields& fields,
                          NiftiHeader& header)
{
  const double offset = fields.VoxelOffset;
  if (!std::isfinite(offset) || offset > 1e9)
  {
    Refuse(file, "has a damaged header (vox_offset)", "copy or export it again");
  }
  const auto stated = static_cast<std::uint64_t>(std::max(0.0, offset));
  if (fields.IsPair)
  {
    return stated;
  }
  const std::uint64_t first = fields.HeaderBytes() + MarkBytes;
  const bool isStated = stated >= fields.HeaderBytes();
  const std::uint64_t start = isStated ? stated : first;
  const std::uint64_t end = ExtensionEnd(file, fields, std::max(start, first), header.Labels);
  if (end > std::max(start, first))
  {
    Refuse(file,
           "has voxels that start within an extension of its header (at byte " +
               std::to_string(start) + ", but the extension ends at " + std::to_string(end) + ")",
           "correct vox_offset in its header, or export it again");
  }
  if (start < first || !isStated)
  {
    header.Notes.push_back("The header says that voxels start at byte " + std::to_string(stated) +
                           ", within the header; they were read from byte " +
                           std::to_string(start) + " on.");
  }
  return start;
}

double MillimetersPerUnit(const NiftiFields& fields)
{
  switch (fields.Units & 7)
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
double FiniteOrZero(double value)
{
  return std::isfinite(value) ? value : 0.0;
}

// From RAS in the file's unit to LPS in mm.
Eigen::Matrix<double, 3, 4> ToWorld(const Eigen::Matrix<double, 3, 4>& form, double unit)
{
  return (unit * Vector3(-1.0, -1.0, 1.0)).asDiagonal() * form;
}

Eigen::Matrix<double, 3, 4> QForm(const NiftiFields& fields)
{
  const Vector3 imaginary(fields.QForm[0], fields.QForm[1], fields.QForm[2]);
  const double real = std::sqrt(std::max(0.0, 1.0 - imaginary.squaredNorm()));
  const Eigen::Quaterniond turn(real, imaginary[0], imaginary[1], imaginary[2]);
  const double lastSign = fields.PixelDimensions[0] < 0.0 ? -1.0 : 1.0;
  const Vector3 steps(fields.PixelDimensions[1], fields.PixelDimensions[2],
                      lastSign * fields.PixelDimensions[3]);
  Eigen::Matrix<double, 3, 4> form;
  form << turn.normalized().toRotationMatrix() * steps.asDiagonal(),
      Vector3(fields.QForm[3], fields.QForm[4], fields.QForm[5]);
  return form;
}

Eigen::Matrix<double, 3, 4> SForm(const NiftiFields& fields)
{
  return Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(fields.SForm.data());
}

// The file next to a header that holds its voxels: NAME.img or NAME.img.gz.
std::filesystem::path VoxelFile(const std::filesystem::path& header)
{
  const bool isPacked = !EndingOf(header, {".gz"}).empty();
  const std::filesystem::path stem =
      isPacked ? header.parent_path() / header.stem().stem() : header.parent_path() / header.stem();
  const bool isUpperCase = header.extension() == ".HDR";
  const std::string plain = isUpperCase ? ".IMG" : ".img";
  for (const std::string& ending : {isPacked ? ".img.gz" : plain, isPacked ? plain : ".img.gz"})
  {
    std::filesystem::path file = stem;
    file += ending;
    std::error_code failure;
    if (std::filesystem::is_regular_file(file, failure))
    {
      return file;
    }
  }
  Refuse(header, "lacks its data file, " + stem.filename().string() + ".img or .img.gz",
         "copy both files of the pair");
}

VoxelLayout LayoutOf(const std::filesystem::path& file, const NiftiFields& fields,
                     NiftiHeader& header)
{
  VoxelLayout layout;
  layout.File = fields.IsPair ? VoxelFile(file) : file;
  layout.Type = NiftiType(file, fields.Type);
  layout.Offset = VoxelOffset(file, fields, header);
  layout.Voxels = CountVoxels(file, header.Size);
  layout.Volumes = fields.Dimensions[0] > 3 ? std::max<std::int64_t>(1, fields.Dimensions[4]) : 1;
  layout.IsSwapped = fields.IsSwapped;
  layout.Slope = FiniteOrZero(fields.Slope);
  layout.Slope = layout.Slope == 0.0 ? 1.0 : layout.Slope;
  layout.Intercept = FiniteOrZero(fields.Intercept);
  return layout;
}
} // namespace

NiftiHeader ReadNiftiHeader(const std::filesystem::path& file, bool isPair)
{
  const NiftiFields fields = ReadNiftiFields(file);
  CheckKind(file, fields, isPair);
  CheckDimensions(file, fields);
  CheckSpacings(file, fields);
  NiftiHeader header;
  const double unit = MillimetersPerUnit(fields);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    header.Size[axis] = static_cast<int>(fields.Dimensions[axis + 1]);
    header.Spacing[static_cast<Eigen::Index>(axis)] = unit * fields.PixelDimensions[axis + 1];
  }
  header.Voxels = LayoutOf(file, fields, header);
  header.IsAnalyze = fields.Kind == NiftiFields::Version::Analyze;
  header.Orientation.QFormCode = fields.QFormCode;
  header.Orientation.SFormCode = fields.SFormCode;
  header.Orientation.QFormWorld = ToWorld(QForm(fields), unit);
  header.Orientation.SFormWorld = ToWorld(SForm(fields), unit);
  return header;
}
} // namespace palpate
