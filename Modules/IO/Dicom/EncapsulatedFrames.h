#pragma once

#include "PalpateIOModule.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class DcmItem;
class DcmPixelItem;

namespace palpate
{
/// Assembles the compressed frames of a DICOM file from its fragments. Source: DICOM PS3.5, A.4.
class PALPATEIO_EXPORT EncapsulatedFrames
{
public:
  /// Finds `frameCount` frames among the fragments of `root`, which must outlive the object. (DCMTK
  /// has already refused fragments beyond the end of the file.)
  EncapsulatedFrames(DcmItem& root, std::size_t frameCount);

  /// False if the assignment of fragments to frames cannot be determined.
  bool AreFound() const { return !this->FirstFragments.empty(); }
  /// Of all fragments.
  std::size_t ByteCount() const;
  /// The bytes of a frame, with any padding after its end; fewer or none if they cannot be read.
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
