#include "SceneEffect.h"

#include "ContactLimits.h"
#include "EffectField.h"
#include "FieldOfImage.h"
#include "GuidingGradient.h"
#include "KindRegistration.h"
#include "Refusal.h"
#include "SceneSettings.h"
#include "StiffnessImage.h"
#include "SurfaceTexture.h"
#include "VolumeViscosity.h"

#include <utility>

namespace palpate
{
namespace
{
constexpr double LargestImageValue = 1e6; // to either side of 0

std::shared_ptr<const ForceEffect> MakeTexture(const SceneEffectSource& source, double amplitude,
                                               const ProgressFunction& progress)
{
  const auto field = FieldAround(source, {"texture"}, progress);
  std::shared_ptr<const SurfaceTexture> texture;
  RequireInput(SurfaceTexture::Make(field, 0, source.BoundsWorld, amplitude, texture),
               source.Image->Source.string());
  return texture;
}

std::shared_ptr<const ForceEffect> MakeStiffness(const SceneEffectSource& source,
                                                 const StiffnessRange& range,
                                                 const ProgressFunction& progress)
{
  const std::string image = source.Image->Source.string();
  if (source.Yields)
  {
    Refuse(image, "cannot be felt as stiffness on a structure that yields, whose tissue decides",
           "remove the stiffness image, or choose another touch model");
  }
  // So much that the stiffness fades out where the image ends, not where it is cut.
  const Vector3 spacing = GridOfImage(source.Image->Image).Spacing();
  EffectFieldSettings settings{"stiffness"};
  settings.Margin = StiffnessImage::FadeVoxels * spacing.maxCoeff();
  const auto field = FieldAround(source, settings, progress);
  std::shared_ptr<const StiffnessImage> stiffness;
  RequireInput(StiffnessImage::Make(field, 0, range, stiffness), image);
  return stiffness;
}

std::shared_ptr<const ForceEffect> MakeGradient(const SceneEffectSource& source,
                                                const GuidingSettings& settings, double smoothing,
                                                const ProgressFunction& progress)
{
  EffectFieldSettings image{"gradient"};
  image.Margin = settings.Fade;
  image.Smoothing = smoothing;
  image.Interpolation = FieldInterpolation::TricubicBSpline;
  const auto field = FieldAround(source, image, progress);
  std::shared_ptr<const GuidingGradient> gradient;
  RequireInput(GuidingGradient::Make(field, 0, settings, gradient), source.Image->Source.string());
  return gradient;
}

// A small force from the intensities of an image (see SurfaceTexture). Only the part of the image
// where tool and structure can meet is kept in memory.
SceneEffectKind TextureKind()
{
  constexpr double Largest = 10.0; // N
  SceneEffectKind kind;
  kind.Name = "texture";
  kind.Numbers = {{"texture_n", "Texture, N", Largest, 3}};
  kind.ImageKey = "texture_image";
  kind.ImageLabel = "Texture image";
  kind.Make = [key = kind.Numbers.front().Key](const SceneEffectSource& source,
                                               const ProgressFunction& progress)
  { return MakeTexture(source, source.Structure.Number(key), progress); };
  return kind;
}

// The stiffness of a rigid structure from the intensities of an image (see StiffnessImage).
SceneEffectKind StiffnessKind()
{
  SceneEffectKind kind;
  kind.Name = "stiffness image";
  kind.Numbers = {
      {"stiffness_from_n_per_mm", "Stiffness at the first value, N/mm", ContactLimits::Stiffness,
       3},
      {"stiffness_from_value", "First value", LargestImageValue, 6, {}, -LargestImageValue},
      {"stiffness_to_n_per_mm", "Stiffness at the second value, N/mm", ContactLimits::Stiffness, 3},
      {"stiffness_to_value", "Second value", LargestImageValue, 6, {}, -LargestImageValue}};
  kind.ImageKey = "stiffness_image";
  kind.ImageLabel = "Stiffness image";
  kind.Make = [](const SceneEffectSource& source, const ProgressFunction& progress)
  {
    const auto number = [&](const char* key) { return source.Structure.Number(key); };
    return MakeStiffness(source,
                         {number("stiffness_from_value"), number("stiffness_to_value"),
                          number("stiffness_from_n_per_mm"), number("stiffness_to_n_per_mm")},
                         progress);
  };
  return kind;
}

// A force along the gradient of an image around the structure (see GuidingGradient).
SceneEffectKind GradientKind()
{
  constexpr double MostEnergy = 100.0;  // N mm
  constexpr double MostForce = 3.0;     // N
  constexpr double MostSmoothing = 5.0; // mm
  SceneEffectKind kind;
  kind.Name = "guiding gradient";
  kind.Numbers = {
      {"gradient_n_mm", "Energy between both values, N mm", MostEnergy, 3},
      {"gradient_from_value", "From this value", LargestImageValue, 6, {}, -LargestImageValue},
      {"gradient_to_value", "Towards this value", LargestImageValue, 6, {}, -LargestImageValue},
      {"gradient_largest_n", "Largest force", MostForce, 3, {}, 0.0, "N", "0.5 N (default)"},
      {"gradient_smoothing_mm", "Smoothing of the image, mm", MostSmoothing, 2}};
  kind.ImageKey = "gradient_image";
  kind.ImageLabel = "Gradient image";
  kind.Make = [](const SceneEffectSource& source, const ProgressFunction& progress)
  {
    const auto number = [&](const char* key) { return source.Structure.Number(key); };
    GuidingSettings settings;
    settings.FromIntensity = number("gradient_from_value");
    settings.ToIntensity = number("gradient_to_value");
    settings.Energy = number("gradient_n_mm");
    const double largest = number("gradient_largest_n");
    settings.LargestForce = largest > 0.0 ? largest : settings.LargestForce;
    return MakeGradient(source, settings, number("gradient_smoothing_mm"), progress);
  };
  return kind;
}

SceneEffectKind ViscosityKind()
{
  constexpr double Largest = 10.0; // N s/mm
  SceneEffectKind kind;
  kind.Name = "viscosity";
  kind.Numbers = {{"viscosity_ns_per_mm", "Viscosity inside, N s/mm", Largest, 5}};
  kind.Make = [key = kind.Numbers.front().Key](const SceneEffectSource& source,
                                               const ProgressFunction& /*progress*/)
  { return std::make_shared<const VolumeViscosity>(source.Structure.Number(key)); };
  return kind;
}

// Recordings replay the sum in this order.
std::deque<SceneEffectKind>& Kinds()
{
  static std::deque<SceneEffectKind> kinds{TextureKind(), ViscosityKind(), StiffnessKind(),
                                           GradientKind()};
  return kinds;
}
} // namespace

bool SceneEffectKind::IsIn(const SceneStructure& structure) const
{
  return structure.Number(this->Numbers.front().Key) != 0.0;
}

const std::deque<SceneEffectKind>& SceneEffectKinds()
{
  return Kinds();
}

void AddSceneEffectKind(SceneEffectKind kind)
{
  AddOrReplace(Kinds(), std::move(kind));
}

std::vector<const SceneEffectKind*> EffectsOf(const SceneStructure& structure)
{
  std::vector<const SceneEffectKind*> effects;
  for (const SceneEffectKind& kind : SceneEffectKinds())
  {
    if (kind.IsIn(structure))
    {
      effects.push_back(&kind);
    }
  }
  return effects;
}

std::size_t ImageEffects::Bytes() const
{
  std::size_t bytes = 0;
  for (const auto& [name, effect] : this->Made)
  {
    bytes += effect->Bytes();
  }
  return bytes;
}
} // namespace palpate
