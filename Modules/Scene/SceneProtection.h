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
/// Protection of one structure from the drill: its surface, and the protected region on the grid of
/// each drilled field.
struct SceneProtection
{
  /// Without name and alarm distance, which may change without a new protection. Distances may be
  /// queried by one thread at a time: once it is made, the owner's thread.
  std::shared_ptr<const ForbiddenStructure> Structure;
  std::vector<std::shared_ptr<const RemovedDistances>> Kept; ///< one for each field

  /// The region on that grid, or null if it was made for other fields.
  std::shared_ptr<const RemovedDistances> On(const RemovedDistances& like) const;
  std::size_t Bytes() const;
};

/// Protects a closed surface (world mm) from drilling of `fields`. Throws Cancelled.
PALPATESCENE_EXPORT SceneProtection MakeSceneProtection(
    vtkPolyData* surface, const std::vector<std::shared_ptr<const ScalarField>>& fields,
    const ProgressFunction& progress);
} // namespace palpate
