#include "CohortTable.h"

#include "CaseText.h"
#include "CsvText.h"
#include "DecimalText.h"
#include "FitSettingsText.h"
#include "InputError.h"
#include "InputKey.h"
#include "ModelConvention.h"
#include "ModelMeasures.h"
#include "WholeFile.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <system_error>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::uintmax_t LargestTable = 1U << 26U; // of some hundred thousand structures
const std::vector<std::string> Head{
    "case",        "label",       "structure",   "outcome", "sentence", "degree",
    "center_x_mm", "center_y_mm", "center_z_mm", "mask_ml", "model_ml", "area_mm2",
    "mean_mm",     "rms_mm",      "p95_mm",      "max_mm",  "dice",     "hidden_percent",
    "seconds",     "mask",        "model",       "key"};
constexpr std::array<FitResult::Outcome, 4> Outcomes{
    {FitResult::Outcome::Fitted, FitResult::Outcome::Refused, FitResult::Outcome::BadInput,
     FitResult::Outcome::Failed}};

double TotalSeconds(const FitResult& result)
{
  return result.Seconds.empty() ? 0.0 : result.Seconds.back().second;
}

std::vector<std::string> FieldsOf(const CohortRow& row)
{
  const FitResult& result = row.Result;
  const bool fitted = result.State == FitResult::Outcome::Fitted;
  const auto number = [](bool known, double value) { return known ? ExactText(value) : ""; };
  const Vector3& center = row.CenterWorld;
  return {row.Case,
          result.Structure.Label == 0 ? "" : std::to_string(result.Structure.Label),
          result.Structure.Name,
          TextOf(result.State).Word,
          result.Message,
          fitted ? std::to_string(row.Degree) : "",
          number(fitted, center.x()),
          number(fitted, center.y()),
          number(fitted, center.z()),
          number(result.MaskMilliliters > 0.0, result.MaskMilliliters),
          number(fitted, result.ModelMilliliters),
          number(fitted, result.ModelAreaSquareMillimeters),
          number(fitted, result.ModelToMask.Mean),
          number(fitted, result.ModelToMask.Rms),
          number(fitted, result.ModelToMask.Percentile95),
          number(fitted, result.ModelToMask.Maximum),
          number(fitted, result.Dice),
          number(fitted, result.HiddenPercent),
          number(true, TotalSeconds(result)),
          result.Input.generic_string(),
          row.Model.generic_string(),
          row.Key};
}

/// Parses one record; throws InputError with the file's name.
class RowReader
{
public:
  RowReader(const CsvRecord& record, const std::filesystem::path& file) : Record(record), File(file)
  {
  }

  CohortRow Row() const
  {
    CohortRow row;
    row.Case = this->Text("case");
    row.Model = this->Text("model");
    row.Key = this->Text("key");
    FitResult& result = row.Result;
    result.Input = this->Text("mask");
    result.CaseName = row.Case;
    result.Structure.Label = ParseInteger(this->Text("label")).value_or(0);
    result.Structure.Name = this->Text("structure");
    result.State = this->Outcome();
    result.Message = this->Text("sentence");
    result.MaskMilliliters = this->Number("mask_ml", false);
    result.Seconds = {{"total", this->Number("seconds", false)}};
    if (result.State == FitResult::Outcome::Fitted)
    {
      row.Degree = this->Degree();
      row.CenterWorld =
          Vector3(this->Number("center_x_mm", true), this->Number("center_y_mm", true),
                  this->Number("center_z_mm", true));
      this->TakeQuality(result);
    }
    return row;
  }

private:
  const std::string& Text(const char* column) const
  {
    const std::string* found = this->Record.Find(column);
    if (found == nullptr)
    {
      throw InputError(this->File.string() + " is not a cohort table: it has no column " + column +
                       "; specify the folder that `palpate fit` wrote");
    }
    return *found;
  }
  double Number(const char* column, bool isNeeded) const
  {
    const auto number = ParseNumber(this->Text(column));
    if (isNeeded && !number)
    {
      throw InputError(this->File.string() + ": " + column + " of case " + this->Text("case") +
                       " is not a number; remove the file and fit again");
    }
    return number.value_or(0.0);
  }
  FitResult::Outcome Outcome() const
  {
    const auto* const found = std::find_if(
        Outcomes.begin(), Outcomes.end(),
        [&](FitResult::Outcome outcome) { return TextOf(outcome).Word == this->Text("outcome"); });
    if (found == Outcomes.end())
    {
      throw InputError(this->File.string() + ": the outcome \"" + this->Text("outcome") +
                       "\" is unknown; remove the file and fit again");
    }
    return *found;
  }
  int Degree() const
  {
    const auto degree = ParseInteger(this->Text("degree"));
    if (!degree || *degree < 0 || *degree > ModelConvention::MaximumDegree)
    {
      throw InputError(this->File.string() + ": degree of case " + this->Text("case") +
                       " is not a whole number from 0 to " +
                       std::to_string(ModelConvention::MaximumDegree) +
                       "; remove the file and fit again");
    }
    return *degree;
  }
  void TakeQuality(FitResult& result) const
  {
    result.ModelMilliliters = this->Number("model_ml", true);
    result.ModelAreaSquareMillimeters = this->Number("area_mm2", true);
    result.ModelToMask = {this->Number("mean_mm", true), this->Number("rms_mm", true),
                          this->Number("p95_mm", true), this->Number("max_mm", true)};
    result.Dice = this->Number("dice", true);
    result.HiddenPercent = this->Number("hidden_percent", true);
  }

  const CsvRecord& Record;
  const std::filesystem::path& File;
};
} // namespace

CohortRow RowOf(const std::string& name, FitResult result)
{
  result.Mask = nullptr;
  result.Surface = nullptr;
  result.ModelSurface = nullptr;
  CohortRow row;
  row.Case = name;
  row.Degree = DegreeOf(result.Model);
  row.CenterWorld = CenterOf(result.Model);
  result.Model = {};
  if (result.IsOfSurface)
  {
    result.Structure = {}; // its name is the file's, and would differ from case to case
  }
  row.Result = std::move(result);
  return row;
}

std::string CohortKey(const std::filesystem::path& mask, const std::filesystem::path& volume,
                      const std::vector<std::string>& labels, const FitSettings& settings,
                      const std::string& program)
{
  std::vector<std::string> words{std::to_string(labels.size())};
  words.insert(words.end(), labels.begin(), labels.end());
  for (const auto& [name, value] : DescribeSettings(settings))
  {
    words.push_back(name);
    words.push_back(value);
  }
  words.push_back(program);
  return KeyOfInputs({mask, volume}, words);
}

CohortTable CohortTable::Read(const std::filesystem::path& file)
{
  CohortTable table;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
  {
    return table;
  }
  ForEachCsvRecord(ReadWholeFile(file, LargestTable), [&](const CsvRecord& record)
                   { table.Content.push_back(RowReader(record, file).Row()); });
  return table;
}

void CohortTable::Write(const std::filesystem::path& file) const
{
  std::string text = CsvLine(Head);
  for (const CohortRow& row : this->Content)
  {
    text += CsvLine(FieldsOf(row));
  }
  WriteWholeFile(file, text);
}

void CohortTable::Add(const std::vector<CohortRow>& rows)
{
  this->Content.insert(this->Content.end(), rows.begin(), rows.end());
}
} // namespace palpate
