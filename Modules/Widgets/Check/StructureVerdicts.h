#pragma once

#include "MaskChecks.h"
#include "StudyController.h"

#include <QObject>
#include <QString>

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>

namespace palpate
{
/// Whether the mask of a structure is believable, as `palpate check` says.
struct StructureVerdict
{
  OrganJudgement::Verdict Is = OrganJudgement::Verdict::Plausible;
  QString Sentence;                     ///< "has a hole of 1.2 ml", without the structure's name
  Vector3 PlaceWorld = Vector3::Zero(); ///< of what was found, mm
  std::string Name;                     ///< of the structure, by which sides and groups go
};

/// What a check of the open segmentation found. It is forgotten when the mask changes or a
/// segmentation is added.
class StructureVerdicts : public QObject
{
  Q_OBJECT

public:
  /// What is checked: the open segmentation with the names of the study.
  struct Masks
  {
    std::shared_ptr<const Segmentation> Labels; ///< null if none is open
    std::shared_ptr<const Segmentation> Named;  ///< the same with other names
    std::map<std::size_t, int> Ids;             ///< of structures, by segments of both
    std::set<std::filesystem::path> Files;      ///< of all structures that are labels
  };

  /// Keeps the address.
  StructureVerdicts(StudyController& study, QObject* parent);

  Masks Now() const;
  /// Returns false, and keeps nothing, if these are not the masks that are there now.
  bool Take(const Masks& masks, const MaskChecks& found);
  /// Null if it was not checked, or under another name.
  const StructureVerdict* Of(const SceneStructure& structure) const;
  bool IsEmpty() const { return this->Found.empty(); }

Q_SIGNALS:
  void Changed();

private:
  bool AreThere(const std::shared_ptr<const Segmentation>& labels,
                const std::set<std::filesystem::path>& files) const;
  void Forget();

  StudyController& Study;
  std::map<int, StructureVerdict> Found;    ///< by id
  std::weak_ptr<const Segmentation> Labels; ///< that were checked
  std::set<std::filesystem::path> Files;    ///< of the study then
};
} // namespace palpate
