#pragma once

#include "StiffnessImage.h"

#include <memory>
#include <vector>

namespace palpate
{
/// How a surface feels that is not known for sure: at its points (mm, world), with standard
/// deviations (mm) along the normal, as if a spring of UncertaintyForce / deviation were in series
/// with the structure's own stiffness `own` (N/mm). So a push of UncertaintyForce goes one standard
/// deviation deeper than into a sure surface, and nowhere is it stiffer than that one. As an image
/// of about 24 voxels along the surface's largest extent, 1 mm at least, of which each has the mean
/// of its points. Fails for no points, numbers that are not finite or negative, and places more
/// than 1,000 mm apart. Takes some milliseconds; allocates.
constexpr double UncertaintyForce = 1.0; // N
Status MakeUncertainStiffness(const std::vector<Vector3>& pointsWorld,
                              const std::vector<double>& deviations, double own,
                              std::shared_ptr<const StiffnessImage>& made);
} // namespace palpate
