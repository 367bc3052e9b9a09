#include "SampleEffect.h"

#include "SceneSettings.h"

namespace palpate
{
SceneEffectKind SampleEffect::Kind()
{
  SceneEffectKind kind;
  kind.Name = "adhesion";
  kind.Numbers = {{"adhesion_n", "Adhesion, N", 5.0, 2}};
  kind.Make = [](const SceneEffectSource& source, const ProgressFunction& /*progress*/)
  { return std::make_shared<const SampleEffect>(source.Structure.Number("adhesion_n")); };
  return kind;
}
} // namespace palpate
