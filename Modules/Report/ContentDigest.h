#pragma once

#include "PalpateReportModule.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace palpate
{
/// FNV-1a over pieces: the same on every machine and in every build, which std::hash does not
/// guarantee. Not secure against forgery.
class PALPATEREPORT_EXPORT ContentDigest
{
public:
  /// Adds a piece; the boundaries between pieces count too.
  void Add(std::string_view piece);
  /// 16 hexadecimal digits.
  std::string Text() const;

private:
  void AddBytes(std::string_view bytes);

  std::uint64_t Hash = 0xcbf29ce484222325U;
};
} // namespace palpate
