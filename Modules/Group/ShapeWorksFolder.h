#pragma once

#include "OrganModel.h"
#include "PalpateGroupModule.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// A ShapeWorks project of corresponding points: NAME_local.particles (patient's frame) and
/// NAME_world.particles (as the group is aligned), a line "x y z" for each of 1,002 points,
/// NAME.ply (the model as a surface), and cohort.swproj. Coordinates are LPS, as of the images that
/// ITK reads, mm.
class PALPATEGROUP_EXPORT ShapeWorksFolder
{
public:
  /// Makes the folder. Throws InputError.
  explicit ShapeWorksFolder(std::filesystem::path folder);

  /// Throws InputError.
  void Add(const std::string& name, const OrganModel& patient, const OrganModel& aligned);
  /// Writes the project with what was added. Throws InputError.
  void Finish() const;

private:
  std::filesystem::path Folder;
  std::vector<std::string> Names;
};
} // namespace palpate
