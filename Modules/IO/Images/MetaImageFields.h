#pragma once

#include "PalpateIOModule.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace palpate
{
/// The text header of a MetaImage, as the MetaIO library will read it.
struct MetaImageFields
{
  std::map<std::string, std::string> Entries;
  std::uint64_t Bytes = 0; ///< where the data of a LOCAL file start

  /// Empty where there is no such field.
  std::string Text(const std::string& key) const;
  /// The numbers with which a field starts; none where there is no such field.
  std::vector<double> Numbers(const std::string& key) const;
  /// As the library takes words for truth.
  bool IsTrue(const std::string& key, bool otherwise) const;
};

/// Reads a header. Throws InputError where the library would read other fields of it: lines without
/// an equals sign or with a colon before it, control characters, fields that are there twice or
/// have fewer numbers than dimensions (it goes on in the next line); and where it would overflow:
/// keys and words that are longer than its buffers, ten thousands of lines.
PALPATEIO_EXPORT MetaImageFields ReadMetaImageFields(const std::filesystem::path& file);
} // namespace palpate
