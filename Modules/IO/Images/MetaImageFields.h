#pragma once

#include "PalpateIOModule.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace palpate
{
/// The text header of a MetaImage, as read by the MetaIO library.
struct MetaImageFields
{
  std::map<std::string, std::string> Entries;
  std::uint64_t Bytes = 0; ///< where the data of a LOCAL file start

  /// Empty if there is no such field.
  std::string Text(const std::string& key) const;
  /// The leading numbers of a field; empty if there is no such field.
  std::vector<double> Numbers(const std::string& key) const;
  /// The field as a Boolean, by the library's rules; `otherwise` if it is absent.
  bool IsTrue(const std::string& key, bool otherwise) const;
};

/// Reads a header. Throws InputError if the library would read it differently: lines without an
/// equals sign or with a colon before it, control characters, duplicate fields or fields with fewer
/// numbers than dimensions (the library continues in the next line); and if the library would
/// overflow: keys and words longer than its buffers, more than 10,000 lines.
PALPATEIO_EXPORT MetaImageFields ReadMetaImageFields(const std::filesystem::path& file);
} // namespace palpate
