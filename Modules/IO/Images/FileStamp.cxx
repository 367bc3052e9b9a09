#include "FileStamp.h"

#include "LabelNamesFile.h"

#include <cstddef>
#include <functional>
#include <system_error>

namespace palpate
{
namespace
{
std::string OwnStampOf(const std::filesystem::path& file)
{
  std::error_code error;
  const auto time = std::filesystem::last_write_time(file, error);
  if (error)
  {
    return "absent";
  }
  const auto size = std::filesystem::file_size(file, error); // a folder has none
  return std::to_string(time.time_since_epoch().count()) + "|" + std::to_string(error ? 0 : size);
}

// The files come in any order.
std::string StampOfFolder(const std::filesystem::path& folder)
{
  std::size_t all = 0;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
  {
    all += std::hash<std::string>()(entry->path().filename().string() + OwnStampOf(entry->path()));
  }
  return OwnStampOf(folder) + "|" + std::to_string(all);
}
} // namespace

// Companion files: names and colours of a label map's labels (see ApplyLabelNames), and data
// detached from their header. A missing one costs only a directory look-up.
std::string StampOf(const std::filesystem::path& file)
{
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
  {
    return StampOfFolder(file);
  }
  std::string stamps = OwnStampOf(file);
  std::filesystem::path stem = file;
  const bool isCompressed = stem.extension() == ".gz";
  stem = isCompressed ? stem.replace_extension() : stem;
  stamps += "|" + OwnStampOf(std::filesystem::path(stem).concat(".lut"));
  for (const std::filesystem::path& table : LabelTablesOf(file))
  {
    stamps += "|" + OwnStampOf(table);
  }
  for (const char* ending : {".raw", ".zraw", ".raw.gz", ".img"})
  {
    stamps += "|" + OwnStampOf(std::filesystem::path(stem).replace_extension(ending));
  }
  return stamps;
}
} // namespace palpate
