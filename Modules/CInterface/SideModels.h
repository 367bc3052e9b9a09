#pragma once

#include "ShapeAsymmetry.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// The sides of shapes about the origin: the first `count` are left ones, further ones their right
/// partners, and without these the mirror images are. Throws InputError.
ShapeSides SidesOf(std::vector<OrganModel> shapes, std::size_t count, bool turnsToMean);
} // namespace palpate
