#pragma once

#include "FitResult.h"
#include "PalpateSceneModule.h"
#include "SceneRepresentation.h"
#include "TouchContact.h"

namespace palpate
{
/// Structures that yield: radial models fitted to labels or read from files, softened by the
/// scene's numbers unless the file says how they yield.
SceneRepresentation ElasticRepresentation();

/// Adds the model with its elasticity to a plan of a structure with that representation: a
/// FitResult whose notes are those of the softening.
void AddElasticity(StructurePlan& plan);

/// The contact of a model with elasticity: its maps up to a degree, or all if theirs is lower.
TouchContact ElasticContactOf(const FitResult& fit, int mapDegree = ComplianceMaps::MostDegree);

/// The most accurate setting of a structure with that representation that is affordable: a quarter
/// more elements, a compliance of a third and maps of a fifth more degrees than the scene's. Of a
/// file that says how it yields, its maps of `highestDegree` as they are.
PALPATESCENE_EXPORT ContactSetting FinestElastic(const ContactSetting& standard, int highestDegree);
} // namespace palpate
