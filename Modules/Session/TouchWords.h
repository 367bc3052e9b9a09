#pragma once

#include <initializer_list>

namespace palpate
{
/// The words of files for choices of TouchSettings, in the order of their enumerators.
inline const std::initializer_list<const char*> RepresentationWords{"automatic", "harmonics",
                                                                    "facets", "sub-voxel"};
inline const std::initializer_list<const char*> PrecisionWords{"double", "float"};
inline const std::initializer_list<const char*> InterpolationWords{"linear", "cubic"};
} // namespace palpate
