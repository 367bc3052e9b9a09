#include "StudyStamps.h"

#include <filesystem>
#include <system_error>

namespace palpate
{
namespace
{
std::string StampOf(const std::filesystem::path& file)
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

// With the files that a reader takes into account too: names and colours of a label map's labels
// (see ApplyLabelNames), and data that are detached from their header. Other files are absent,
// which costs a glance at the folder's index each.
std::string StampWithCompanions(const std::filesystem::path& file)
{
  std::string stamps = StampOf(file);
  std::filesystem::path stem = file;
  const bool isCompressed = stem.extension() == ".gz";
  stem = isCompressed ? stem.replace_extension() : stem;
  for (const char* ending : {".txt", ".lut"})
  {
    stamps += "|" + StampOf(std::filesystem::path(stem).concat(ending));
  }
  for (const char* ending : {".raw", ".zraw", ".raw.gz", ".img"})
  {
    stamps += "|" + StampOf(std::filesystem::path(stem).replace_extension(ending));
  }
  return stamps;
}

} // namespace

StudyStamps StampFiles(const StudyState& state)
{
  const bool isOfFile = state.Tool.Kind == TouchToolSettings::Shape::Surface;
  return {StampWithCompanions(state.VolumeFile), StampWithCompanions(state.SegmentationFile),
          isOfFile ? StampOf(state.Tool.File) : std::string()};
}
} // namespace palpate
