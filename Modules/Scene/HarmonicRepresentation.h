#pragma once

#include "SceneRepresentation.h"

namespace palpate
{
/// Spherical harmonics: fitted to a label, or read from a model file.
PALPATESCENE_EXPORT SceneRepresentation HarmonicRepresentation();

/// Plans the contact with the fitted or read model.
void PlanHarmonicContact(StructurePlan& plan);
} // namespace palpate
