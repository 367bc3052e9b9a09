#pragma once

#include "StudyTouch.h"

#include <QString>

namespace palpate
{
/// What a person has to notice while touching, wherever he looks: the drill where it must not be,
/// or that there is no force.
struct TouchNotice
{
  enum class Kind
  {
    None,
    NoForce,
    Alarm
  };

  Kind Is = Kind::None;
  QString Text;

  static TouchNotice Of(const StudyTouchReading& reading);
  /// "Drill touches Pallidum_L (0.3 mm inside)", of the nearest structure whose alarm is on; empty
  /// if none is.
  static QString AlarmText(const StudyDrillReading& reading);
};
} // namespace palpate
