#include "SceneRepresentation.h"

#include "BuiltInRepresentations.h"
#include "ElasticRepresentation.h"
#include "InputError.h"
#include "KindRegistration.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
std::deque<SceneRepresentation>& All()
{
  static std::deque<SceneRepresentation> all{AutomaticRepresentation(),    ModelRepresentation(),
                                             FacetRepresentation(),        FieldRepresentation(),
                                             ModelOrFieldRepresentation(), ElasticRepresentation()};
  return all;
}
} // namespace

bool SceneRepresentation::Takes(SceneSource source) const
{
  return std::find(this->Sources.begin(), this->Sources.end(), source) != this->Sources.end();
}

const std::deque<SceneRepresentation>& SceneRepresentations()
{
  return All();
}

void AddSceneRepresentation(SceneRepresentation representation)
{
  AddOrReplace(All(), std::move(representation));
}

const SceneRepresentation& RepresentationOf(const SceneStructure& structure)
{
  const auto found = std::find_if(All().begin(), All().end(),
                                  [&structure](const SceneRepresentation& one)
                                  { return one.Name == structure.Representation; });
  if (found == All().end())
  {
    throw InputError("There is no representation named " + structure.Representation);
  }
  return *found;
}

std::vector<ContactSetting> Unique(const std::vector<ContactSetting>& settings)
{
  std::vector<ContactSetting> unique;
  for (const ContactSetting& setting : settings)
  {
    if (std::find(unique.begin(), unique.end(), setting) == unique.end())
    {
      unique.push_back(setting);
    }
  }
  return unique;
}
} // namespace palpate
