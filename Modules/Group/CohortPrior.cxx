#include "CohortPrior.h"

#include "InputError.h"
#include "ModelFile.h"
#include "Refusal.h"
#include "ShapePriorFile.h"

#include <algorithm>
#include <string>
#include <utility>

namespace palpate
{
namespace
{
ShapePrior RadialPriorOf(CohortGroup& group)
{
  std::vector<RadialModel> models;
  for (const OrganModel& model : group.Models)
  {
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
  return prior;
}

// The name of the known organ, or its label's number, if all have the same one.
std::string NameOf(const CohortTable& known)
{
  const auto called = [](const CohortRow& row)
  {
    const Segment& structure = row.Result.Structure;
    return structure.Name.empty() ? std::to_string(structure.Label) : structure.Name;
  };
  const std::vector<CohortRow>& rows = known.Rows();
  const std::string name = rows.empty() ? std::string() : called(rows.front());
  const bool isCommon = name.size() <= OrganRelation::LongestName &&
                        std::all_of(rows.begin(), rows.end(),
                                    [&](const CohortRow& row) { return called(row) == name; });
  return isCommon ? name : std::string();
}

// The known organ of a case; none, and a reason, if it has no usable model.
std::optional<LogSurface> KnownOf(const std::string& name, const CohortTable& known,
                                  const std::filesystem::path& folder, std::string& reason)
{
  const auto found = std::find_if(known.Rows().begin(), known.Rows().end(),
                                  [&name](const CohortRow& row)
                                  { return row.Case == name && !row.Model.empty(); });
  if (found == known.Rows().end())
  {
    reason = "it has no model";
    return std::nullopt;
  }
  LogSurface made;
  const Status status = FindLogSurface(ReadModel(folder / found->Model).Surface, made);
  reason = status.Message();
  return status.IsOk() ? std::optional<LogSurface>(made) : std::nullopt;
}

SurfacePrior SurfacePriorOf(CohortGroup& group, const CohortTable& known,
                            const std::filesystem::path& folder)
{
  std::vector<SurfacePrior::Case> cases;
  for (std::size_t row = 0; row < group.Models.size(); ++row)
  {
    SurfacePrior::Case one{std::get<SurfaceModel>(group.Models[row]),
                           group.Bodies[row].CentroidWorld, std::nullopt};
    std::string reason;
    if (!known.Rows().empty())
    {
      one.Known = KnownOf(group.Rows[row].Case, known, folder, reason);
    }
    if (reason.empty())
    {
      cases.push_back(std::move(one));
    }
    else
    {
      group.Notes.push_back(
          {group.Rows[row].Case, " is not part of the prior: of the known organ, " + reason});
    }
  }
  SurfacePrior prior;
  RequireInput(SurfacePrior::OfGroup(cases, prior));
  if (prior.Relation)
  {
    prior.Relation->Name = NameOf(known);
  }
  return prior;
}
} // namespace

void WriteCohortPrior(CohortGroup& group, const CohortTable& known,
                      const std::filesystem::path& knownFolder, const std::filesystem::path& file)
{
  if (group.Axes != AlignmentAxes::Patient)
  {
    throw InputError("--prior is made in the patients' axes; leave out --align");
  }
  if (std::holds_alternative<SurfaceModel>(group.Models.front()))
  {
    WriteShapePrior(SurfacePriorOf(group, known, knownFolder), file);
    return;
  }
  if (!known.Rows().empty())
  {
    throw InputError("--known needs surface models; fit the cases with --model surface");
  }
  WriteShapePrior(RadialPriorOf(group), file);
}
} // namespace palpate
