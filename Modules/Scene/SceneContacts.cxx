#include "SceneContacts.h"

#include "GuideField.h"
#include "Refusal.h"
#include "SceneTool.h"
#include "StructureGuide.h"

#include <algorithm>
#include <cmath>

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

// Guides by structures act once their distances have been made.
std::vector<std::shared_ptr<const ForceField>> MakeGuides(const std::vector<GuideSettings>& guides,
                                                          const GuideDistances& distances)
{
  std::vector<std::shared_ptr<const ForceField>> fields;
  for (const GuideSettings& guide : guides)
  {
    const auto found = distances.find(guide.Structure);
    if (!guide.HasStructure())
    {
      std::shared_ptr<const ForceField> field;
      RequireInput(GuideField::Make(guide, field));
      fields.push_back(std::move(field));
    }
    // Those of a former, shorter range are kept until new ones are made.
    else if (found != distances.end() &&
             std::abs(guide.Distance) + guide.Range <= found->second->Reach())
    {
      std::shared_ptr<const StructureGuide> field;
      RequireInput(StructureGuide::Make(guide, found->second, field));
      fields.push_back(std::move(field));
    }
  }
  return fields;
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

GuideDistances GuideDistancesOf(const SceneSettings& scene, const SceneProducts& products)
{
  GuideDistances distances;
  for (const SceneStructure& structure : scene.Structures)
  {
    auto made = ProductAs<StructureDistance>(products(SceneStep::Guide, structure.Id));
    if (made != nullptr && IsGuide(scene, structure.Id))
    {
      distances[structure.Id] = std::move(made);
    }
  }
  return distances;
}

TouchScene MakeTouchScene(const SceneSettings& scene, const std::vector<SceneContact>& contacts,
                          const WorkspaceFrame& frame, const GuideDistances& distances)
{
  TouchScene made;
  made.Tool = MakeTool(scene.Tool);
  made.Frame = frame.ForDevice();
  made.Fields = MakeGuides(scene.Guides, distances);
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
    touch.Cuts = contact.Contact->Cuts;
    touch.Effects = MakeEffects(structure, contact, made.Tool.BoundingRadius());
    touch.Drill = structure.Drill;
    made.Structures.push_back(std::move(touch));
  }
  return made;
}
} // namespace palpate
