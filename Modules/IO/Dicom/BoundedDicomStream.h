#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

// DCMTK's configuration header must come before its others.
#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dcistrmf.h"

namespace palpate
{
/// Input stream for DCMTK's parser that bounds the depth, width and length of a file. The parser
/// recurses for each nested sequence and reads a tag in every call, so its depth is measured here
/// on the stack, for any transfer syntax. It marks the position before each element, which allows
/// counting the elements of a data set or item at each depth; the parser searches all earlier
/// elements if a tag is out of order, and for the creator of a private one. Bytes are counted after
/// the inflation of deflated files.
class BoundedDicomStream : public DcmInputFileStream
{
public:
  /// `mostBytes`: the most bytes that the parser may read. Parse in the function that creates the
  /// object.
  BoundedDicomStream(const std::filesystem::path& file, std::uint64_t mostBytes);

  /// True after sequences nested too deeply. The stream ends there.
  bool IsTooDeep() const { return this->TooDeep; }
  /// True after more than `mostBytes` bytes. The stream ends there.
  bool IsTooLong() const { return this->TooLong; }
  /// True after a data set or item with more than MostElements elements. The stream ends there.
  bool IsTooWide() const { return this->TooWide; }

  /// DICOM's dictionary has some 5,000 attributes, of which a file uses some hundred; the same
  /// holds for private ones.
  static constexpr std::size_t MostElements = 5000;

  OFBool good() const override;
  OFCondition status() const override;
  OFBool eos() override;
  offile_off_t read(void* buffer, offile_off_t count) override;
  void mark() override;

private:
  /// A data set or item being read, identified by its depth on the stack.
  struct Level
  {
    std::uintptr_t Depth;
    std::size_t Elements;
  };

  std::uintptr_t Depth() const;
  // Takes the bytes after a mark.
  void TakeTag(const char* bytes, std::size_t count);
  bool IsStopped() const { return this->TooDeep || this->TooLong || this->TooWide; }

  std::uintptr_t StackStart;
  std::uint64_t BytesLeft;
  bool TooDeep = false;
  bool TooLong = false;
  bool TooWide = false;
  std::vector<Level> Levels;
  std::string Tag; ///< as far as it was read
  bool IsAtTag = false;
};
} // namespace palpate
