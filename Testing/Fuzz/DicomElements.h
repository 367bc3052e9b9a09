#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace palpate::test
{
/// Position of a data element or item in a DICOM file in explicit VR little endian (PS3.5, 7.1).
struct DicomElement
{
  static constexpr std::uint32_t Item = 0xFFFEE000;
  static constexpr std::uint32_t PixelData = 0x7FE00010;

  std::uint32_t Tag = 0; ///< group in the upper 16 bits
  std::string Vr;        ///< empty for an item
  std::size_t First = 0; ///< offset of its tag
  std::size_t LengthPlace = 0;
  std::size_t LengthBytes = 4; ///< 2 or 4
  std::size_t Value = 0;       ///< offset of its value
  std::size_t Count = 0;       ///< length of the value in bytes, without a delimiter
  std::size_t End = 0;         ///< offset after its delimiter
  bool HasUndefinedLength = false;
  int Parent = -1; ///< index of the enclosing sequence or item; -1: none
};

/// All elements of a file with a preamble, parents before children. Stops at the first parse error.
std::vector<DicomElement> DicomElementsOf(const std::string& bytes);

/// Replaces bytes of an element's value and updates the length fields of the element and its
/// parents. `elements` is out of date afterwards.
void ReplaceInValue(std::string& bytes, const std::vector<DicomElement>& elements,
                    std::size_t element, std::size_t first, std::size_t count,
                    const std::string& by);
/// Replaces the first `count` bytes of an element, from its tag on; inserts before it if `count` is
/// 0. Updates the length fields of its parents.
void ReplaceElement(std::string& bytes, const std::vector<DicomElement>& elements,
                    std::size_t element, std::size_t count, const std::string& by);
} // namespace palpate::test
