#include "SceneContacts.h"

#include "SceneTool.h"

namespace palpate
{
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
    if (structure.Texture > 0.0)
    {
      one.Texture = ProductAs<TouchTexture>(products(SceneStep::Texture, structure.Id));
    }
    // A contact that was made before the structure was to be drilled has no source.
    one.Drilled = structure.IsDrilled() ? contact->Drilled : DrillSource();
    one.Contact = std::move(contact);
    contacts.push_back(std::move(one));
  }
  return contacts;
}

std::vector<SceneContact> TouchableOf(const SceneSettings& scene,
                                      const std::vector<SceneContact>& contacts)
{
  std::vector<SceneContact> touchable;
  for (const SceneContact& contact : contacts)
  {
    const SceneStructure* structure = FindStructure(scene, contact.Id);
    if (structure != nullptr && structure->IsTouchable)
    {
      touchable.push_back(contact);
    }
  }
  return touchable;
}

TouchScene MakeTouchScene(const SceneSettings& scene, const std::vector<SceneContact>& contacts,
                          const WorkspaceFrame& frame)
{
  TouchScene made;
  made.Tool = MakeTool(scene.Tool);
  made.Frame = frame.ForDevice();
  for (const SceneContact& contact : contacts)
  {
    const SceneStructure& structure = *FindStructure(scene, contact.Id);
    TouchStructure touch;
    touch.Name = TitleOf(structure);
    touch.Id = contact.Id;
    touch.Model = contact.Contact->Model;
    touch.Law = {structure.Stiffness, structure.Damping};
    touch.Friction = structure.Friction;
    touch.Viscosity = structure.Viscosity;
    touch.Texture = contact.Texture != nullptr ? contact.Texture->Feel : nullptr;
    touch.Drill = structure.Drill;
    made.Structures.push_back(std::move(touch));
  }
  return made;
}
} // namespace palpate
