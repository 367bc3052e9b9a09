#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace palpate::test
{
/// Where a data element, or an item, lies in the bytes of a DICOM file of explicit little-endian
/// elements (PS3.5, 7.1).
struct DicomElement
{
  static constexpr std::uint32_t Item = 0xFFFEE000;
  static constexpr std::uint32_t PixelData = 0x7FE00010;

  std::uint32_t Tag = 0; ///< group in the upper half
  std::string Vr;        ///< empty for an item
  std::size_t First = 0; ///< of its tag
  std::size_t LengthPlace = 0;
  std::size_t LengthBytes = 4; ///< 2 or 4
  std::size_t Value = 0;       ///< where its value begins
  std::size_t Count = 0;       ///< bytes of the value, without a delimiter
  std::size_t End = 0;         ///< behind its delimiter
  bool HasUndefinedLength = false;
  int Parent = -1; ///< the sequence or item that it lies in; -1: none
};

/// Of a file with a preamble, outer elements before inner ones. What cannot be followed is left
/// out.
std::vector<DicomElement> DicomElementsOf(const std::string& bytes);

/// Replaces bytes within an element's value; the lengths that are stated of it, and of all that it
/// lies in, stay true. The other elements' places do not.
void ReplaceInValue(std::string& bytes, const std::vector<DicomElement>& elements,
                    std::size_t element, std::size_t first, std::size_t count,
                    const std::string& by);
/// Replaces all of an element, or puts something in front of it where `count` is 0.
void ReplaceElement(std::string& bytes, const std::vector<DicomElement>& elements,
                    std::size_t element, std::size_t count, const std::string& by);
} // namespace palpate::test
