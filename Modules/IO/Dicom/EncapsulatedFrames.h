#pragma once

#include "PalpateIOModule.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class DcmItem;
class DcmPixelItem;

namespace palpate
{
/// Compressed pixels as a DICOM file holds them: fragments that are put together to frames. Source:
/// DICOM PS3.5, A.4.
class PALPATEIO_EXPORT EncapsulatedFrames
{
public:
  /// Finds `frameCount` frames among the fragments of `root`, which must outlive the object. (DCMTK
  /// has refused fragments that end behind the file's end.)
  EncapsulatedFrames(DcmItem& root, std::size_t frameCount);

  /// False where it cannot be told which fragments belong to which frame.
  bool AreFound() const { return !this->FirstFragments.empty(); }
  /// Of all fragments.
  std::size_t ByteCount() const;
  /// The bytes of a frame, with any padding after its end. Fewer or none where they cannot be read.
  std::vector<std::uint8_t> Frame(std::size_t frame) const;

private:
  bool CollectFragments(DcmItem& root);
  void DivideByOffsets(std::size_t frameCount);
  void DivideByMarks(std::size_t frameCount);

  DcmPixelItem* OffsetTable = nullptr;
  std::vector<DcmPixelItem*> Fragments;
  // Of each frame, and the number of fragments.
  std::vector<std::size_t> FirstFragments;
};
} // namespace palpate
