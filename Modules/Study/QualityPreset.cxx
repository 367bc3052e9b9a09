#include "QualityPreset.h"

#include <array>

namespace palpate
{
namespace
{
constexpr std::array<int, 4> Degrees{{4, 8, 12, 16}};
constexpr int FirstField = 4;
constexpr int Cubic = 5;
} // namespace

bool HasPresets(const SceneStructure& structure)
{
  return structure.Source() == SceneSource::Label &&
         structure.Representation != TouchRepresentation::Elastic;
}

const char* NameOfPreset(int preset)
{
  constexpr std::array<const char*, QualityPresetCount> Names{
      "Harmonics of degree 4",  "Harmonics of degree 8", "Harmonics of degree 12",
      "Harmonics of degree 16", "Sub-voxel, linear",     "Sub-voxel, cubic"};
  return Names.at(static_cast<std::size_t>(preset));
}

SceneStructure WithPreset(SceneStructure structure, int preset)
{
  if (HasPresets(structure))
  {
    const bool isField = preset >= FirstField;
    structure.Representation =
        isField ? TouchRepresentation::SubVoxel : TouchRepresentation::ModelOrField;
    structure.Degree = isField ? structure.Degree : Degrees.at(static_cast<std::size_t>(preset));
    structure.Interpolation =
        preset == Cubic ? FieldInterpolation::TricubicBSpline : FieldInterpolation::Trilinear;
  }
  return structure;
}

int PresetOf(const SceneStructure& structure)
{
  for (int preset = 0; preset < QualityPresetCount; ++preset)
  {
    if (WithPreset(structure, preset) == structure)
    {
      return preset;
    }
  }
  return -1;
}

int PresetOf(const SceneSettings& scene)
{
  int all = -1;
  bool isFirst = true;
  for (const SceneStructure& structure : scene.Structures)
  {
    if (structure.IsTouchable && HasPresets(structure))
    {
      const int one = PresetOf(structure);
      all = isFirst || one == all ? one : -1;
      isFirst = false;
    }
  }
  return all;
}
} // namespace palpate
