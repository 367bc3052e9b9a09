#pragma once

#include "DicomDataset.h"
#include "PalpateIOModule.h"
#include "vtkDataArray.h"

#include <filesystem>
#include <string>

namespace palpate
{
class DicomFrameDecoder;

/// How a DICOM slice stores its pixels (PS3.3, C.7.6.3) and what they mean (C.7.6.16.2.9).
struct DicomPixelFormat
{
  int BitsAllocated = 0;
  int BitsStored = 0;
  int HighBit = 0;
  bool IsSigned = false;
  bool IsGrey = true;         ///< one sample per pixel, which is not a palette index
  std::string TransferSyntax; ///< UID
  double Slope = 1.0;
  double Intercept = 0.0;

  /// Whether pixels are words of 8, 16 or 32 bits that hold the stored ones.
  PALPATEIO_EXPORT bool IsPlausible() const;
  /// The smallest VTK type that holds every value after slope and intercept: the stored type if
  /// these change nothing, int if they are whole numbers, otherwise float.
  PALPATEIO_EXPORT int ScalarType() const;
};

PALPATEIO_EXPORT DicomPixelFormat ReadPixelFormat(const DicomDataset& dataset);

/// Reads a slice's `count` values into `voxels` from value `first` on. Throws InputError.
PALPATEIO_EXPORT void ReadSlicePixels(const std::filesystem::path& file,
                                      const DicomPixelFormat& format, vtkIdType count,
                                      vtkDataArray* voxels, vtkIdType first,
                                      DicomFrameDecoder& decoder);
} // namespace palpate
