#pragma once

#include "PalpateIOModule.h"

#include <cstddef>
#include <filesystem>
#include <memory>

struct gzFile_s;

namespace palpate
{
/// A file read from front to back, gzip-compressed or plain (zlib tells them apart). Whatever is
/// missing or damaged is an InputError: zlib checks length and CRC at the compressed stream's end,
/// which is why ReadToEnd must be called.
class PALPATEIO_EXPORT GzipFile
{
public:
  explicit GzipFile(const std::filesystem::path& file);

  /// The next `bytes` bytes. Throws InputError where there are fewer or they do not decode.
  void Read(void* buffer, std::size_t bytes);
  /// Passes over bytes, as Read does.
  void Skip(std::size_t bytes);
  /// Decodes what is left of a compressed file. Throws InputError where its end is missing, its
  /// checksum does not fit or more than a megabyte is left. What follows in a plain file is left
  /// alone.
  void ReadToEnd();

private:
  int ReadSome(void* buffer, std::size_t bytes);

  std::filesystem::path File;
  std::unique_ptr<gzFile_s, int (*)(gzFile_s*)> Stream;
};
} // namespace palpate
