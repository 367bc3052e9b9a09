#include "StudyFile.h"

#include "ImageContent.h"
#include "MaskFolder.h"
#include "ModelFile.h"
#include "Refusal.h"
#include "SceneFile.h"
#include "StudyJson.h"
#include "StudyMarkups.h"
#include "StudyPaths.h"
#include "SurfaceFile.h"
#include "TouchTicksFile.h"
#include "WholeFile.h"

#include <set>
#include <string>
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

void WriteStudy(const std::filesystem::path& path, const StudyState& state,
                const std::filesystem::path& drilled)
{
  const std::filesystem::path folder = StudyPath(path).parent_path();
  const std::string text = StudyText(state, folder, path, drilled);
  if (StudyFromText(text, folder, path) != state)
  {
    Refuse(path, "was not written, since it would not open again unchanged",
           "use absolute paths for its files");
  }
  WriteWholeFile(path, text);
}

StudyState ReadStudy(const std::filesystem::path& path, std::filesystem::path* drilled)
{
  return StudyFromText(ReadWholeFile(path, LargestFile), StudyPath(path).parent_path(), path,
                       drilled);
}

std::vector<StudyMissingFile> MissingFiles(const StudyState& state)
{
  std::vector<StudyMissingFile> missing;
  std::set<std::filesystem::path> known;
  ForEachPath(state,
              [&](const char* role, const std::filesystem::path& path)
              {
                if (!path.empty() && known.insert(path).second && !IsThere(path))
                {
                  missing.push_back({role, path});
                }
              });
  return missing;
}

StudyState Relocate(const StudyState& state, const std::filesystem::path& missing,
                    const std::filesystem::path& moved)
{
  const std::filesystem::path newPlace = StudyPath(moved);
  StudyState relocated = state;
  ForEachPath(relocated,
              [&](const char*, std::filesystem::path& file)
              {
                const std::filesystem::path along =
                    (newPlace.parent_path() / file.lexically_relative(missing.parent_path()))
                        .lexically_normal();
                if (!file.empty() && file == missing)
                {
                  file = newPlace;
                }
                else if (!file.empty() && !IsThere(file) && IsThere(along))
                {
                  file = along;
                }
              });
  return relocated;
}

std::optional<StudyFileRole> RoleByName(const std::filesystem::path& file)
{
  const std::string name = file.filename().string();
  const std::string ending = StudyEnding;
  if (name.size() > ending.size() &&
      name.compare(name.size() - ending.size(), ending.size(), ending) == 0)
  {
    return StudyFileRole::Session;
  }
  if (IsMarkupsFile(file))
  {
    return StudyFileRole::Markups;
  }
  if (IsSceneFile(file))
  {
    return StudyFileRole::Scene;
  }
  if (IsModelFile(file))
  {
    return StudyFileRole::Model;
  }
  if (IsSurfaceFile(file))
  {
    return StudyFileRole::Surface;
  }
  return std::nullopt;
}

StudyFileRole RoleOf(const std::filesystem::path& file)
{
  if (const std::optional<StudyFileRole> named = RoleByName(file))
  {
    return *named;
  }
  std::error_code failure;
  if (IsMaskFolder(file))
  {
    return StudyFileRole::Segmentation;
  }
  if (std::filesystem::is_directory(file, failure))
  {
    return StudyFileRole::Volume; // of DICOM slices; the user chooses the series
  }
  if (IsTouchRecording(file))
  {
    return StudyFileRole::Recording;
  }
  return ReadImageContent(file).Labels ? StudyFileRole::Segmentation : StudyFileRole::Volume;
}
} // namespace palpate
