#include "SceneFiles.h"

#include "ModelFile.h"
#include "StageClock.h"
#include "SurfaceFile.h"

#include <system_error>

namespace palpate
{
template <typename Read>
auto SceneFiles::Timed(const std::filesystem::path& file, const char* what, const Read& read)
{
  std::vector<std::pair<std::string, double>> stages;
  StageClock clock(stages);
  auto product = read(file);
  clock.EndStage(what);
  SceneFileAccount account{file, {what, 0, stages.front().second, {}}};
  std::error_code isNoFile;
  const std::uintmax_t bytes = std::filesystem::file_size(file, isNoFile);
  account.Reading.Bytes = isNoFile ? 0 : bytes;
  this->Readings.push_back(std::move(account));
  return product;
}

void SceneFiles::Done(const std::filesystem::path& file)
{
  if (--this->Expected[file] <= 0)
  {
    this->Segmentations.erase(file);
    this->Volumes.erase(file);
  }
}

std::shared_ptr<const Segmentation> SceneFiles::SegmentationOf(const std::filesystem::path& file)
{
  std::shared_ptr<const Segmentation>& kept = this->Segmentations[file];
  if (kept == nullptr)
  {
    kept = this->Timed(file, "a segmentation",
                       [](const std::filesystem::path& path)
                       { return std::make_shared<const Segmentation>(ReadSegmentation(path)); });
  }
  return kept;
}

std::shared_ptr<const Volume> SceneFiles::VolumeOf(const std::filesystem::path& file)
{
  std::shared_ptr<const Volume>& kept = this->Volumes[file];
  if (kept == nullptr)
  {
    kept = this->Timed(file, "an image",
                       [](const std::filesystem::path& path)
                       { return std::make_shared<const Volume>(ReadVolume(path)); });
  }
  return kept;
}

ModelDocument SceneFiles::ModelOf(const std::filesystem::path& file)
{
  return this->Timed(file, "a model", ReadModel);
}

vtkSmartPointer<vtkPolyData> SceneFiles::SurfaceOf(const std::filesystem::path& file)
{
  return this->Timed(file, "a surface", ReadSurface);
}
} // namespace palpate
