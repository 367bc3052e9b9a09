#pragma once

#include "ScalarField.h"
#include "Status.h"

#include <memory>

namespace palpate
{
/// A field of half the resolution for one material of a whole field, to stand in where that one's
/// bricks are not at hand. Its one material, number 0, holds the fine one at every point, and
/// reaches beyond it by less than `CoarseReach` voxels of the fine grid along any axis: what cannot
/// pass the coarse one has not passed the fine one. Trilinear; each node has what holds most of the
/// fine nodes that cells round it need.
///
/// Refuses a material that then fills everything, and too little memory.
Status MakeCoarseField(const ScalarField& fine, int material,
                       std::shared_ptr<const ScalarField>& coarse);

/// See MakeCoarseField.
int CoarseReach(FieldInterpolation fine) noexcept;
} // namespace palpate
