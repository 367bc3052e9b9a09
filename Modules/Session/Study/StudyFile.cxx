#include "StudyFile.h"

#include "Refusal.h"
#include "StudyJson.h"
#include "WholeFile.h"

#include <array>
#include <system_error>

namespace palpate
{
namespace
{
constexpr std::uintmax_t LargestFile = 16 << 20;

bool IsThere(const std::filesystem::path& path)
{
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}
} // namespace

void WriteStudy(const std::filesystem::path& path, const StudyState& state)
{
  const std::filesystem::path folder = StudyPath(path).parent_path();
  const std::string text = StudyText(state, folder, path);
  if (StudyFromText(text, folder, path) != state)
  {
    Refuse(path, "was not written, since it would not open again as it is",
           "give files by their absolute paths");
  }
  WriteWholeFile(path, text);
}

StudyState ReadStudy(const std::filesystem::path& path)
{
  return StudyFromText(ReadWholeFile(path, LargestFile), StudyPath(path).parent_path(), path);
}

std::vector<StudyMissingFile> MissingFiles(const StudyState& state)
{
  std::vector<StudyMissingFile> missing;
  for (const StudyMissingFile& file : {StudyMissingFile{"volume", state.VolumeFile},
                                       StudyMissingFile{"segmentation", state.SegmentationFile},
                                       StudyMissingFile{"tool", state.Tool.File}})
  {
    if (!file.Path.empty() && !IsThere(file.Path))
    {
      missing.push_back(file);
    }
  }
  return missing;
}

StudyState Relocate(const StudyState& state, const std::filesystem::path& missing,
                    const std::filesystem::path& moved)
{
  const std::filesystem::path newPlace = StudyPath(moved);
  StudyState relocated = state;
  for (std::filesystem::path* file :
       {&relocated.VolumeFile, &relocated.SegmentationFile, &relocated.Tool.File})
  {
    if (file->empty())
    {
      continue;
    }
    const std::filesystem::path along =
        (newPlace.parent_path() / file->lexically_relative(missing.parent_path()))
            .lexically_normal();
    if (*file == missing)
    {
      *file = newPlace;
    }
    else if (!IsThere(*file) && IsThere(along))
    {
      *file = along;
    }
  }
  return relocated;
}
} // namespace palpate
