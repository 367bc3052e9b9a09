#include "TradeSetting.h"

#include "TradeRow.h"

namespace palpate
{
namespace
{
bool IsElastic(const SceneStructure& structure)
{
  return structure.Representation == TouchRepresentation::Elastic;
}
} // namespace

std::string Describe(const ContactSetting& setting)
{
  const SceneRepresentation& representation = RepresentationOf(setting.Structure);
  return representation.Describe ? representation.Describe(setting) : representation.Label;
}

std::string Describe(const TradeRow& row)
{
  return (row.Yields && !IsElastic(row.Setting.Structure) ? "rigid, " : "") + Describe(row.Setting);
}

std::string KeyOf(const ContactSetting& setting)
{
  const SceneRepresentation& representation = RepresentationOf(setting.Structure);
  return representation.KeyOf ? representation.KeyOf(setting) : representation.Name;
}

ContactSetting SettingOf(const SceneSettings& scene, const std::string& representation)
{
  ContactSetting setting{scene.Structures.front(), scene.Tool.Points};
  setting.Structure.Representation = representation;
  return setting;
}

SceneSettings WithSetting(SceneSettings scene, const ContactSetting& setting)
{
  scene.Structures.front() = setting.Structure;
  scene.Tool.Points = setting.ToolPoints;
  return scene;
}

std::vector<ContactSetting> CandidatesFor(const SceneSettings& scene, int highestDegree)
{
  const SceneSource source = scene.Structures.front().Source();
  const bool yields = IsElastic(scene.Structures.front());
  std::vector<ContactSetting> candidates;
  for (const SceneRepresentation& representation : SceneRepresentations())
  {
    const bool isMeant = (representation.Name == TouchRepresentation::Elastic) == yields;
    if (isMeant && representation.Vary && representation.Takes(source))
    {
      const std::vector<ContactSetting> varied =
          representation.Vary(SettingOf(scene, representation.Name), scene.Tool, highestDegree);
      candidates.insert(candidates.end(), varied.begin(), varied.end());
    }
  }
  if (yields && !candidates.empty())
  {
    candidates.push_back(SettingOf(scene, TouchRepresentation::Harmonics));
    candidates.back().Structure.Mode = RadialContactMode::Nearest;
  }
  return candidates;
}
} // namespace palpate
