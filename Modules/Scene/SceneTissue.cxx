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
  return {{TissueKey::Modulus, "Young's modulus, kPa (0: 20)", MostKilopascal, 3},
          {TissueKey::PoissonRatio, "Poisson's ratio (0: 0.49)", ElasticSolid::MostPoissonRatio, 4},
          {TissueKey::Support, "Stiffness of the support, kPa/mm (0: 1)",
           SofteningSettings::MostSupport, 3},
          {TissueKey::FreeSide, "Side without support", 0.0, 0, SideWords()},
          {TissueKey::FreeDegrees, "Half the angle of that side, degrees (0: 60)",
           SofteningSettings::MostFreeDegrees, 1},
          {TissueKey::Exaggeration, "Power of contrasts, exaggerated above 1 (0: 1)",
           TissueMap::MostExaggeration, 2},
          {TissueKey::Elements, "Finite elements across (0: 16)",
           1.0 * SofteningSettings::MostElements, 0},
          {TissueKey::ComplianceDegree,
           "Degree of the elements' compliance (0: as the surface needs)",
           1.0 * ReducedCompliance::MostDegree, 0},
          {TissueKey::MapDegree, "Degree of the maps that are felt (0: 20)",
           1.0 * ComplianceMaps::MostDegree, 0}};
}

std::vector<SceneNumber> SurroundingNumbers()
{
  return {{TissueKey::Inclusion, "As an inclusion of tissue, kPa (0: none)", MostKilopascal, 3},
          {TissueKey::Neighbour, "Holds tissue next to it, kPa/mm (0: does not)",
           SofteningSettings::MostSupport, 3}};
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
