#include "ElasticRepresentation.h"

#include "CaseText.h"
#include "ModelSoftening.h"
#include "SceneLabels.h"
#include "SceneReading.h"
#include "SceneTissue.h"
#include "StructurePlan.h"

namespace palpate
{
namespace
{
// Everything that a structure is softened by, except its images, which are inputs of the node.
struct Recipe
{
  SofteningSettings Settings;
  bool HasElastography = false;
  std::vector<SceneStructure> Inclusions;
  std::vector<SceneStructure> Neighbours;
};

// The model with its elasticity. `inputs`: the model, the elastography image, and the segmentations
// of inclusions and of neighbours.
SceneProduct Soften(Recipe recipe, const StructurePlan::Inputs& inputs,
                    const ProgressFunction& progress)
{
  const auto fit = ProductAs<FitResult>(inputs.data());
  if (fit->Elasticity != nullptr)
  {
    return fit;
  }
  std::size_t next = 1;
  if (recipe.HasElastography)
  {
    recipe.Settings.Elastography = ProductAs<Volume>(&inputs[next++]);
  }
  for (const SceneStructure& structure : recipe.Inclusions)
  {
    SofteningSettings::Inclusion inclusion;
    inclusion.Read = ProductAs<Segmentation>(&inputs[next++]);
    inclusion.Segments = SegmentsOf(structure, *inclusion.Read);
    inclusion.Kilopascal = structure.Number(TissueKey::Inclusion);
    recipe.Settings.Inclusions.push_back(std::move(inclusion));
  }
  for (const SceneStructure& structure : recipe.Neighbours)
  {
    SofteningSettings::Neighbour neighbour;
    neighbour.Read = ProductAs<Segmentation>(&inputs[next++]);
    neighbour.Segments = SegmentsOf(structure, *neighbour.Read);
    neighbour.KilopascalPerMillimeter = structure.Number(TissueKey::Neighbour);
    recipe.Settings.Neighbours.push_back(std::move(neighbour));
  }
  ModelSoftness softness =
      SoftenModel(fit->Model, CaseTitle(fit->Input, fit->Structure), recipe.Settings, progress);
  auto softened = std::make_shared<FitResult>(*fit);
  softened->Elasticity = std::move(softness.Elasticity);
  softened->Tissue = std::move(softness.Tissue);
  return std::shared_ptr<const FitResult>(std::move(softened));
}

void PlanElasticContact(StructurePlan& plan)
{
  plan.AddContact("elastic", AddElasticity(plan),
                  [](const StructurePlan::Inputs& inputs, const ProgressFunction&) -> SceneProduct
                  {
                    return std::make_shared<const TouchContact>(
                        ElasticContactOf(*ProductAs<FitResult>(inputs.data())));
                  });
}
} // namespace

// The key has only what the softening depends on, so that other numbers do not repeat it.
std::string AddElasticity(StructurePlan& plan)
{
  const SceneStructure& structure = plan.Settings();
  Recipe recipe;
  recipe.Settings = SofteningSettingsOf(structure);
  std::vector<std::string> inputs{plan.AddModel()};
  std::string key = SceneKey(inputs.front(), "elasticity");
  for (const SceneNumber& number : TissueNumbers())
  {
    key = SceneKey(key, structure.Number(number.Key));
  }
  const std::filesystem::path elastography = structure.Image(TissueKey::Elastography);
  if (!elastography.empty())
  {
    recipe.HasElastography = true;
    inputs.push_back(plan.AddImage(elastography));
    key = SceneKey(key, "elastography", inputs.back());
  }
  const auto add = [&](const char* name, std::vector<SceneStructure>& surroundings)
  {
    for (const SceneStructure* one : SurroundingsOf(plan.Whole(), structure, name))
    {
      surroundings.push_back(*one);
      inputs.push_back(plan.AddSegmentationOf(*one));
      key = SceneKey(key, name, inputs.back(), one->Number(name));
      for (const std::string& label : one->Labels)
      {
        key = SceneKey(key, label);
      }
    }
  };
  add(TissueKey::Inclusion, recipe.Inclusions);
  add(TissueKey::Neighbour, recipe.Neighbours);
  return plan.AddNode(SceneStep::Elasticity, key, std::move(inputs),
                      [recipe = std::move(recipe)](const StructurePlan::Inputs& made,
                                                   const ProgressFunction& progress)
                      { return Soften(recipe, made, progress); });
}

TouchContact ElasticContactOf(const FitResult& fit)
{
  return MakeElasticContact(fit.Model, *fit.Elasticity, fit.Tissue, fit.Input);
}

SceneRepresentation ElasticRepresentation()
{
  SceneRepresentation elastic;
  elastic.Name = elastic.Label = TouchRepresentation::Elastic;
  elastic.Sources = {SceneSource::Label, SceneSource::Model};
  elastic.Appearance = SceneAppearance::Model;
  elastic.Numbers = TissueNumbers();
  constexpr double LongestRelaxation = 100.0;
  elastic.Numbers.push_back({"relaxation_ms", "Relaxation, ms", LongestRelaxation, 1});
  elastic.ImageKey = TissueKey::Elastography;
  elastic.ImageLabel = "Elastography image, kPa";
  elastic.PlanContact = PlanElasticContact;
  elastic.PlanDisplay = [](StructurePlan& plan) { plan.AddModel(); };
  elastic.Describe = [](const ContactSetting&) { return std::string("elastic"); };
  elastic.KeyOf = [](const ContactSetting&) { return std::string("elastic"); };
  return elastic;
}
} // namespace palpate
