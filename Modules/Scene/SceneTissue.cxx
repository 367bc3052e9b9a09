#include "SceneTissue.h"

#include "PatientSides.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr double MostKilopascal = 1e6; // TissueMap::MostModulus

std::vector<std::string> SideWords()
{
  std::vector<std::string> words{"none"};
  for (const PatientSide& side : PatientSides())
  {
    words.emplace_back(side.Name);
  }
  return words;
}

// A structure's number instead of a default, unless it is 0.
void Take(const SceneStructure& structure, const char* key, double& value)
{
  const double number = structure.Number(key);
  value = number != 0.0 ? number : value;
}
} // namespace

std::vector<SceneNumber> TissueNumbers()
{
  constexpr const char* Computation = "Computation";
  return {{TissueKey::Modulus,
           "Young's modulus",
           MostKilopascal,
           3,
           {},
           0.0,
           "kPa",
           "20 kPa (default)"},
          {TissueKey::PoissonRatio,
           "Poisson's ratio",
           ElasticSolid::MostPoissonRatio,
           4,
           {},
           0.0,
           "",
           "0.49 (default)"},
          {TissueKey::Support,
           "Stiffness of the support",
           SofteningSettings::MostSupport,
           3,
           {},
           0.0,
           "kPa/mm",
           "1 kPa/mm (default)"},
          {TissueKey::FreeSide, "Side without support", 0.0, 0, SideWords()},
          {TissueKey::FreeDegrees,
           "Half the angle of that side",
           SofteningSettings::MostFreeDegrees,
           1,
           {},
           0.0,
           "\u00b0",
           "60\u00b0 (default)"},
          {TissueKey::Exaggeration,
           "Exaggeration of contrasts",
           TissueMap::MostExaggeration,
           2,
           {},
           0.0,
           "",
           "1 (default)",
           Computation},
          {TissueKey::Elements,
           "Finite elements across",
           1.0 * SofteningSettings::MostElements,
           0,
           {},
           0.0,
           "",
           "16 (default)",
           Computation},
          {TissueKey::ComplianceDegree,
           "Degree of the compliance",
           1.0 * ReducedCompliance::MostDegree,
           0,
           {},
           0.0,
           "",
           "as the surface needs",
           Computation},
          {TissueKey::MapDegree,
           "Degree of the maps",
           1.0 * ComplianceMaps::MostDegree,
           0,
           {},
           0.0,
           "",
           "20 (default)",
           Computation}};
}

std::vector<SceneNumber> SurroundingNumbers()
{
  return {{TissueKey::Inclusion,
           "As an inclusion of tissue",
           MostKilopascal,
           3,
           {},
           0.0,
           "kPa",
           "no inclusion"},
          {TissueKey::Neighbour,
           "Holds tissue next to it",
           SofteningSettings::MostSupport,
           3,
           {},
           0.0,
           "kPa/mm",
           "does not"}};
}

std::vector<const SceneStructure*> SurroundingsOf(const SceneSettings& scene,
                                                  const SceneStructure& structure, const char* key)
{
  std::vector<const SceneStructure*> surroundings;
  for (const SceneStructure& one : scene.Structures)
  {
    if (one.Id != structure.Id && one.Number(key) > 0.0 && one.Source() == SceneSource::Label)
    {
      surroundings.push_back(&one);
    }
  }
  return surroundings;
}

SofteningSettings SofteningSettingsOf(const SceneStructure& structure)
{
  SofteningSettings settings;
  Take(structure, TissueKey::Modulus, settings.TissueKilopascal);
  Take(structure, TissueKey::PoissonRatio, settings.PoissonRatio);
  Take(structure, TissueKey::Support, settings.BedPerMillimeter);
  Take(structure, TissueKey::FreeDegrees, settings.FreeDegrees);
  Take(structure, TissueKey::Exaggeration, settings.Exaggeration);
  const auto side = static_cast<std::size_t>(structure.Number(TissueKey::FreeSide));
  if (side > 0 && side <= PatientSides().size())
  {
    settings.FreeSides.push_back(PatientSides()[side - 1].World);
  }
  double elements = settings.Numbers.ElementsAcross;
  Take(structure, TissueKey::Elements, elements);
  settings.Numbers.ElementsAcross = static_cast<int>(elements);
  settings.Numbers.Degree = static_cast<int>(structure.Number(TissueKey::ComplianceDegree));
  // Lower degrees are parts of the usual maps, so that choosing one does not soften again.
  settings.Numbers.Maps.Degree = std::max(settings.Numbers.Maps.Degree,
                                          static_cast<int>(structure.Number(TissueKey::MapDegree)));
  return settings;
}
} // namespace palpate
