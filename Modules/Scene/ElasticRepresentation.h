#pragma once

#include "FitResult.h"
#include "PalpateSceneModule.h"
#include "SceneRepresentation.h"
#include "TouchContact.h"

namespace palpate
{
/// Structures that yield: star-shaped models fitted to labels or read from files, softened by the
/// scene's numbers unless the file says how they yield.
SceneRepresentation ElasticRepresentation();

/// The contact of a model with elasticity.
TouchContact ElasticContactOf(const FitResult& fit);
} // namespace palpate
