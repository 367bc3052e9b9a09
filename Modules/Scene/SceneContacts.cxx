#include "SceneContacts.h"

#include "Refusal.h"
#include "SceneTool.h"

#include <algorithm>

namespace palpate
{
namespace
{
bool NeedsImage(const SceneStructure& structure)
{
  const std::vector<const SceneEffectKind*> effects = EffectsOf(structure);
  return std::any_of(effects.begin(), effects.end(),
                     [](const SceneEffectKind* kind) { return !kind->ImageKey.empty(); });
}

// Effects made from an image act once they have been made.
std::vector<std::shared_ptr<const ForceEffect>>
MakeEffects(const SceneStructure& structure, const SceneContact& contact, double toolReach)
{
  std::vector<std::shared_ptr<const ForceEffect>> effects;
  for (const SceneEffectKind* kind : EffectsOf(structure))
  {
    if (kind->ImageKey.empty())
    {
      const auto isNeverCancelled = [](double, const std::string&) { return true; };
      effects.push_back(kind->Make({structure, nullptr, contact.Contact->Model->BoundsWorld(),
                                    toolReach, contact.Contact->Yields},
                                   isNeverCancelled));
    }
    else if (contact.Effects != nullptr && contact.Effects->Made.count(kind->Name) > 0)
    {
      effects.push_back(contact.Effects->Made.at(kind->Name));
    }
  }
  return effects;
}
} // namespace

std::vector<SceneContact> ContactsOf(const SceneSettings& scene, const SceneProducts& products)
{
  std::vector<SceneContact> contacts;
  for (const SceneStructure& structure : scene.Structures)
  {
    auto contact = ProductAs<TouchContact>(products(SceneStep::Touch, structure.Id));
    if (contact == nullptr || !structure.IsTouchable)
    {
      continue;
    }
    SceneContact one;
    one.Id = structure.Id;
    if (NeedsImage(structure))
    {
      one.Effects = ProductAs<ImageEffects>(products(SceneStep::Effects, structure.Id));
    }
    // A contact made before the structure became drilled has no source.
    one.Drilled = structure.IsDrilled() ? contact->Drilled : DrillSource();
    one.Contact = std::move(contact);
    contacts.push_back(std::move(one));
  }
  return contacts;
}

TouchScene MakeTouchScene(const SceneSettings& scene, const std::vector<SceneContact>& contacts,
                          const WorkspaceFrame& frame)
{
  TouchScene made;
  made.Tool = MakeTool(scene.Tool);
  made.Frame = frame.ForDevice();
  for (const GuideSettings& guide : scene.Guides)
  {
    std::shared_ptr<const ForceField> field;
    RequireInput(GuideField::Make(guide, field));
    made.Fields.push_back(std::move(field));
  }
  for (const SceneContact& contact : contacts)
  {
    const SceneStructure& structure = *FindStructure(scene, contact.Id);
    TouchStructure touch;
    touch.Name = TitleOf(structure);
    touch.Id = contact.Id;
    touch.Model = contact.Contact->Model;
    constexpr double PerMillisecond = 1e-3;
    touch.Law = {structure.Stiffness, structure.Damping,
                 PerMillisecond * structure.Number("relaxation_ms")};
    touch.Friction = structure.Friction;
    touch.Effects = MakeEffects(structure, contact, made.Tool.BoundingRadius());
    touch.Drill = structure.Drill;
    made.Structures.push_back(std::move(touch));
  }
  return made;
}
} // namespace palpate
