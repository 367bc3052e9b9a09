#include "DicomPixels.h"

#include "DicomPixelData.h"
#include "Refusal.h"

#include "vtkSetGet.h"

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dcdeftag.h"
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace palpate
{
namespace
{
[[noreturn]] void RefuseDamaged(const std::filesystem::path& file)
{
  Refuse(file, "is truncated or damaged: its pixel data do not match its header",
         "copy or export it again");
}

// Stored values: the bits below the high bit, with their sign.
class StoredPixels
{
public:
  StoredPixels(const DicomPixelFormat& format, const std::uint8_t* bytes)
      : Bytes(bytes), BytesPerPixel(format.BitsAllocated / 8),
        DownShift(format.HighBit + 1 - format.BitsStored),
        Range(std::int64_t{1} << format.BitsStored), IsSigned(format.IsSigned)
  {
  }

  double At(vtkIdType pixel) const
  {
    std::uint32_t raw = 0;
    for (int byte = 0; byte < this->BytesPerPixel; ++byte)
    {
      raw |= std::uint32_t{this->Bytes[pixel * this->BytesPerPixel + byte]} << (8 * byte);
    }
    const std::int64_t value = (raw >> this->DownShift) & (this->Range - 1);
    return static_cast<double>(this->IsSigned && value >= this->Range / 2 ? value - this->Range
                                                                          : value);
  }

private:
  const std::uint8_t* Bytes;
  int BytesPerPixel;
  int DownShift;
  std::int64_t Range;
  bool IsSigned;
};

int StoredType(const DicomPixelFormat& format)
{
  switch (format.BitsAllocated)
  {
  case 8:
    return format.IsSigned ? VTK_SIGNED_CHAR : VTK_UNSIGNED_CHAR;
  case 16:
    return format.IsSigned ? VTK_SHORT : VTK_UNSIGNED_SHORT;
  default:
    return format.IsSigned ? VTK_INT : VTK_UNSIGNED_INT;
  }
}

template <typename T>
void Rescale(const StoredPixels& stored, const DicomPixelFormat& format, vtkIdType count, T* values)
{
  for (vtkIdType i = 0; i < count; ++i)
  {
    values[i] = static_cast<T>(stored.At(i) * format.Slope + format.Intercept);
  }
}

} // namespace

bool DicomPixelFormat::IsPlausible() const
{
  const bool isWord =
      this->BitsAllocated == 8 || this->BitsAllocated == 16 || this->BitsAllocated == 32;
  return isWord && this->BitsStored >= 1 && this->HighBit >= this->BitsStored - 1 &&
         this->HighBit < this->BitsAllocated;
}

int DicomPixelFormat::ScalarType() const
{
  if (this->Slope == 1.0 && this->Intercept == 0.0)
  {
    return StoredType(*this);
  }
  const bool whole =
      this->Slope == std::floor(this->Slope) && this->Intercept == std::floor(this->Intercept);
  const double largest =
      std::abs(this->Slope) * std::ldexp(1.0, this->BitsStored) + std::abs(this->Intercept);
  return whole && largest < std::numeric_limits<int>::max() ? VTK_INT : VTK_FLOAT;
}

DicomPixelFormat ReadPixelFormat(const DicomDataset& dataset)
{
  DcmItem& root = dataset.Root();
  DicomPixelFormat format;
  format.BitsAllocated = DicomInteger(root, DCM_BitsAllocated, 0);
  format.BitsStored = std::max(0, DicomInteger(root, DCM_BitsStored, format.BitsAllocated));
  format.HighBit = DicomInteger(root, DCM_HighBit, format.BitsStored - 1);
  format.IsSigned = DicomNumber(root, DCM_PixelRepresentation, 0.0) == 1.0;
  format.IsGrey = DicomNumber(root, DCM_SamplesPerPixel, 1.0) == 1.0 &&
                  DicomText(root, DCM_PhotometricInterpretation) != "PALETTE COLOR";
  format.TransferSyntax = dataset.TransferSyntax();
  format.Slope = DicomNumber(root, DCM_RescaleSlope, 1.0);
  format.Intercept = DicomNumber(root, DCM_RescaleIntercept, 0.0);
  return format;
}

void ReadSlicePixels(const std::filesystem::path& file, const DicomPixelFormat& format,
                     vtkIdType count, vtkDataArray* voxels, vtkIdType first,
                     DicomFrameDecoder& decoder)
{
  if (!format.IsGrey)
  {
    Refuse(file, "holds colours", "use a greyscale series");
  }
  if (!format.IsPlausible())
  {
    RefuseDamaged(file);
  }
  // Checked before the pixels are parsed, since DCMTK cannot parse an unknown syntax.
  CheckTransferSyntax(file, format.TransferSyntax);
  const DicomDataset dataset(file, DicomDataset::Extent::All);
  const DicomPixelData pixels(file, dataset, 1, decoder);
  const std::size_t bytesPerPixel = static_cast<std::size_t>(format.BitsAllocated) / 8;
  if (!pixels.Bytes() || pixels.ByteCount() < static_cast<std::size_t>(count) * bytesPerPixel)
  {
    RefuseDamaged(file);
  }
  const StoredPixels stored(format, pixels.Bytes());
  switch (voxels->GetDataType())
  {
    vtkTemplateMacro(
        Rescale(stored, format, count, static_cast<VTK_TT*>(voxels->GetVoidPointer(first))));
  }
}
} // namespace palpate
