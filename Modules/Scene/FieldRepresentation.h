#pragma once

#include "SceneRepresentation.h"

namespace palpate
{
/// The sub-voxel field of a label or of an iso-value; the only representation that can be drilled.
PALPATESCENE_EXPORT SceneRepresentation FieldRepresentation();

/// Plans the contact with the field.
void PlanFieldContact(StructurePlan& plan);
} // namespace palpate
