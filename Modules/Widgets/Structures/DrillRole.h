#pragma once

#include "StudyController.h"

#include <QString>
#include <QStringList>

#include <map>

namespace palpate
{
/// What a drill does to a structure. Wear and feel are plausible, not measured.
struct DrillRole
{
  const char* Name;
  DrillLaw Law;
  bool IsForbidden;

  static QStringList Names();
  /// The number of a structure's role among Names.
  static int Of(const SceneStructure& structure);
  /// Gives it that role.
  static void Set(SceneStructure& structure, int role);
};

/// By the ids of structures: what was removed, and how near the drill is to what it must not touch.
std::map<int, QString> DrillTexts(StudyController& study);
} // namespace palpate
