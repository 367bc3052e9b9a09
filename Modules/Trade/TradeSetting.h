#pragma once

#include "PalpateTradeModule.h"
#include "SceneRepresentation.h"

#include <string>
#include <vector>

namespace palpate
{
/// "harmonics of degree 12, nearest point".
PALPATETRADE_EXPORT std::string Describe(const ContactSetting& setting);

/// Short text that does not change from version to version: "harmonics/12/nearest".
PALPATETRADE_EXPORT std::string KeyOf(const ContactSetting& setting);

/// The first structure of the scene as it is, by another representation.
PALPATETRADE_EXPORT ContactSetting SettingOf(const SceneSettings& scene,
                                             const std::string& representation);

/// The scene with the setting in its first structure and its tool.
PALPATETRADE_EXPORT SceneSettings WithSetting(SceneSettings scene, const ContactSetting& setting);

/// The settings to compare for the scene's first structure: for each representation that takes its
/// source the settings of the scene, then variations of one of them at a time. `highestDegree`:
/// that its voxels support.
PALPATETRADE_EXPORT std::vector<ContactSetting> CandidatesFor(const SceneSettings& scene,
                                                              int highestDegree);
} // namespace palpate
