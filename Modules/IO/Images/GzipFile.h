#pragma once

#include "PalpateIOModule.h"

#include <cstddef>
#include <filesystem>
#include <memory>

struct gzFile_s;

namespace palpate
{
/// A file read sequentially, gzip-compressed or plain (zlib detects which). Missing or damaged data
/// raise an InputError: zlib checks length and CRC at the end of the compressed stream, so
/// ReadToEnd must be called.
class PALPATEIO_EXPORT GzipFile
{
public:
  explicit GzipFile(const std::filesystem::path& file);

  /// Reads the next `bytes` bytes. Throws InputError if there are fewer or they do not decode.
  void Read(void* buffer, std::size_t bytes);
  /// Skips bytes, with Read's errors.
  void Skip(std::size_t bytes);
  /// Decodes the rest of a compressed file. Throws InputError if its end is missing, its checksum
  /// is wrong or more than a megabyte is left. The rest of a plain file is ignored.
  void ReadToEnd();

private:
  int ReadSome(void* buffer, std::size_t bytes);

  std::filesystem::path File;
  std::unique_ptr<gzFile_s, int (*)(gzFile_s*)> Stream;
};
} // namespace palpate
