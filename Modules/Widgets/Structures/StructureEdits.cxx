#include "StructureEdits.h"

#include "DrillRole.h"
#include "ScreenString.h"

#include <algorithm>
#include <set>

namespace palpate
{
namespace
{
// The title of the only structure, or the number of structures.
QString NameOfAll(const StudyState& state, const std::vector<int>& ids)
{
  const SceneStructure* only = ids.size() == 1 ? FindStructure(state, ids.front()) : nullptr;
  return only != nullptr ? ScreenString(TitleOf(*only)) : QString("%1 structures").arg(ids.size());
}
} // namespace

void StructureEdits::Change(const std::vector<int>& ids, const QString& message,
                            const std::function<void(SceneStructure&)>& change,
                            const QString& gesture)
{
  const std::set<int> chosen(ids.begin(), ids.end());
  StudyState next = this->Study.State();
  for (SceneStructure& structure : next.Structures)
  {
    if (chosen.count(structure.Id) > 0)
    {
      change(structure);
    }
  }
  this->Study.Change(message.arg(NameOfAll(next, ids)), next, gesture);
}

void StructureEdits::SetVisible(const std::vector<int>& ids, bool isVisible)
{
  this->Change(ids, isVisible ? "Show %1" : "Hide %1",
               [=](SceneStructure& structure) { structure.IsVisible = isVisible; });
}

void StructureEdits::ShowOnly(const std::vector<int>& ids)
{
  const std::set<int> chosen(ids.begin(), ids.end());
  StudyState next = this->Study.State();
  for (SceneStructure& structure : next.Structures)
  {
    structure.IsVisible = chosen.count(structure.Id) > 0;
  }
  this->Study.Change("Show only " + NameOfAll(next, ids), next);
}

void StructureEdits::SetTouchable(const std::vector<int>& ids, bool isTouchable)
{
  this->Change(ids, isTouchable ? "Make touchable %1" : "Make untouchable %1",
               [=](SceneStructure& structure) { structure.IsTouchable = isTouchable; });
}

void StructureEdits::SetDrillRole(const std::vector<int>& ids, int role)
{
  this->Change(ids, "Change %1: drill role " + DrillRole::Names().value(role),
               [=](SceneStructure& structure) { DrillRole::Set(structure, role); });
}

void StructureEdits::SetColor(const std::vector<int>& ids, const QColor& color)
{
  this->Change(ids, "Change %1: colour",
               [&](SceneStructure& structure) {
                 structure.Color = {{color.redF(), color.greenF(), color.blueF()}};
               });
}

void StructureEdits::SetOpacity(const std::vector<int>& ids, int percent, const QString& gesture)
{
  const int share = std::clamp(percent, 0, 100);
  this->Change(
      ids, QString("Change %1: opacity ") + QString::number(share) + " %",
      [=](SceneStructure& structure) { structure.Opacity = share / 100.0; }, gesture);
}

void StructureEdits::Remove(const std::vector<int>& ids)
{
  const std::set<int> chosen(ids.begin(), ids.end());
  StudyState next = this->Study.State();
  const QString message = "Remove " + NameOfAll(next, ids);
  next.Structures.erase(std::remove_if(next.Structures.begin(), next.Structures.end(),
                                       [&chosen](const SceneStructure& one)
                                       { return chosen.count(one.Id) > 0; }),
                        next.Structures.end());
  DropLooseGuides(next);
  this->Study.Change(message, next);
}
} // namespace palpate
