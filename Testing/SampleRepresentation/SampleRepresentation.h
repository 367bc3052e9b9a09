#pragma once

#include "SceneRepresentation.h"

namespace palpate
{
/// A label as the sphere of its surface's volume and centroid, enlarged by a margin: fast, and
/// rough.
SceneRepresentation SampleRepresentation();
} // namespace palpate
