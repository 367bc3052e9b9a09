#pragma once

#include "PalpateDisplayModule.h"

#include <array>

namespace palpate
{
/// The colour of a new structure (red, green, blue, 0..1): its file's, unless that is black or
/// nearly so, which would be a hole in 3D. Then one that colour-blind people can tell from its
/// neighbours', determined by `id`.
PALPATEDISPLAY_EXPORT std::array<double, 3> StructureColor(const std::array<double, 3>& ofFile,
                                                           int id);
} // namespace palpate
