#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// DICOM files byte by byte (PS3.5, 7), for what DCMTK would not write.
namespace palpate::test
{
/// How elements are written.
enum class DicomCoding
{
  Explicit, ///< little-endian, as everything below
  Implicit,
  BigEndian, ///< explicit
  Deflated   ///< explicit
};

/// A file of a data set's bytes, which are in that coding already, but for the deflation.
std::string DicomFile(const std::string& dataset, DicomCoding coding = DicomCoding::Explicit);

/// An element in explicit little-endian coding; its value is padded to an even length.
std::string DicomElement(std::uint16_t group, std::uint16_t element, const std::string& vr,
                         const std::string& value);
/// A number of two bytes.
std::string DicomShort(std::uint16_t group, std::uint16_t element, int value);
/// A sequence of these items.
std::string DicomSequence(std::uint16_t group, std::uint16_t element,
                          const std::vector<std::string>& items);

/// Sequences in sequences. `definedLengths`: with their lengths, without delimiters.
std::string NestedDicomSequences(std::size_t levels, DicomCoding coding, bool definedLengths);

/// A segmentation object as it may claim to be.
struct ClaimedSegmentation
{
  int Columns = 2;
  int Rows = 2;
  std::string Frames = "1"; ///< as a decimal string
  /// Positions of the frames (mm along the normal); frames without one lie in the shared one's
  /// place.
  std::vector<std::string> Heights{"0"};
  std::size_t EmptyItems = 0; ///< items of frames after those, without content
  std::string Step = "1";     ///< mm between slices
  std::string Pixels = "\xFF\xFF";
  std::string MoreElements; ///< between the others, by tag from (0062,...) on
};
std::string ClaimedSegmentationBytes(const ClaimedSegmentation& claim);
} // namespace palpate::test
