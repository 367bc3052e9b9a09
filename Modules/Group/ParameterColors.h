#pragma once

#include "PalpateGroupModule.h"
#include "SoftwareRenderer.h"
#include "Vector3.h"

namespace palpate
{
/// The colour of a direction (unit vector) of a parameter sphere, the same for every shape: a hue
/// for each of the eight octants, light and dark in turn for cells of 30 degrees of longitude and
/// latitude about z. No rotation leaves the pattern as it is. The hues are distinguishable for
/// colour-blind readers (Okabe and Ito, Color Universal Design, 2008).
PALPATEGROUP_EXPORT SoftwareRenderer::Color ParameterColor(const Vector3& direction);
} // namespace palpate
