#pragma once

#include "GuidingGradient.h"
#include "ScalarField.h"
#include "Status.h"

#include <memory>

namespace palpate
{
/// Edges of an image as a force: the length of its gradient, whose crests attract the tool
/// (GuidingGradient), from the median of all voxels to the 95th percentile of those above it.
struct EdgeSettings
{
  double LargestForce = 0.3; ///< N, at the steepest place
  double Fade = 5.0;         ///< mm inside the image's border where the force fades out
};

/// Of the first channel of a B-spline with samples everywhere (FieldBuilder::KeepAll), which should
/// be smoothed by a voxel or more. Fails where no edges stand out from the rest, as in noise.
/// Looks at every voxel twice; allocates.
Status MakeEdgeForce(const std::shared_ptr<const ScalarField>& image, const EdgeSettings& settings,
                     std::shared_ptr<const GuidingGradient>& made);
} // namespace palpate
