#include "DeviceSettings.h"

#include "StudyTouch.h"

#include <QSettings>
#include <QStringList>
#include <QUrl>

#include <algorithm>

namespace palpate
{
namespace
{
constexpr const char* Group = "devices";
constexpr const char* ScaleKey = "scale";
constexpr const char* AxesKey = "axes-follow-camera";
constexpr const char* ClutchKey = "clutch-button";
constexpr const char* KnownKey = "known";
constexpr double LargestScale = 100.0;
constexpr int MostButtons = 32;

// A key has no slashes.
QString KeyOf(const std::string& device)
{
  return QString::fromLatin1(QUrl::toPercentEncoding(DeviceSettings::IdentityOf(device)));
}
} // namespace

QString DeviceSettings::IdentityOf(const std::string& device)
{
  const QString text = QString::fromStdString(device);
  const int colon = text.indexOf(':');
  if (colon < 0)
  {
    return text;
  }
  QStringList parts = text.mid(colon + 1).split(',');
  const auto isFile = [](const QString& part)
  { return part.startsWith("firmware=") || part.startsWith("calibration="); };
  parts.erase(std::remove_if(parts.begin(), parts.end(), isFile), parts.end());
  return parts.isEmpty() ? text.left(colon) : text.left(colon + 1) + parts.join(',');
}

DeviceSettings DeviceSettings::Kept(const std::string& device)
{
  QSettings settings;
  settings.beginGroup(Group);
  settings.beginGroup(KeyOf(device));
  DeviceSettings kept;
  bool isNumber = false;
  const double scale = settings.value(ScaleKey).toDouble(&isNumber);
  if (isNumber && scale >= 0.0 && scale <= LargestScale)
  {
    kept.Scale = scale;
  }
  if (settings.contains(AxesKey))
  {
    kept.AxesFollowCamera = settings.value(AxesKey).toBool();
  }
  const int button = settings.value(ClutchKey).toInt(&isNumber);
  if (isNumber && button >= -1 && button < MostButtons && button != StudyTouch::DrillButton)
  {
    kept.ClutchButton = button;
  }
  kept.IsKnown = settings.value(KnownKey, false).toBool();
  return kept;
}

void DeviceSettings::Keep(const std::string& device) const
{
  QSettings settings;
  settings.beginGroup(Group);
  settings.beginGroup(KeyOf(device));
  if (this->Scale)
  {
    settings.setValue(ScaleKey, *this->Scale);
  }
  if (this->AxesFollowCamera)
  {
    settings.setValue(AxesKey, *this->AxesFollowCamera);
  }
  if (this->ClutchButton)
  {
    settings.setValue(ClutchKey, *this->ClutchButton);
  }
  settings.setValue(KnownKey, this->IsKnown);
}

StudyState DeviceSettings::WithDevice(const StudyState& state, const std::string& device)
{
  StudyState next = state;
  next.Device = device;
  const DeviceSettings kept = Kept(device);
  if (kept.Scale)
  {
    next.Placement.Scale = *kept.Scale > 0.0 ? kept.Scale : std::nullopt;
  }
  next.Placement.AxesFollowCamera =
      kept.AxesFollowCamera.value_or(state.Placement.AxesFollowCamera);
  return next;
}

int DeviceSettings::UsualClutch(const DeviceCapabilities& device)
{
  const int last = device.Buttons - 1;
  return last < 0                           ? StudyTouch::ClutchButton
         : last >= StudyTouch::ClutchButton ? StudyTouch::ClutchButton
         : last != StudyTouch::DrillButton  ? last
                                            : -1;
}
} // namespace palpate
