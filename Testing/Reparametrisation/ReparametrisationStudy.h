#pragma once

#include "GroupReparametrisation.h"
#include "OrganModel.h"
#include "ShapeModes.h"

#include <vector>

namespace palpate
{

/// How far a shape of the first `count` modes can come to a surface: scores by least squares of the
/// distances along the surface's normals to the nearest points, from the projection on.
double DistanceFromModel(const ShapeModes& modes, Eigen::Index count, const OrganModel& surface);

/// `random` shapes of the first `count` modes.
double SpecificityOf(const ShapeModes& modes, Eigen::Index count,
                     const std::vector<OrganModel>& cases, int random);

/// The modes of some shapes. Throws InputError.
ShapeModes ModesOf(const std::vector<OrganModel>& shapes);
} // namespace palpate
