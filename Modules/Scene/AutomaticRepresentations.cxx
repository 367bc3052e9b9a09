#include "AutomaticRepresentations.h"

#include "FacetRepresentation.h"
#include "FieldRepresentation.h"
#include "HarmonicRepresentation.h"
#include "StructurePlan.h"

namespace palpate
{
namespace
{
std::vector<SceneSource> AllSources()
{
  return {SceneSource::Label, SceneSource::IsoValue, SceneSource::Model, SceneSource::Surface};
}

void PlanBySource(StructurePlan& plan)
{
  switch (plan.Settings().Source())
  {
  case SceneSource::Model:
    return PlanHarmonicContact(plan);
  case SceneSource::Surface:
    return PlanFacetContact(plan);
  default:
    return PlanFieldContact(plan);
  }
}

// "prostate: touched by its sub-voxel field, because it is not star-shaped: ..."
std::string AdviceOf(const SceneStructure& structure, const std::string& instead,
                     const std::string& reason)
{
  const bool isPredicate = reason.rfind("is ", 0) == 0 || reason.rfind("has ", 0) == 0;
  return TitleOf(structure) + ": " + instead + ", because " + (isPredicate ? "it " : "") + reason;
}

// Harmonics, or the field once any of their steps has failed.
void PlanModelOrField(StructurePlan& plan)
{
  const SceneStructure& structure = plan.Settings();
  const std::string surface = plan.AddSurface();
  const std::string model = plan.AddModel();
  const std::size_t last = plan.NodeCount();
  const std::string reason = plan.FirstFailure();
  if (reason.empty())
  {
    if (structure.IsTouchable && plan.Find(model) != nullptr)
    {
      PlanHarmonicContact(plan);
    }
    else if (structure.IsTouchable)
    {
      plan.AddUndecidedContact(model);
    }
    return;
  }
  const SceneProduct* made = plan.Find(surface);
  const bool hasSurface = made == nullptr || ReasonOf(*made).empty();
  std::string instead = "displayed as the surface of its mask";
  std::string replacement = surface;
  if (structure.IsTouchable || !hasSurface)
  {
    replacement = plan.AddField();
    instead = structure.IsTouchable ? "touched by its sub-voxel field"
                                    : "displayed by its sub-voxel field";
  }
  if (structure.IsTouchable)
  {
    PlanFieldContact(plan);
  }
  plan.Replace(last, replacement, AdviceOf(structure, instead, reason));
}
} // namespace

SceneRepresentation AutomaticRepresentation()
{
  SceneRepresentation automatic;
  automatic.Name = automatic.Label = TouchRepresentation::Automatic;
  automatic.Sources = AllSources();
  automatic.CanBeDrilled = true;
  automatic.Appearance = SceneAppearance::SubVoxel;
  automatic.PlanContact = PlanBySource;
  return automatic;
}

SceneRepresentation ModelOrFieldRepresentation()
{
  SceneRepresentation either;
  either.Name = TouchRepresentation::ModelOrField;
  either.Label = "model or field";
  either.Sources = AllSources();
  either.Appearance = SceneAppearance::Model;
  either.PlanContact = [](StructurePlan& plan)
  { plan.Settings().Source() == SceneSource::Label ? PlanModelOrField(plan) : PlanBySource(plan); };
  either.PlanDisplay = PlanModelOrField;
  return either;
}
} // namespace palpate
