#include "HarmonicRepresentation.h"

#include "SceneReading.h"
#include "StructurePlan.h"

#include <algorithm>

namespace palpate
{
namespace
{
SceneProduct MakeContact(const FitResult& fit, HarmonicContactMode mode)
{
  return std::make_shared<const TouchContact>(MakeHarmonicContact(fit.Model, mode, fit.Input));
}

// Only a sphere can touch it. The degree of a model is its own.
std::vector<ContactSetting> Vary(ContactSetting standard, const TouchToolSettings& tool,
                                 int highestDegree)
{
  if (tool.Kind != TouchToolSettings::Shape::Sphere)
  {
    return {};
  }
  SceneStructure& structure = standard.Structure;
  std::vector<ContactSetting> settings;
  if (structure.Source() == SceneSource::Label)
  {
    structure.Degree = std::min(structure.Degree, highestDegree);
    settings.push_back(standard);
    for (const int degree : {4, 8, 12, 16, 24, 32})
    {
      settings.push_back(standard);
      settings.back().Structure.Degree = std::min(degree, highestDegree);
    }
  }
  settings.push_back(standard);
  for (const HarmonicContactMode mode : {HarmonicContactMode::Nearest, HarmonicContactMode::Radial})
  {
    settings.push_back(standard);
    settings.back().Structure.Mode = mode;
  }
  return Unique(settings);
}

// A model has its own degree.
std::string DegreeText(const ContactSetting& setting, const std::string& before)
{
  const bool isModel = setting.Structure.Source() == SceneSource::Model;
  return isModel ? std::string() : before + std::to_string(setting.Structure.Degree);
}

bool IsNearest(const ContactSetting& setting)
{
  return setting.Structure.Mode == HarmonicContactMode::Nearest;
}
} // namespace

void PlanHarmonicContact(StructurePlan& plan)
{
  const HarmonicContactMode mode = plan.Settings().Mode;
  plan.AddContact(SceneKey("harmonics", static_cast<int>(mode)), plan.AddModel(),
                  [mode](const StructurePlan::Inputs& inputs, const ProgressFunction&)
                  { return MakeContact(*ProductAs<FitResult>(inputs.data()), mode); });
}

SceneRepresentation HarmonicRepresentation()
{
  SceneRepresentation harmonics;
  harmonics.Name = harmonics.Label = TouchRepresentation::Harmonics;
  harmonics.Sources = {SceneSource::Label, SceneSource::Model};
  harmonics.Appearance = SceneAppearance::Model;
  harmonics.PlanContact = PlanHarmonicContact;
  harmonics.PlanDisplay = [](StructurePlan& plan) { plan.AddModel(); };
  harmonics.Describe = [](const ContactSetting& setting)
  {
    return "harmonics" + DegreeText(setting, " of degree ") +
           (IsNearest(setting) ? ", nearest point" : ", radial");
  };
  harmonics.KeyOf = [](const ContactSetting& setting) {
    return "harmonics" + DegreeText(setting, "/") + (IsNearest(setting) ? "/nearest" : "/radial");
  };
  harmonics.Vary = Vary;
  return harmonics;
}
} // namespace palpate
