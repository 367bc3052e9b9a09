#include "ModelCsv.h"

#include "DecimalText.h"
#include "ModelConvention.h"
#include "Refusal.h"
#include "SphericalHarmonicBasis.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr const char* RadialTitle = "l,m,coefficient_mm";
constexpr const char* SurfaceTitle = "l,m,x_mm,y_mm,z_mm";

using Columns = std::vector<std::vector<double>>; // one for each coordinate

// The entries that are the same in every file, as name and value.
std::vector<std::pair<std::string, std::string>> Statements()
{
  return {
      {"format", ModelConvention::Format}, {"version", std::to_string(ModelConvention::Version)},
      {"basis", ModelConvention::Basis},   {"normalization", ModelConvention::Normalization},
      {"phase", ModelConvention::Phase},   {"polar_axis", ModelConvention::PolarAxis},
      {"signs", ModelConvention::Signs},   {"frame", ModelConvention::Frame},
      {"unit", ModelConvention::Unit}};
}

// A name with a line break in it must not become a line of its own, nor one with a comma, at which
// spreadsheets split comments too, a cell of its own.
std::string InOneCell(std::string text)
{
  std::replace_if(
      text.begin(), text.end(),
      [](char c) { return std::string_view("\n\r\t,;").find(c) != std::string_view::npos; }, ' ');
  return text;
}

void AddComment(std::string& text, const std::string& name, const std::string& value)
{
  if (!value.empty())
  {
    text += "# " + InOneCell(name) + ": " + InOneCell(value) + "\n";
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
    AddComment(text, "setting " + name, value);
  }
}

std::string FiniteText(double value, const std::string& fileName)
{
  if (!std::isfinite(value))
  {
    Refuse(fileName, "cannot be written: a coefficient is not a finite number",
           "fit the model again");
  }
  return ExactText(value);
}

Columns ColumnsOf(const RadialModel& model)
{
  return {model.Coefficients()};
}
Columns ColumnsOf(const SurfaceModel& surface)
{
  return {surface.Coefficients(0), surface.Coefficients(1), surface.Coefficients(2)};
}
} // namespace

std::string ModelToCsv(const ModelDocument& document, const std::string& fileName)
{
  const auto* model = std::get_if<RadialModel>(&document.Surface);
  const int degree = std::visit([](const auto& s) { return s.Degree(); }, document.Surface);
  const Columns columns = std::visit([](const auto& s) { return ColumnsOf(s); }, document.Surface);
  std::string text;
  for (const auto& [name, value] : Statements())
  {
    text += "# " + name + ": " + value + "\n";
  }
  AddComment(text, "model", model != nullptr ? ModelConvention::Radial : ModelConvention::Surface);
  AddComment(text, "degree", std::to_string(degree));
  if (model != nullptr)
  {
    const Vector3& center = model->CenterWorld();
    AddComment(text, "center_mm",
               FiniteText(center.x(), fileName) + " " + FiniteText(center.y(), fileName) + " " +
                   FiniteText(center.z(), fileName));
  }
  AddProvenance(text, document.Provenance);
  text += std::string(model != nullptr ? RadialTitle : SurfaceTitle) + "\n";
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
} // namespace palpate
