#pragma once

#include "RegistrationStep.h"
#include "palpate.h"

namespace palpate
{
/// What both registrations have; errors are not predicted for affine maps.
palpate_registration RegistrationOf(const Eigen::Affine3d& map, RegistrationKind kind, double rms,
                                    const PredictedPoseError& predicted);
} // namespace palpate
