#include "HeaderBytes.h"

#include <cstdint>
#include <memory>
#include <zlib.h>

namespace palpate
{
HeaderBytes::HeaderBytes(const std::filesystem::path& file, std::size_t count) : Bytes(count)
{
  // gzread passes files that are not compressed through as they are.
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> stream(gzopen(file.c_str(), "rb"), gzclose);
  const int got =
      stream ? gzread(stream.get(), this->Bytes.data(), static_cast<unsigned int>(count)) : 0;
  this->Compressed = stream && gzdirect(stream.get()) == 0;
  this->Bytes.resize(static_cast<std::size_t>(std::max(got, 0)));
}

std::string HeaderBytes::TextAt(std::size_t first, std::size_t end) const
{
  std::string text(this->Bytes.begin() + static_cast<std::ptrdiff_t>(first),
                   this->Bytes.begin() + static_cast<std::ptrdiff_t>(end));
  text.resize(text.find_last_not_of('\0') + 1);
  return text;
}

void HeaderBytes::SetBigEndian()
{
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  this->Swap = first == 1;
}
} // namespace palpate
