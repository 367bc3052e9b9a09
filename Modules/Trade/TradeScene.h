#pragma once

#include "PalpateTradeModule.h"
#include "Progress.h"
#include "SceneSettings.h"
#include "TradeSource.h"

#include <string>
#include <vector>

namespace palpate
{
/// A structure of a scene, ready to be measured.
struct TradeStructure
{
  TradeSource Source;
  SceneStructure Asked; ///< its entry in the scene
  std::string Content;  ///< a digest of its file, and which part of that it is
};

/// Reads what a scene lets be touched; entries that are only seen are left out. Files are read
/// once. Throws InputError, and Cancelled.
PALPATETRADE_EXPORT std::vector<TradeStructure> ReadTradeScene(const SceneSettings& scene,
                                                               const ProgressFunction& progress);
} // namespace palpate
