#include "NiftiFields.h"

#include "ForeignFile.h"
#include "HeaderBytes.h"

#include <string>

namespace palpate
{
namespace
{
constexpr std::size_t FirstHeader = 348;
constexpr std::size_t SecondHeader = 540;

// Offsets of a header's fields; both versions have the same fields in another order and width.
struct Places
{
  std::size_t Dimensions, PixelDimensions, Type, VoxelOffset, Slope, Intercept, Units, QFormCode,
      SFormCode, QForm, SForm;
};

constexpr Places First{40, 76, 70, 108, 112, 116, 123, 252, 254, 256, 280};
constexpr Places Second{16, 104, 12, 168, 176, 184, 500, 344, 348, 352, 400};

std::string TextAt(const HeaderBytes& header, std::size_t offset)
{
  std::string text;
  for (std::size_t i = 0; i < 3; ++i)
  {
    text += header.At<char>(offset + i);
  }
  return text;
}

// Finds the byte order by the header's own length, which every version starts with.
std::int32_t StatedLength(HeaderBytes& header)
{
  for (const bool isSwapped : {false, true})
  {
    header.SetSwapped(isSwapped);
    const auto length = header.At<std::int32_t>(0);
    if (length == FirstHeader || length == SecondHeader)
    {
      return length;
    }
  }
  return 0;
}

template <typename Number, std::size_t Count>
void Take(const HeaderBytes& header, std::size_t place, std::array<double, Count>& numbers)
{
  for (std::size_t i = 0; i < Count; ++i)
  {
    numbers[i] = static_cast<double>(header.At<Number>(place + i * sizeof(Number)));
  }
}

template <typename Size, typename Real, typename Code>
void TakeFields(const HeaderBytes& header, const Places& at, NiftiFields& fields)
{
  for (std::size_t i = 0; i < fields.Dimensions.size(); ++i)
  {
    fields.Dimensions[i] = header.At<Size>(at.Dimensions + i * sizeof(Size));
  }
  Take<Real>(header, at.PixelDimensions, fields.PixelDimensions);
  fields.Type = header.At<std::int16_t>(at.Type);
  if (fields.Kind == NiftiFields::Version::Analyze)
  {
    return;
  }
  fields.Slope = static_cast<double>(header.At<Real>(at.Slope));
  fields.Intercept = static_cast<double>(header.At<Real>(at.Intercept));
  fields.QFormCode = header.At<Code>(at.QFormCode);
  fields.SFormCode = header.At<Code>(at.SFormCode);
  Take<Real>(header, at.QForm, fields.QForm);
  Take<Real>(header, at.SForm, fields.SForm);
}

void TakeFirst(const HeaderBytes& header, NiftiFields& fields)
{
  TakeFields<std::int16_t, float, std::int16_t>(header, First, fields);
  fields.VoxelOffset = header.At<float>(First.VoxelOffset);
  fields.Units = fields.Kind == NiftiFields::Version::Analyze ? 0 : header.At<char>(First.Units);
}

void TakeSecond(const HeaderBytes& header, NiftiFields& fields)
{
  TakeFields<std::int64_t, double, std::int32_t>(header, Second, fields);
  fields.VoxelOffset = static_cast<double>(header.At<std::int64_t>(Second.VoxelOffset));
  fields.Units = header.At<std::int32_t>(Second.Units);
}
} // namespace

NiftiFields ReadNiftiFields(const std::filesystem::path& file)
{
  HeaderBytes header(file, SecondHeader);
  if (header.Size() < FirstHeader)
  {
    RefuseContent(file, "has a truncated or damaged header", "copy or export it again");
  }
  NiftiFields fields;
  const std::int32_t length = StatedLength(header);
  const std::string mark = TextAt(header, length == SecondHeader ? 4 : 344);
  const char version = length == SecondHeader ? '2' : '1';
  const bool isNifti = mark[0] == 'n' && (mark[1] == '+' || mark[1] == 'i') && mark[2] == version;
  // Only the mark tells Analyze from NIfTI-1.
  if (length == 0 || (!isNifti && (length == SecondHeader || mark[0] == 'n')))
  {
    RefuseContent(file, "is not a NIfTI file, or its header is damaged", "copy or export it again");
  }
  if (header.Size() < static_cast<std::size_t>(length))
  {
    RefuseContent(file, "has a truncated or damaged header", "copy or export it again");
  }
  fields.IsSwapped = header.IsSwapped();
  fields.IsPair = mark[1] != '+';
  fields.Kind = !isNifti                ? NiftiFields::Version::Analyze
                : length == FirstHeader ? NiftiFields::Version::Nifti1
                                        : NiftiFields::Version::Nifti2;
  length == SecondHeader ? TakeSecond(header, fields) : TakeFirst(header, fields);
  return fields;
}
} // namespace palpate
