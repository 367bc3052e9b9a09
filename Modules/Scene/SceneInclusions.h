#pragma once

#include "InclusionShare.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace palpate
{
/// How much of each inclusion of a scene lies in a structure that yields. Empty for a model that
/// has its own elasticity, which inclusions do not change.
struct SceneInclusions
{
  /// Ids of the scene's structures, in its order.
  std::vector<std::pair<int, InclusionShare>> Shares;

  /// Whether an inclusion is a part of the structure's tissue.
  bool Has(int id) const
  {
    return std::any_of(this->Shares.begin(), this->Shares.end(),
                       [id](const auto& share)
                       { return share.first == id && share.second.IsInside(); });
  }
};
} // namespace palpate
