#pragma once

#include "Calibre.h"
#include "ComparedBody.h"
#include "RelatedBody.h"

#include <memory>
#include <mutex>

/// A body of the C interface's comparisons and relations.
struct palpate_compared
{
  palpate::ComparedBody Body;
  palpate::SpreadOf Spread = palpate::SpreadOf::VoxelCenters;
  ///@{ Made when it is first asked for.
  mutable std::mutex Making;
  mutable std::shared_ptr<const palpate::RelatedBody> Related;
  mutable std::shared_ptr<const palpate::Calibre> Tube;
  ///@}
};
