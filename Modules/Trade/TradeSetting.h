#pragma once

#include "PalpateTradeModule.h"
#include "SceneRepresentation.h"

#include <string>
#include <vector>

namespace palpate
{
/// "harmonics of degree 12, nearest point".
PALPATETRADE_EXPORT std::string Describe(const ContactSetting& setting);

struct TradeRow;
/// The same of a row's setting; "rigid, harmonics ..." where the structure yields, but not so.
PALPATETRADE_EXPORT std::string Describe(const TradeRow& row);

/// Short identifier, stable across versions: "harmonics/12/nearest".
PALPATETRADE_EXPORT std::string KeyOf(const ContactSetting& setting);

/// The scene's first structure with another representation.
PALPATETRADE_EXPORT ContactSetting SettingOf(const SceneSettings& scene,
                                             const std::string& representation);

/// The scene with the setting applied to its first structure and its tool.
PALPATETRADE_EXPORT SceneSettings WithSetting(SceneSettings scene, const ContactSetting& setting);

/// The settings to compare for the scene's first structure: for each representation that accepts
/// its source the scene's settings, then variations of one setting at a time. If it yields
/// (representation elastic), those of its elasticity, and rigid harmonics. `highestDegree`: see
/// SceneRepresentation::Vary.
PALPATETRADE_EXPORT std::vector<ContactSetting> CandidatesFor(const SceneSettings& scene,
                                                              int highestDegree);
} // namespace palpate
