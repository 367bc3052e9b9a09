#pragma once

#include "PalpateReportModule.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace palpate
{
/// FNV-1a over pieces: the same on every machine and in every build, which std::hash does not
/// promise. Not against forgery.
class PALPATEREPORT_EXPORT ContentDigest
{
public:
  /// Another piece; what lies between two pieces counts too.
  void Add(std::string_view piece);
  /// All bytes of a file, or of all files of a folder with their names. Throws InputError where
  /// they cannot be read.
  void AddContent(const std::filesystem::path& path);
  /// 16 hexadecimal digits.
  std::string Text() const;

private:
  void AddBytes(std::string_view bytes);

  std::uint64_t Hash = 0xcbf29ce484222325U;
};
} // namespace palpate
