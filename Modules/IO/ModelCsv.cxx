#include "ModelCsv.h"

#include "CsvCell.h"
#include "DecimalText.h"
#include "ModelConvention.h"
#include "Refusal.h"
#include "SphericalHarmonicBasis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

namespace palpate
{
namespace
{
constexpr const char* StarShapedTitle = "l,m,coefficient_mm";
constexpr const char* ParametricTitle = "l,m,x_mm,y_mm,z_mm";
const std::string SettingPrefix = "setting ";

using Columns = std::vector<std::vector<double>>; // one for each coordinate

// What every file states in the same words, as name and value.
std::vector<std::pair<std::string, std::string>> Statements()
{
  return {
      {"format", ModelConvention::Format}, {"version", std::to_string(ModelConvention::Version)},
      {"basis", ModelConvention::Basis},   {"normalization", ModelConvention::Normalization},
      {"phase", ModelConvention::Phase},   {"polar_axis", ModelConvention::PolarAxis},
      {"signs", ModelConvention::Signs},   {"frame", ModelConvention::Frame},
      {"unit", ModelConvention::Unit}};
}

// A name with a line break in it must not become a line of its own.
std::string OnOneLine(std::string text)
{
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

// A spreadsheet takes a comment apart at commas, and what comes then for cells.
std::string AfterEachComma(const std::string& text, std::string (*change)(const std::string&))
{
  std::size_t end = std::min(text.find_first_of(",;\t"), text.size());
  std::string changed = text.substr(0, end);
  while (end < text.size())
  {
    const std::size_t start = end + 1;
    end = std::min(text.find_first_of(",;\t", start), text.size());
    changed += text[start - 1] + change(text.substr(start, end - start));
  }
  return changed;
}

void AddComment(std::string& text, const std::string& name, const std::string& value)
{
  if (!value.empty())
  {
    text += AfterEachComma("# " + OnOneLine(name) + ": " + OnOneLine(value), InertCell) + "\n";
  }
}

void AddProvenance(std::string& text, const ModelProvenance& provenance)
{
  AddComment(text, "program", provenance.Program);
  AddComment(text, "input", provenance.Input);
  AddComment(text, "label", provenance.Label);
  AddComment(text, "date", provenance.Date);
  for (const auto& [name, value] : provenance.Settings)
  {
    AddComment(text, SettingPrefix + name, value);
  }
}

std::string FiniteText(double value, const std::string& fileName)
{
  if (!std::isfinite(value))
  {
    Refuse(fileName, "cannot be written: a coefficient is no finite number", "fit the model again");
  }
  return ExactText(value);
}

Columns ColumnsOf(const SphericalHarmonicModel& model)
{
  return {model.Coefficients()};
}
Columns ColumnsOf(const ParametricSphericalSurface& surface)
{
  return {surface.Coefficients(0), surface.Coefficients(1), surface.Coefficients(2)};
}

/// Takes a text apart; every member throws InputError with the file's name.
class Reader
{
public:
  Reader(const std::string& text, const std::string& name) : Text(text), FileName(name) {}

  ModelDocument Document()
  {
    std::string line;
    while (this->NextLine(line) && line.rfind('#', 0) == 0)
    {
      this->TakeComment(line);
    }
    this->CheckStatements();
    const bool starShaped = this->StarShaped();
    if (line != (starShaped ? StarShapedTitle : ParametricTitle))
    {
      this->Refuse("line " + std::to_string(this->Line) + " is not the title " +
                   (starShaped ? StarShapedTitle : ParametricTitle));
    }
    const int degree = this->Degree();
    Columns columns = this->ReadRows(degree, starShaped ? 1 : 3);
    if (starShaped)
    {
      return {SphericalHarmonicModel(degree, std::move(columns[0]), this->Center()),
              std::move(this->Provenance)};
    }
    return {ParametricSphericalSurface(degree, {columns[0], columns[1], columns[2]}),
            std::move(this->Provenance)};
  }

private:
  [[noreturn]] void Refuse(const std::string& fact) const
  {
    palpate::Refuse(this->FileName, "is no model that Palpate reads: " + fact,
                    "write it again with palpate");
  }

  // The next line that is not empty.
  bool NextLine(std::string& line)
  {
    while (std::getline(this->Text, line))
    {
      ++this->Line;
      if (!line.empty() && line.back() == '\r')
      {
        line.pop_back();
      }
      if (!line.empty())
      {
        return true;
      }
    }
    line.clear();
    return false;
  }

  void TakeComment(const std::string& line)
  {
    const std::size_t colon = line.find(": ");
    if (line.rfind("# ", 0) != 0 || colon == std::string::npos)
    {
      return;
    }
    const std::string name = AfterEachComma(line.substr(2, colon - 2), TextOfCell);
    const std::string value = AfterEachComma(line.substr(colon + 2), TextOfCell);
    if (name.rfind(SettingPrefix, 0) == 0)
    {
      this->Provenance.Settings.emplace_back(name.substr(SettingPrefix.size()), value);
    }
    this->Comments[name] = value;
  }

  const std::string& Comment(const std::string& name) const
  {
    const auto found = this->Comments.find(name);
    if (found == this->Comments.end())
    {
      this->Refuse("its comment line \"# " + name + ": ...\" is missing");
    }
    return found->second;
  }

  void CheckStatements()
  {
    for (const auto& [name, expected] : Statements())
    {
      const std::string& found = this->Comment(name);
      if (found != expected)
      {
        palpate::Refuse(this->FileName,
                        "states \"" + name + ": " + found + "\", and Palpate reads \"" + expected +
                            "\"",
                        "convert its coefficients first");
      }
    }
    this->Provenance.Program = this->Comments["program"];
    this->Provenance.Input = this->Comments["input"];
    this->Provenance.Label = this->Comments["label"];
    this->Provenance.Date = this->Comments["date"];
  }

  bool StarShaped() const
  {
    const std::string& kind = this->Comment("surface");
    if (kind != ModelConvention::StarShaped && kind != ModelConvention::Parametric)
    {
      this->Refuse("its surface is \"" + kind + "\", which this version of Palpate does not know");
    }
    return kind == ModelConvention::StarShaped;
  }

  int Degree() const
  {
    const std::optional<int> degree = ParseInteger(this->Comment("degree"));
    if (!degree || *degree < 0 || *degree > ModelConvention::MaximumDegree)
    {
      this->Refuse("its degree is no whole number from 0 to " +
                   std::to_string(ModelConvention::MaximumDegree));
    }
    return *degree;
  }

  Vector3 Center() const
  {
    std::istringstream words(this->Comment("center_mm"));
    Vector3 center;
    std::string word;
    for (int k = 0; k < 3; ++k)
    {
      const std::optional<double> value =
          words >> word ? ParseNumber(word) : std::optional<double>();
      if (!value)
      {
        this->Refuse("its center_mm is no three numbers");
      }
      center[k] = *value;
    }
    if (words >> word)
    {
      this->Refuse("its center_mm is more than three numbers");
    }
    return center;
  }

  Columns ReadRows(int degree, std::size_t columnCount)
  {
    const std::size_t count = SphericalHarmonicBasis::CoefficientCount(degree);
    Columns columns(columnCount, std::vector<double>(count));
    std::vector<bool> seen(count, false);
    std::size_t rows = 0;
    for (std::string line; this->NextLine(line); ++rows)
    {
      const std::vector<std::string> cells = Cells(line);
      const std::size_t index = this->RowIndex(cells, degree, columnCount);
      if (seen[index])
      {
        this->Refuse("line " + std::to_string(this->Line) + " repeats an l and m");
      }
      seen[index] = true;
      for (std::size_t k = 0; k < columnCount; ++k)
      {
        columns[k][index] = *ParseNumber(cells[k + 2]);
      }
    }
    if (rows != count)
    {
      this->Refuse("it has " + std::to_string(rows) + " coefficients, and its degree " +
                   std::to_string(degree) + " needs " + std::to_string(count));
    }
    return columns;
  }

  static std::vector<std::string> Cells(const std::string& line)
  {
    std::vector<std::string> cells;
    std::istringstream words(line);
    for (std::string cell; std::getline(words, cell, ',');)
    {
      cells.push_back(cell);
    }
    return cells;
  }

  std::size_t RowIndex(const std::vector<std::string>& cells, int degree,
                       std::size_t columnCount) const
  {
    const bool numbers =
        cells.size() == columnCount + 2 &&
        std::all_of(cells.begin() + 2, cells.end(), [](const auto& c) { return ParseNumber(c); });
    const std::optional<int> l = numbers ? ParseInteger(cells[0]) : std::nullopt;
    const std::optional<int> m = numbers ? ParseInteger(cells[1]) : std::nullopt;
    if (!l || !m || *l < 0 || *l > degree || *m < -*l || *m > *l)
    {
      this->Refuse("line " + std::to_string(this->Line) + " is no l, m and " +
                   std::to_string(columnCount) + " finite number(s) within its degree");
    }
    return SphericalHarmonicBasis::Index(*l, *m);
  }

  std::istringstream Text;
  const std::string& FileName;
  int Line = 0;
  std::map<std::string, std::string> Comments;
  ModelProvenance Provenance;
};
} // namespace

std::string ModelToCsv(const ModelDocument& document, const std::string& fileName)
{
  const auto* model = std::get_if<SphericalHarmonicModel>(&document.Surface);
  const int degree = std::visit([](const auto& s) { return s.Degree(); }, document.Surface);
  const Columns columns = std::visit([](const auto& s) { return ColumnsOf(s); }, document.Surface);
  std::string text;
  for (const auto& [name, value] : Statements())
  {
    AddComment(text, name, value);
  }
  AddComment(text, "surface",
             model != nullptr ? ModelConvention::StarShaped : ModelConvention::Parametric);
  AddComment(text, "degree", std::to_string(degree));
  if (model != nullptr)
  {
    const Vector3& center = model->CenterWorld();
    AddComment(text, "center_mm",
               FiniteText(center.x(), fileName) + " " + FiniteText(center.y(), fileName) + " " +
                   FiniteText(center.z(), fileName));
  }
  AddProvenance(text, document.Provenance);
  text += std::string(model != nullptr ? StarShapedTitle : ParametricTitle) + "\n";
  for (int l = 0; l <= degree; ++l)
  {
    for (int m = -l; m <= l; ++m)
    {
      text += std::to_string(l) + "," + std::to_string(m);
      for (const std::vector<double>& column : columns)
      {
        text += "," + FiniteText(column[SphericalHarmonicBasis::Index(l, m)], fileName);
      }
      text += "\n";
    }
  }
  return text;
}

ModelDocument ModelFromCsv(const std::string& text, const std::string& fileName)
{
  return Reader(text, fileName).Document();
}
} // namespace palpate
