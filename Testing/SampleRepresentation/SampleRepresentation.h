#pragma once

#include "SceneRepresentation.h"

namespace palpate
{
/// Represents a label by a sphere with the volume of its mask and the centre of its surface,
/// enlarged by a margin: fast but coarse.
SceneRepresentation SampleRepresentation();
} // namespace palpate
