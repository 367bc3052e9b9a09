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
/// A DICOM file as DCMTK's parser reads it, with bounds on what a file can make the parser do. The
/// parser calls itself for each sequence in a sequence and reads a tag in every call, so its depth
/// is measured here, on the stack, whatever the transfer syntax. It marks the place before each
/// element, so that the elements of a data set or item are counted at each depth: for each it goes
/// through those before it, where tags fall and for the creators of private ones. The bytes that it
/// is given are counted behind the inflation of deflated files.
class BoundedDicomStream : public DcmInputFileStream
{
public:
  /// `mostBytes`: how much the parser may be given. Parse in the function that makes the object.
  BoundedDicomStream(const std::filesystem::path& file, std::uint64_t mostBytes);

  /// True once sequences were nested too deeply. The stream ends there.
  bool IsTooDeep() const { return this->TooDeep; }
  /// True once there were more than the most bytes. The stream ends there.
  bool IsTooLong() const { return this->TooLong; }
  /// True once a data set or item had more than MostElements elements. The stream ends there.
  bool IsTooWide() const { return this->TooWide; }

  /// The dictionary has some 5,000, of which a file needs some hundred; so it is with private ones.
  static constexpr std::size_t MostElements = 5000;

  OFBool good() const override;
  OFCondition status() const override;
  OFBool eos() override;
  offile_off_t read(void* buffer, offile_off_t count) override;
  void mark() override;

private:
  /// A data set or item that is being read, by how deep on the stack that is.
  struct Level
  {
    std::uintptr_t Depth;
    std::size_t Elements;
  };

  std::uintptr_t Depth() const;
  // What follows a mark.
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
