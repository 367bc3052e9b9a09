#pragma once

#include "SceneRepresentation.h"

namespace palpate
{
/// The triangles of a label's surface, or of a surface from a file.
PALPATESCENE_EXPORT SceneRepresentation FacetRepresentation();

/// Plans the contact with the surface.
void PlanFacetContact(StructurePlan& plan);
} // namespace palpate
