#include "BoundedDicomStream.h"

#include "dcmtk/dcmdata/dcerror.h"

#include <algorithm>
#include <limits>

namespace palpate
{
namespace
{
// A thread has some megabytes, and what the parser made is looked through and freed by recursion
// too. Real files nest ten sequences; this is enough for some hundred.
constexpr std::uintptr_t MostStackBytes = std::uintptr_t{1} << 18;

// Not inlined, so that the frame is that of a caller's callee.
[[gnu::noinline]] std::uintptr_t StackPlace()
{
  return reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
}
} // namespace

BoundedDicomStream::BoundedDicomStream(const std::filesystem::path& file, std::uint64_t mostBytes)
    : DcmInputFileStream(file.c_str()), StackStart(StackPlace()), BytesLeft(mostBytes)
{
}

OFBool BoundedDicomStream::good() const
{
  return !this->IsStopped() && DcmInputFileStream::good();
}

OFCondition BoundedDicomStream::status() const
{
  return this->IsStopped() ? OFCondition(EC_InvalidStream) : DcmInputFileStream::status();
}

OFBool BoundedDicomStream::eos()
{
  return this->IsStopped() || DcmInputFileStream::eos();
}

offile_off_t BoundedDicomStream::read(void* buffer, offile_off_t count)
{
  const std::uintptr_t place = StackPlace();
  const std::uintptr_t depth =
      std::max(place, this->StackStart) - std::min(place, this->StackStart);
  this->TooDeep = this->TooDeep || depth > MostStackBytes;
  if (this->IsStopped())
  {
    return 0;
  }
  const auto most = static_cast<offile_off_t>(std::min<std::uint64_t>(
      this->BytesLeft, static_cast<std::uint64_t>(std::numeric_limits<offile_off_t>::max())));
  const offile_off_t got = DcmInputFileStream::read(buffer, std::min(count, most));
  this->BytesLeft -= static_cast<std::uint64_t>(std::max<offile_off_t>(got, 0));
  this->TooLong = this->BytesLeft == 0;
  return got;
}
} // namespace palpate
