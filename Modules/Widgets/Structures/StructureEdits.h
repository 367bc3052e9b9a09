#pragma once

#include "StudyController.h"

#include <QColor>

#include <functional>
#include <vector>

namespace palpate
{
/// Changes of structures, by their ids. Each call is one undo step of the study, or none if nothing
/// differs.
class StructureEdits
{
public:
  /// Keeps the address.
  explicit StructureEdits(StudyController& study) : Study(study) {}

  void SetVisible(const std::vector<int>& ids, bool isVisible);
  /// Hides all others.
  void ShowOnly(const std::vector<int>& ids);
  void SetTouchable(const std::vector<int>& ids, bool isTouchable);
  /// See DrillRole.
  void SetDrillRole(const std::vector<int>& ids, int role);
  void SetColor(const std::vector<int>& ids, const QColor& color);
  /// Calls with the same `gesture` are one step; see StudyHistory.
  void SetOpacity(const std::vector<int>& ids, int percent, const QString& gesture = {});
  void Remove(const std::vector<int>& ids);

private:
  void Change(const std::vector<int>& ids, const QString& message,
              const std::function<void(SceneStructure&)>& change, const QString& gesture = {});

  StudyController& Study;
};
} // namespace palpate
