#pragma once

#include "SceneRepresentation.h"

namespace palpate
{
/// Spherical harmonics: fitted to a label, or read from a model file.
SceneRepresentation ModelRepresentation();

/// The triangles of a label's surface, or of a surface from a file.
SceneRepresentation FacetRepresentation();

/// The sub-voxel field of a label or of an iso-value; the only representation that can be drilled.
SceneRepresentation FieldRepresentation();

/// Plans the contact with the field.
void PlanFieldContact(StructurePlan& plan);

/// A model by harmonics, a surface by facets, voxels by the sub-voxel field.
SceneRepresentation AutomaticRepresentation();

/// The same, but a label by harmonics where they fit, otherwise by the sub-voxel field.
SceneRepresentation ModelOrFieldRepresentation();
} // namespace palpate
