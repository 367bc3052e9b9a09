#pragma once

#include "ModelDocument.h"
#include "PalpateSessionModule.h"
#include "SceneAccount.h"
#include "Segmentation.h"
#include "Volume.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <map>
#include <memory>
#include <vector>

namespace palpate
{
/// The files of a scene while it is made. Segmentations and volumes are read when they are first
/// asked for, once, and let go when nobody will ask any more. Throws InputError.
class PALPATESESSION_EXPORT SceneFiles
{
public:
  /// Somebody will ask for a file and then say Done.
  void Expect(const std::filesystem::path& file) { ++this->Expected[file]; }
  void Done(const std::filesystem::path& file);

  std::shared_ptr<const Segmentation> SegmentationOf(const std::filesystem::path& file);
  std::shared_ptr<const Volume> VolumeOf(const std::filesystem::path& file);
  ModelDocument ModelOf(const std::filesystem::path& file);
  vtkSmartPointer<vtkPolyData> SurfaceOf(const std::filesystem::path& file);

  /// What was read, in that order.
  const std::vector<SceneFileAccount>& Accounts() const { return this->Readings; }

private:
  template <typename Read>
  auto Timed(const std::filesystem::path& file, const char* what, const Read& read);

  std::map<std::filesystem::path, int> Expected;
  std::map<std::filesystem::path, std::shared_ptr<const Segmentation>> Segmentations;
  std::map<std::filesystem::path, std::shared_ptr<const Volume>> Volumes;
  std::vector<SceneFileAccount> Readings;
};
} // namespace palpate
