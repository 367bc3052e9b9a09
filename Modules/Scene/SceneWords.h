#pragma once

#include <initializer_list>

namespace palpate
{
/// The words of files for choices of SceneSettings, in the order of their enumerators.
inline const std::initializer_list<const char*> RepresentationWords{
    "automatic", "harmonics", "facets", "sub-voxel", "model-or-field"};
inline const std::initializer_list<const char*> InterpolationWords{"linear", "cubic"};
} // namespace palpate
