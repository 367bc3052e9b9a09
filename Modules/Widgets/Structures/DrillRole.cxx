#include "DrillRole.h"

#include <array>

namespace palpate
{
namespace
{
const std::array<DrillRole, 4> Roles{{{"Not drilled", {0.0, 0.0, 0.0}, false},
                                      {"Cortical bone", {0.05, 0.002, 0.25}, false},
                                      {"Soft tissue", {0.5, 0.001, 0.05}, false},
                                      {"Forbidden", {0.0, 0.0, 0.0}, true}}};

// Distance of the drill to a structure, or the status of its protection.
QString TextOf(const StudyForbidden& forbidden, const StudyDrillReading& reading, bool isTouching)
{
  for (const DrillApproach& one : reading.Approaches)
  {
    if (forbidden.IsReady() && one.Name == forbidden.Name)
    {
      const QString least = QString::number(one.Least, 'f', 1);
      return isTouching ? QString("%1 mm away, least %2 mm").arg(one.Distance, 0, 'f', 1).arg(least)
                        : QString("Least %1 mm in the last touch").arg(least);
    }
  }
  return QString::fromStdString(ProtectionText(forbidden));
}
} // namespace

QStringList DrillRole::Names()
{
  QStringList names;
  for (const DrillRole& role : Roles)
  {
    names += role.Name;
  }
  return names;
}

int DrillRole::Of(const SceneStructure& structure)
{
  if (structure.IsForbidden)
  {
    return 3;
  }
  const double wear = structure.Drill.Wear;
  return wear > 0.0 ? (wear > Roles[1].Law.Wear ? 2 : 1) : 0;
}

void DrillRole::Set(SceneStructure& structure, int role)
{
  const DrillRole& next = Roles.at(static_cast<std::size_t>(role));
  structure.Drill = next.Law;
  structure.IsForbidden = next.IsForbidden;
}

std::map<int, QString> DrillTexts(StudyController& study)
{
  const bool isTouching = study.IsTouching();
  const StudyDrillReading& reading =
      isTouching ? study.Reading().Drill : study.Current().Touch().Drill().Last();
  std::map<int, QString> texts;
  for (const StudyDrilled& one : reading.Drilled)
  {
    texts[one.Id] = QString::number(one.RemovedVolume, 'f', 1) + " mm\u00b3 removed";
  }
  for (const StudyForbidden& one : ForbiddenOf(study.State(), study.Current().Pipeline()))
  {
    texts[one.Id] = TextOf(one, reading, isTouching);
  }
  return texts;
}
} // namespace palpate
