#pragma once

#include "SceneRepresentation.h"

namespace palpate
{
/// A model by harmonics, a surface by facets, voxels by the sub-voxel field.
PALPATESCENE_EXPORT SceneRepresentation AutomaticRepresentation();

/// The same, but a label by harmonics where they fit, otherwise by the sub-voxel field.
PALPATESCENE_EXPORT SceneRepresentation ModelOrFieldRepresentation();
} // namespace palpate
