#pragma once

#include "PalpateStudyModule.h"
#include "SceneSettings.h"

namespace palpate
{
/// Scene-wide quality presets, from fastest to most accurate. Choosing one writes its settings into
/// the structures; a structure that matches none has manual settings.
constexpr int QualityPresetCount = 6;

/// "Harmonics of degree 4", ..., "Sub-voxel, linear", "Sub-voxel, cubic".
PALPATESTUDY_EXPORT const char* NameOfPreset(int preset);

/// Whether presets apply to a structure: to labels that do not yield.
PALPATESTUDY_EXPORT bool HasPresets(const SceneStructure& structure);

/// The structure with the settings of a preset; harmonics fall back to the field if they do not
/// fit. Structures without presets keep their settings.
PALPATESTUDY_EXPORT SceneStructure WithPreset(SceneStructure structure, int preset);

/// The preset that a structure's settings match, or -1.
PALPATESTUDY_EXPORT int PresetOf(const SceneStructure& structure);
/// The preset that all touchable structures with presets match, or -1.
PALPATESTUDY_EXPORT int PresetOf(const SceneSettings& scene);
} // namespace palpate
