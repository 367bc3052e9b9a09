#pragma once

#include "DeviceCapabilities.h"
#include "StudyState.h"

#include <QString>

#include <optional>
#include <string>

namespace palpate
{
/// Habits of the user with one device, which belong to the program rather than to a study. Kept by
/// QSettings under the device's identity.
struct DeviceSettings
{
  std::optional<double> Scale; ///< mm of the scene per mm of the device; 0: all is in reach
  std::optional<bool> AxesFollowCamera;
  std::optional<int> ClutchButton; ///< from 0; -1: none
  bool IsKnown = false;            ///< its first use was offered

  /// Those kept for a device (as DeviceRegistry::Make takes it); what is missing or makes no sense
  /// is not set.
  static DeviceSettings Kept(const std::string& device);
  void Keep(const std::string& device) const;

  /// A study with another device, and with what is kept for it.
  static StudyState WithDevice(const StudyState& state, const std::string& device);

  /// A device's kind and which one it is, without the files that it is opened with.
  static QString IdentityOf(const std::string& device);
  /// The button that is the clutch unless the user chose another: the third, else the second, since
  /// the first is the drill's pedal; -1 without. For a device whose buttons are not known the
  /// third.
  static int UsualClutch(const DeviceCapabilities& device);
};
} // namespace palpate
