#pragma once

#include "PalpateIOModule.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// The first bytes of a file, plain or gzip-compressed, read as numbers at byte offsets.
class PALPATEIO_EXPORT HeaderBytes
{
public:
  /// Reads `count` bytes. If there are fewer, or they do not decompress, Size() is smaller.
  HeaderBytes(const std::filesystem::path& file, std::size_t count);

  std::size_t Size() const { return this->Bytes.size(); }
  bool IsCompressed() const { return this->Compressed; }
  /// Whether numbers are in the opposite of this machine's byte order.
  bool IsSwapped() const { return this->Swap; }
  void SetSwapped(bool isSwapped) { this->Swap = isSwapped; }
  void SetBigEndian();
  /// The bytes from `first` up to `end`, without zeros at their end; they must lie within Size().
  std::string TextAt(std::size_t first, std::size_t end) const;

  /// The number at an offset; it must lie within Size().
  template <typename T>
  T At(std::size_t offset) const
  {
    std::array<unsigned char, sizeof(T)> raw;
    std::copy_n(this->Bytes.begin() + static_cast<std::ptrdiff_t>(offset), sizeof(T), raw.begin());
    if (this->Swap)
    {
      std::reverse(raw.begin(), raw.end());
    }
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    return value;
  }

private:
  std::vector<unsigned char> Bytes;
  bool Compressed = false;
  bool Swap = false;
};
} // namespace palpate
