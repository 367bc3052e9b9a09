#pragma once

#include "SceneRepresentation.h"

namespace palpate
{
/// Spherical harmonics: a label is fitted, a model is read.
PALPATESCENE_EXPORT SceneRepresentation HarmonicRepresentation();
} // namespace palpate
