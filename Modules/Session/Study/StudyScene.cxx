#include "StudyScene.h"

#include "TouchStandIns.h"
#include "TouchStructures.h"

namespace palpate
{
namespace
{
// A contact that was made before a structure was to be drilled shows another field, or none.
DrillSource SourceOf(const StudyStructure& structure, const TouchContact& contact,
                     const StudyPipeline& pipeline)
{
  const auto segmentation = pipeline.Newest<Segmentation>(StudyStep::Segmentation);
  DrillSource source;
  if (structure.IsDrilled() && segmentation != nullptr && contact.Looks.Field != nullptr &&
      contact.IsDrillable)
  {
    const Segment& segment = segmentation->Find(std::to_string(structure.Label));
    source.Field = contact.Looks.Field;
    source.Image = segmentation->Layers[static_cast<std::size_t>(segment.Layer)];
    source.Label = segment.Value;
  }
  return source;
}
} // namespace

std::vector<StudyContact> ContactsOf(const StudyState& state, const StudyPipeline& pipeline)
{
  std::vector<StudyContact> contacts;
  for (const StudyStructure& structure : state.Structures)
  {
    auto contact = pipeline.Newest<TouchContact>(StudyStep::Touch, structure.Label);
    if (contact != nullptr)
    {
      contacts.push_back({structure.Label, contact, SourceOf(structure, *contact, pipeline)});
    }
  }
  return TouchableOf(state, contacts);
}

std::vector<StudyContact> TouchableOf(const StudyState& state,
                                      const std::vector<StudyContact>& contacts)
{
  std::vector<StudyContact> touchable;
  for (const StudyContact& contact : contacts)
  {
    const StudyStructure* structure = FindStructure(state, contact.Label);
    if (structure != nullptr && structure->IsTouchable)
    {
      touchable.push_back(contact);
    }
  }
  return touchable;
}

TouchScene MakeStudyScene(const StudyState& state, const std::vector<StudyContact>& contacts,
                          const WorkspaceFrame& frame)
{
  TouchScene scene;
  scene.Tool = MakeTool(state.Tool);
  scene.Frame = frame.ForDevice();
  for (const StudyContact& contact : contacts)
  {
    const StudyStructure* structure = FindStructure(state, contact.Label);
    TouchStructure touch;
    touch.Name = TitleOf(*structure);
    touch.Id = contact.Label;
    touch.Model = contact.Contact->Model;
    if (contact.Drilled.Field == nullptr)
    {
      touch.Coarser = StandInsFor(*contact.Contact, scene.Tool);
    }
    touch.Drill = structure->Drill;
    touch.Law.Stiffness = structure->Stiffness;
    touch.Friction = structure->Friction;
    scene.Structures.push_back(std::move(touch));
  }
  return scene;
}
} // namespace palpate
