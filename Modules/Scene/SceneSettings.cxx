#include "SceneSettings.h"

#include "FitStructure.h"
#include "ModelFile.h"
#include "SurfaceFile.h"

#include <algorithm>
#include <tuple>

namespace palpate
{
namespace
{
auto Fields(const SceneStructure& s)
{
  return std::tie(s.Id, s.Name, s.File, s.Labels, s.Iso, s.IsoUpper, s.WithinFile, s.WithinLabel,
                  s.Series, s.Move, s.IsVisible, s.IsTouchable, s.Color, s.Opacity, s.Appearance,
                  s.Representation, s.Degree, s.Mode, s.Interpolation, s.Smoothing, s.KeepsCuts,
                  s.Stiffness, s.Damping, s.Friction.Static, s.Friction.Dynamic, s.Numbers,
                  s.Images, s.Drill.Wear, s.Drill.Drag, s.Drill.Vibration, s.IsForbidden,
                  s.AlarmDistance);
}

auto Fields(const ScenePlacement& p)
{
  return std::tie(p.Scale, p.CenterWorld, p.AxesFollowCamera);
}

auto Fields(const SceneSettings& s)
{
  return std::tie(s.Structures, s.Guides, s.LeftHanded, s.Fit, s.Tool, s.Drill.Turns,
                  s.Drill.VibrationFrequency, s.Device, s.Rate, s.ModelInterval, s.Placement);
}
} // namespace

const char* NameOf(SceneAppearance appearance)
{
  constexpr std::array<const char*, 6> Names{
      "automatic", "model", "surface", "error map", "sub-voxel volume", "stiffness map"};
  return Names.at(static_cast<std::size_t>(appearance));
}

SceneSource SceneStructure::Source() const
{
  return this->Iso                   ? SceneSource::IsoValue
         : IsModelFile(this->File)   ? SceneSource::Model
         : IsSurfaceFile(this->File) ? SceneSource::Surface
                                     : SceneSource::Label;
}

double SceneStructure::Number(const std::string& key) const
{
  const auto found = this->Numbers.find(key);
  return found != this->Numbers.end() ? found->second : 0.0;
}

std::filesystem::path SceneStructure::Image(const std::string& key) const
{
  const auto found = this->Images.find(key);
  return found != this->Images.end() ? found->second : std::filesystem::path();
}

void SceneStructure::SetNumber(const std::string& key, double number)
{
  this->Numbers.erase(key);
  if (number != 0.0)
  {
    this->Numbers[key] = number;
  }
}

void SceneStructure::SetImage(const std::string& key, const std::filesystem::path& image)
{
  this->Images.erase(key);
  if (!image.empty())
  {
    this->Images[key] = image;
  }
}

bool operator==(const SceneStructure& a, const SceneStructure& b)
{
  return Fields(a) == Fields(b);
}

bool operator==(const ScenePlacement& a, const ScenePlacement& b)
{
  return Fields(a) == Fields(b);
}

bool operator==(const SceneSettings& a, const SceneSettings& b)
{
  return Fields(a) == Fields(b);
}

std::string TitleOf(const SceneStructure& structure)
{
  if (!structure.Name.empty())
  {
    return structure.Name;
  }
  switch (structure.Source())
  {
  case SceneSource::Model:
  case SceneSource::Surface:
    return structure.File.stem().string();
  case SceneSource::Label:
    return structure.Labels.empty() ? CaseNameOf(structure.File)
                                    : "label " + structure.Labels.front();
  default:
    return CaseNameOf(structure.File);
  }
}

bool HasTouchable(const SceneSettings& scene)
{
  return std::any_of(scene.Structures.begin(), scene.Structures.end(),
                     [](const SceneStructure& one) { return one.IsTouchable; });
}

const SceneStructure* FindStructure(const SceneSettings& scene, int id)
{
  const auto found = std::find_if(scene.Structures.begin(), scene.Structures.end(),
                                  [id](const SceneStructure& one) { return one.Id == id; });
  return found != scene.Structures.end() ? &*found : nullptr;
}

bool IsGuide(const SceneSettings& scene, int id)
{
  return std::any_of(scene.Guides.begin(), scene.Guides.end(),
                     [id](const GuideSettings& guide)
                     { return guide.HasStructure() && guide.Structure == id; });
}

void DropLooseGuides(SceneSettings& scene)
{
  const auto isLoose = [&scene](const GuideSettings& guide)
  { return guide.HasStructure() && FindStructure(scene, guide.Structure) == nullptr; };
  scene.Guides.erase(std::remove_if(scene.Guides.begin(), scene.Guides.end(), isLoose),
                     scene.Guides.end());
}

FitSettings FitSettingsOf(const SceneSettings& scene, const SceneStructure& structure)
{
  FitSettings settings = scene.Fit;
  settings.Degree = structure.Degree;
  return settings;
}
} // namespace palpate
