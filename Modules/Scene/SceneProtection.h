#pragma once

#include "ForbiddenStructure.h"
#include "PalpateSceneModule.h"
#include "Progress.h"
#include "RemovedDistances.h"
#include "ScalarField.h"
#include "Segmentation.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace palpate
{
/// What keeps a drill out of one structure: its surface, and what of each drilled field's grid lies
/// in it.
struct SceneProtection
{
  /// Without a name and an alarm distance, which may change meanwhile. Its distances are for one
  /// thread at a time: after it was made, for the study's owner.
  std::shared_ptr<const ForbiddenStructure> Structure;
  std::vector<std::shared_ptr<const RemovedDistances>> Kept; ///< one for each field

  /// On that grid; null where it was made for other fields.
  std::shared_ptr<const RemovedDistances> On(const RemovedDistances& like) const;
  std::size_t Bytes() const;
};

/// Protects a closed surface (world mm) from what drills `fields`. Throws Cancelled.
PALPATESCENE_EXPORT SceneProtection MakeSceneProtection(
    vtkPolyData* surface, const std::vector<std::shared_ptr<const ScalarField>>& fields,
    const ProgressFunction& progress);
} // namespace palpate
