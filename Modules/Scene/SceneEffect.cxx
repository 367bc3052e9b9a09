#include "SceneEffect.h"

#include "KindRegistration.h"
#include "SceneSettings.h"
#include "TouchTexture.h"
#include "VolumeViscosity.h"

#include <utility>

namespace palpate
{
namespace
{
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

// Texture before viscosity: recordings replay the sum in this order.
std::deque<SceneEffectKind>& Kinds()
{
  static std::deque<SceneEffectKind> kinds{TextureKind(), ViscosityKind()};
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
