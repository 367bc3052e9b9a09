#pragma once

#include "FitResult.h"
#include "PalpateSceneModule.h"
#include "SceneRepresentation.h"
#include "TouchContact.h"

#include <string>

namespace palpate
{
/// Structures that yield: star-shaped models fitted to labels or read from files, softened by the
/// scene's numbers unless the file says how they yield.
SceneRepresentation ElasticRepresentation();

/// Adds the model with its elasticity to a plan of a structure with that representation; returns
/// the key of this FitResult.
std::string AddElasticity(StructurePlan& plan);

/// The contact of a model with elasticity.
TouchContact ElasticContactOf(const FitResult& fit);
} // namespace palpate
