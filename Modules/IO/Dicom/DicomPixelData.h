#pragma once

#include "DicomDataset.h"
#include "PalpateIOModule.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
class DicomFrameDecoder;

/// Throws InputError if the transfer syntax of the pixels is not supported.
PALPATEIO_EXPORT void CheckTransferSyntax(const std::filesystem::path& file,
                                          const std::string& transferSyntaxUid);

/// The grey pixels of a DICOM file, decompressed if needed: all frames, row by row, little-endian
/// words of BitsAllocated bits (several pixels per byte if that is 1).
class PALPATEIO_EXPORT DicomPixelData
{
public:
  /// `dataset` must outlive the object. Throws InputError for pixels that cannot be decoded or do
  /// not fit into memory.
  DicomPixelData(const std::filesystem::path& file, const DicomDataset& dataset,
                 std::size_t frameCount, DicomFrameDecoder& decoder);

  /// Null if there are none.
  const std::uint8_t* Bytes() const
  {
    return this->Decoded.empty() ? this->Native : this->Decoded.data();
  }
  /// Actual number of bytes, for the caller to compare with the header.
  std::size_t ByteCount() const { return this->Count; }

private:
  void Decode(const std::filesystem::path& file, const DicomDataset& dataset,
              std::size_t frameCount, DicomFrameDecoder& decoder);

  const std::uint8_t* Native = nullptr; // in the data set
  std::size_t Count = 0;
  std::vector<std::uint8_t> Decoded;
};
} // namespace palpate
