#include "SofteningNotes.h"

#include "SceneLabels.h"
#include "SceneTissue.h"

#include <algorithm>

namespace palpate
{
namespace
{
std::vector<const SceneStructure*> YieldingOf(const SceneSettings& scene)
{
  std::vector<const SceneStructure*> yielding;
  for (const SceneStructure& structure : scene.Structures)
  {
    const bool isMapped =
        structure.IsVisible && structure.Appearance == SceneAppearance::StiffnessMap;
    if (structure.Representation == TouchRepresentation::Elastic &&
        (structure.IsTouchable || isMapped))
    {
      yielding.push_back(&structure);
    }
  }
  return yielding;
}

// The share of an inclusion in all structures together; unnamed if they all have their own
// elasticity.
InclusionShare SumOf(int id, const std::vector<std::shared_ptr<const SceneInclusions>>& all)
{
  InclusionShare sum;
  for (const auto& one : all)
  {
    for (const auto& [inclusion, share] : one->Shares)
    {
      if (inclusion == id)
      {
        sum.Name = share.Name;
        sum.Milliliters = share.Milliliters;
        sum.InsideMilliliters += share.InsideMilliliters;
      }
    }
  }
  return sum;
}
// What fitted models leave out, fill or cut, in the words of `palpate fit`.
std::vector<SofteningNote> NotesOfFits(const SceneSettings& scene, const SceneProducts& products)
{
  std::vector<SofteningNote> notes;
  for (const SceneStructure& structure : scene.Structures)
  {
    const auto fit = ProductAs<FitResult>(products(SceneStep::Model, structure.Id));
    const bool isFitted = fit != nullptr && fit->State == FitResult::Outcome::Fitted;
    if (isFitted && !fit->Message.empty())
    {
      notes.push_back({structure.Id, TitleOf(structure) + " " + fit->Message});
    }
  }
  return notes;
}
} // namespace

std::vector<SofteningNote> SofteningNotes(const SceneSettings& scene, const SceneProducts& products)
{
  const std::vector<const SceneStructure*> yielding = YieldingOf(scene);
  std::vector<SofteningNote> notes = NotesOfFits(scene, products);
  std::vector<std::shared_ptr<const SceneInclusions>> all;
  for (const SceneStructure* structure : yielding)
  {
    if (const auto softened = ProductAs<FitResult>(products(SceneStep::Elasticity, structure->Id)))
    {
      for (const std::string& note : softened->Notes)
      {
        notes.push_back({structure->Id, TitleOf(*structure) + ": " + note});
      }
    }
    if (auto inclusions =
            ProductAs<SceneInclusions>(products(SceneStep::Inclusions, structure->Id)))
    {
      all.push_back(std::move(inclusions));
    }
  }
  if (all.empty() || all.size() < yielding.size())
  {
    return notes;
  }
  const std::string organ =
      yielding.size() == 1 ? TitleOf(*yielding.front()) : "the structures that yield";
  for (const SceneStructure& structure : scene.Structures)
  {
    const InclusionShare share = SumOf(structure.Id, all);
    const std::string note = share.Name.empty() ? std::string() : share.Note(organ);
    if (!note.empty())
    {
      notes.push_back({structure.Id, note});
    }
  }
  return notes;
}
} // namespace palpate
