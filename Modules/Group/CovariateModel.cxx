#include "CovariateModel.h"

#include "CohortEffectFiles.h"
#include "CovariateFile.h"
#include "DecimalText.h"
#include "InputError.h"
#include "VarianceInflation.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace palpate
{
namespace
{
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

// Without one, an empty formula.
ModelFormula FormulaOf(const CovariateRequest& request)
{
  ModelFormula formula;
  const RepeatedColumns& repeated = request.Repeated;
  if (!repeated.Time.empty() && repeated.Patient.empty())
  {
    throw InputError("a time needs a column of patients with several cases (--repeated)");
  }
  const auto parse = [&](const std::string& text)
  {
    if (const Status status = ModelFormula::Parse(text, formula); !status.IsOk())
    {
      throw InputError(status.Message());
    }
  };
  if (!request.Formula.empty())
  {
    parse(request.Formula);
  }
  const std::vector<std::string> columns = formula.Columns();
  if (!repeated.Time.empty() &&
      std::find(columns.begin(), columns.end(), repeated.Time) == columns.end())
  {
    parse((request.Formula.empty() ? "~" : request.Formula + " +") + " `" + repeated.Time + "`");
  }
  return formula;
}
} // namespace

CovariateTable CovariatesOf(const CohortGroup& group, const CovariateRequest& request,
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

CovariateModel::CovariateModel(const CohortGroup& group, const CovariateRequest& request,
                               std::vector<std::string>& notes, const KernelProgress& progress)
{
  const ModelFormula formula = FormulaOf(request);
  if (formula.Terms().empty())
  {
    if ((!request.File.empty() && !request.IsForSides) || !request.Repeated.Patient.empty())
    {
      throw InputError("covariates need a formula, such as \"~ age\"");
    }
    return;
  }
  const CovariateTable table = CovariatesOf(group, request, notes);
  NoteMissingCodes(table, formula, notes);
  std::map<std::string, std::string> references;
  if (const Status status = ParseReferences(request.References, references); !status.IsOk())
  {
    throw InputError(status.Message());
  }
  if (request.Repeated.Patient.empty())
  {
    this->Tested = FindCohortEffects(group, table, formula, references, request.Effects, progress);
  }
  else if (request.Effects.BeyondModes > 0)
  {
    throw InputError("tests beyond modes are not for patients with several cases");
  }
  else
  {
    this->Mixed =
        FindRepeatedEffects(group, table, formula, references, request.Repeated, notes, progress);
  }
  const LinearDesign& design = this->Tested ? this->Tested->Design : this->Mixed->Design;
  const std::vector<std::string> inflated = InflationNotes(design);
  notes.insert(notes.end(), inflated.begin(), inflated.end());
  if (!design.Omitted.empty())
  {
    notes.push_back(design.OmissionText() + "; the first is " +
                    group.Rows[design.Omitted.front()].Case);
  }
}
} // namespace palpate
