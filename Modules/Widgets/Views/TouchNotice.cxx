#include "TouchNotice.h"

#include "ScreenString.h"

#include <cmath>

namespace palpate
{
QString TouchNotice::AlarmText(const StudyDrillReading& reading)
{
  const DrillApproach* nearest = nullptr;
  for (const DrillApproach& one : reading.Approaches)
  {
    if (one.IsAlarmed && (nearest == nullptr || one.Distance < nearest->Distance))
    {
      nearest = &one;
    }
  }
  if (nearest == nullptr)
  {
    return {};
  }
  const QString distance = QString::number(std::abs(nearest->Distance), 'f', 1);
  const QString name = ScreenString(nearest->Name);
  return nearest->Distance < 0.0 ? QString("Drill touches %2 (%1 mm inside)").arg(distance, name)
                                 : QString("Drill is %1 mm from %2").arg(distance, name);
}

TouchNotice TouchNotice::Of(const StudyTouchReading& reading)
{
  const QString alarm = AlarmText(reading.Drill);
  if (!alarm.isEmpty())
  {
    return {Kind::Alarm, alarm};
  }
  if (reading.Newest.Safety.Fault != SafetyFault::None)
  {
    return {Kind::NoForce, "No force. " + ScreenString(reading.Safety)};
  }
  return {};
}
} // namespace palpate
