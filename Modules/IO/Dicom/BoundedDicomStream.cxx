#include "BoundedDicomStream.h"

#include "dcmtk/dcmdata/dcerror.h"

#include <algorithm>
#include <limits>
#include <string_view>

namespace palpate
{
namespace
{
// A thread has some megabytes of stack, and the parsed tree is also traversed and freed by
// recursion. Real files nest ten sequences; this is enough for some hundred.
constexpr std::uintptr_t MostStackBytes = std::uintptr_t{1} << 18;

constexpr std::size_t TagBytes = 4;

// Whether a tag starts or ends an item, or ends a sequence, in either byte order. Their number is
// not limited.
bool IsItem(std::string_view tag)
{
  using std::string_view_literals::operator""sv;
  return tag == "\xFE\xFF\x00\xE0"sv || tag == "\xFE\xFF\x0D\xE0"sv ||
         tag == "\xFE\xFF\xDD\xE0"sv || tag == "\xFF\xFE\xE0\x00"sv ||
         tag == "\xFF\xFE\xE0\x0D"sv || tag == "\xFF\xFE\xE0\xDD"sv;
}

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
  this->TooDeep = this->TooDeep || this->Depth() > MostStackBytes;
  if (this->IsStopped())
  {
    return 0;
  }
  const auto most = static_cast<offile_off_t>(std::min<std::uint64_t>(
      this->BytesLeft, static_cast<std::uint64_t>(std::numeric_limits<offile_off_t>::max())));
  const offile_off_t got = DcmInputFileStream::read(buffer, std::min(count, most));
  this->BytesLeft -= static_cast<std::uint64_t>(std::max<offile_off_t>(got, 0));
  this->TooLong = this->BytesLeft == 0;
  if (this->IsAtTag && got > 0)
  {
    this->TakeTag(static_cast<const char*>(buffer), static_cast<std::size_t>(got));
  }
  return got;
}

void BoundedDicomStream::mark()
{
  DcmInputFileStream::mark();
  const std::uintptr_t depth = this->Depth();
  // Deeper levels have been read.
  while (!this->Levels.empty() && this->Levels.back().Depth > depth)
  {
    this->Levels.pop_back();
  }
  if (this->Levels.empty() || this->Levels.back().Depth < depth)
  {
    this->Levels.push_back({depth, 0});
  }
  this->Tag.clear();
  this->IsAtTag = true;
}

void BoundedDicomStream::TakeTag(const char* bytes, std::size_t count)
{
  this->Tag.append(bytes, std::min(count, TagBytes - this->Tag.size()));
  if (this->Tag.size() < TagBytes)
  {
    return;
  }
  this->IsAtTag = false;
  if (!IsItem(this->Tag))
  {
    this->TooWide = this->TooWide || ++this->Levels.back().Elements > MostElements;
  }
}

std::uintptr_t BoundedDicomStream::Depth() const
{
  const std::uintptr_t place = StackPlace();
  return std::max(place, this->StackStart) - std::min(place, this->StackStart);
}
} // namespace palpate
