#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// Writes DICOM files byte by byte (PS3.5, 7) that DCMTK would not write.
namespace palpate::test
{
/// Encoding of elements.
enum class DicomCoding
{
  Explicit, ///< little-endian, as everything below
  Implicit,
  BigEndian, ///< explicit
  Deflated   ///< explicit
};

/// A file of a data set's bytes, which already have that coding, except for the deflation.
std::string DicomFile(const std::string& dataset, DicomCoding coding = DicomCoding::Explicit);

/// An element in explicit little-endian coding; its value is padded to an even length.
std::string DicomElement(std::uint16_t group, std::uint16_t element, const std::string& vr,
                         const std::string& value);
/// A two-byte number.
std::string DicomShort(std::uint16_t group, std::uint16_t element, int value);
/// A sequence of these items.
std::string DicomSequence(std::uint16_t group, std::uint16_t element,
                          const std::vector<std::string>& items);

/// Nested sequences. `definedLengths`: with lengths, without delimiters.
std::string NestedDicomSequences(std::size_t levels, DicomCoding coding, bool definedLengths);

/// A segmentation object with any header claims.
struct ClaimedSegmentation
{
  int Columns = 2;
  int Rows = 2;
  std::string Frames = "1"; ///< as a decimal string
  /// Positions of the frames (mm along the normal); frames without one have the shared position.
  std::vector<std::string> Heights{"0"};
  std::size_t EmptyItems = 0; ///< further frame items, without content
  std::string Step = "1";     ///< mm between slices
  std::string Pixels = "\xFF\xFF";
  std::string MoreElements; ///< inserted by tag, from (0062,...) on
};
std::string ClaimedSegmentationBytes(const ClaimedSegmentation& claim);
} // namespace palpate::test
