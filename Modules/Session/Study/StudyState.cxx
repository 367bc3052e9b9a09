#include "StudyState.h"

#include <algorithm>
#include <tuple>

namespace palpate
{
namespace
{
auto Fields(const StudyStructure& s)
{
  return std::tie(s.Label, s.Name, s.Color, s.IsVisible, s.IsTouchable, s.Appearance,
                  s.Representation, s.Degree, s.Stiffness, s.Friction.Static, s.Friction.Dynamic,
                  s.Drill.Wear, s.Drill.Drag, s.Drill.Vibration, s.IsForbidden, s.AlarmDistance);
}

auto Fields(const StudyPlacement& p)
{
  return std::tie(p.Scale, p.CenterWorld, p.AxesFollowCamera);
}

auto Fields(const StudyLandmark& l)
{
  return std::tie(l.Name, l.PositionWorld);
}

auto Fields(const StudyDistance& d)
{
  return std::tie(d.Name, d.FromWorld, d.ToWorld);
}

auto Fields(const StudyView& v)
{
  return std::tie(v.CrosshairWorld, v.Window, v.Level, v.Layout, v.OverlayOpacity, v.UsesVolumeAxes,
                  v.SlicesFollowProbe);
}

auto Fields(const StudyState& s)
{
  return std::tie(s.VolumeFile, s.DicomSeries, s.SegmentationFile, s.LeftHanded, s.Structures,
                  s.Fit, s.Interpolation, s.FieldSmoothing, s.Tool, s.Drill.Turns,
                  s.Drill.VibrationFrequency, s.Device, s.Rate, s.Dial, s.Placement, s.Landmarks,
                  s.Distances, s.View);
}
} // namespace

const char* NameOf(StudyAppearance appearance)
{
  constexpr std::array<const char*, 5> Names{"automatic", "model", "surface", "error map",
                                             "sub-voxel volume"};
  return Names.at(static_cast<std::size_t>(appearance));
}

bool operator==(const StudyStructure& a, const StudyStructure& b)
{
  return Fields(a) == Fields(b);
}

bool operator==(const StudyPlacement& a, const StudyPlacement& b)
{
  return Fields(a) == Fields(b);
}

bool operator==(const StudyLandmark& a, const StudyLandmark& b)
{
  return Fields(a) == Fields(b);
}

bool operator==(const StudyDistance& a, const StudyDistance& b)
{
  return Fields(a) == Fields(b);
}

bool operator==(const StudyView& a, const StudyView& b)
{
  return Fields(a) == Fields(b);
}

bool operator==(const StudyState& a, const StudyState& b)
{
  return Fields(a) == Fields(b);
}

std::filesystem::path StudyPath(const std::filesystem::path& file)
{
  return file.empty() ? file : std::filesystem::absolute(file).lexically_normal();
}

std::string TitleOf(const StudyStructure& structure)
{
  return structure.Name.empty() ? "label " + std::to_string(structure.Label) : structure.Name;
}

const StudyStructure* FindStructure(const StudyState& state, int label)
{
  const auto found =
      std::find_if(state.Structures.begin(), state.Structures.end(),
                   [label](const StudyStructure& structure) { return structure.Label == label; });
  return found != state.Structures.end() ? &*found : nullptr;
}

FitSettings FitSettingsOf(const StudyState& state, const StudyStructure& structure)
{
  FitSettings settings = state.Fit;
  settings.Degree = structure.Degree;
  return settings;
}
} // namespace palpate
