#pragma once

#include <cstdint>
#include <filesystem>

// DCMTK's configuration header must come before its others.
#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dcistrmf.h"

namespace palpate
{
/// A DICOM file as DCMTK's parser reads it, with bounds on what a file can make the parser do. The
/// parser calls itself for each sequence in a sequence and reads a tag in every call, so its depth
/// is measured here, on the stack, whatever the transfer syntax. The bytes that it is given are
/// counted behind the inflation of deflated files.
class BoundedDicomStream : public DcmInputFileStream
{
public:
  /// `mostBytes`: how much the parser may be given. Parse in the function that makes the object.
  BoundedDicomStream(const std::filesystem::path& file, std::uint64_t mostBytes);

  /// True once sequences were nested too deeply. The stream ends there.
  bool IsTooDeep() const { return this->TooDeep; }
  /// True once there were more than the most bytes. The stream ends there.
  bool IsTooLong() const { return this->TooLong; }

  OFBool good() const override;
  OFCondition status() const override;
  OFBool eos() override;
  offile_off_t read(void* buffer, offile_off_t count) override;

private:
  bool IsStopped() const { return this->TooDeep || this->TooLong; }

  std::uintptr_t StackStart;
  std::uint64_t BytesLeft;
  bool TooDeep = false;
  bool TooLong = false;
};
} // namespace palpate
