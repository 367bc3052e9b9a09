#pragma once

#include "OrganModel.h"
#include "Status.h"
#include "palpate.h"

#include <cstddef>

namespace palpate
{
/// Evaluates a surface for `count` directions or parameters (three numbers each, of any length)
/// into the arrays that `results` names. Fails, and leaves them alone, for a direction that is zero
/// or not finite, and for radii and gradients of a surface model.
Status EvaluateModel(const OrganModel& surface, const double* directions, std::size_t count,
                     const palpate_evaluation& results);
} // namespace palpate
