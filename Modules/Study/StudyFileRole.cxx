#include "StudyFileRole.h"

#include "ImageContent.h"
#include "ModelFile.h"
#include "SceneFile.h"
#include "StudyFile.h"
#include "SurfaceFile.h"
#include "TouchTicksFile.h"

#include <string>

namespace palpate
{
StudyFileRole RoleOf(const std::filesystem::path& file)
{
  const std::string name = file.filename().string();
  const std::string ending = StudyEnding;
  if (name.size() > ending.size() &&
      name.compare(name.size() - ending.size(), ending.size(), ending) == 0)
  {
    return StudyFileRole::Session;
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
  std::error_code failure;
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
