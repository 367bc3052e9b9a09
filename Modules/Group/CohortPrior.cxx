#include "CohortPrior.h"

#include "InputError.h"
#include "Refusal.h"
#include "ShapePriorFile.h"

namespace palpate
{
void WriteCohortPrior(CohortGroup& group, const std::filesystem::path& file)
{
  if (group.Axes != AlignmentAxes::Patient)
  {
    throw InputError("--prior is made in the patients' axes; leave out --align");
  }
  std::vector<RadialModel> models;
  for (const OrganModel& model : group.Models)
  {
    if (!std::holds_alternative<RadialModel>(model))
    {
      throw InputError("--prior needs radial models; fit the cases with --model radial");
    }
    models.push_back(std::get<RadialModel>(model));
  }
  ShapePrior prior;
  std::vector<std::size_t> omitted;
  RequireInput(ShapePrior::OfGroup(models, prior, omitted));
  for (const std::size_t row : omitted)
  {
    group.Notes.push_back(
        {group.Rows[row].Case, " is not part of the prior, since its model reaches its centre"});
  }
  WriteShapePrior(prior, file);
}
} // namespace palpate
