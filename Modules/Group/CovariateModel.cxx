#include "CovariateModel.h"

#include "CohortEffectFiles.h"
#include "CovariateFile.h"
#include "DecimalText.h"
#include "InputError.h"
#include "RepeatedScans.h"
#include "VarianceInflation.h"

#include <cmath>
#include <map>

namespace palpate
{
namespace
{
CovariateTable TableOf(const CohortGroup& group, const CovariateRequest& request,
                       std::vector<std::string>& notes)
{
  std::vector<std::string> cases;
  std::vector<std::string> volumes;
  std::vector<std::string> areas;
  for (std::size_t i = 0; i < group.Rows.size(); ++i)
  {
    cases.push_back(group.Rows[i].Case);
    volumes.push_back(ExactText(group.Bodies[i].Volume / 1000.0));
    areas.push_back(ExactText(group.Rows[i].Result.ModelAreaSquareMillimeters));
  }
  CovariateTable table = request.File.empty()
                             ? CovariateTable(cases)
                             : ReadCovariates(request.File, request.Id, cases, notes);
  table.Add("volume_ml", volumes);
  table.Add("area_mm2", areas);
  return table;
}
void NoteMissingCodes(const CovariateTable& table, const ModelFormula& formula,
                      std::vector<std::string>& notes)
{
  for (const std::string& name : formula.Columns())
  {
    const Covariate* column = table.Find(name);
    const double code = column == nullptr ? NAN : column->LikelyMissingCode();
    if (!std::isnan(code))
    {
      notes.push_back(name + " is " + SignificantText(code, 6) +
                      " in some cases, which looks like a code for a missing value and was taken "
                      "for a number; if it is one, leave these cells empty");
    }
  }
}
} // namespace

CovariateModel::CovariateModel(const CohortGroup& group, const CovariateRequest& request,
                               std::vector<std::string>& notes, const KernelProgress& progress)
    : Patient(request.Patient), Table({})
{
  if (request.Formula.empty())
  {
    if (!request.File.empty() || !request.Patient.empty())
    {
      throw InputError("covariates need a formula, such as \"~ age\"");
    }
    return;
  }
  if (const Status status = ModelFormula::Parse(request.Formula, this->Formula); !status.IsOk())
  {
    throw InputError(status.Message());
  }
  this->Table = TableOf(group, request, notes);
  NoteMissingCodes(this->Table, this->Formula, notes);
  if (!this->Patient.empty())
  {
    notes.push_back("repeated.R fits the model with a random intercept per " + this->Patient +
                    "; tests here would take the cases of a patient for independent ones and are "
                    "left out");
    return;
  }
  std::map<std::string, std::string> references;
  if (const Status status = ParseReferences(request.References, references); !status.IsOk())
  {
    throw InputError(status.Message());
  }
  this->Tested =
      FindCohortEffects(group, this->Table, this->Formula, references, request.Effects, progress);
  const LinearDesign& design = this->Tested->Design;
  const std::vector<std::string> inflated = InflationNotes(design);
  notes.insert(notes.end(), inflated.begin(), inflated.end());
  if (!design.Omitted.empty())
  {
    notes.push_back(design.OmissionText() + "; the first is " +
                    group.Rows[design.Omitted.front()].Case);
  }
}

void CovariateModel::WriteRepeated(const CohortGroup& group,
                                   const std::filesystem::path& folder) const
{
  if (!this->Patient.empty())
  {
    WriteRepeatedScans(group, this->Table, this->Formula, this->Patient, folder);
  }
}
} // namespace palpate
