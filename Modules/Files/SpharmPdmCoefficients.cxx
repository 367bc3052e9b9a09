#include "SpharmPdmCoefficients.h"

#include "DecimalText.h"
#include "ModelConvention.h"
#include "Refusal.h"
#include "SphericalHarmonicBasis.h"
#include "SphericalHarmonicConventions.h"

#include <array>
#include <cmath>
#include <string_view>

namespace palpate
{
namespace
{
// From patient LPS to RAS and back.
constexpr std::array<double, 3> FrameSigns{{-1.0, -1.0, 1.0}};

SurfaceModel AsSurfaceModel(const RadialModel& model)
{
  return SurfaceModel::FromModel(model);
}
const SurfaceModel& AsSurfaceModel(const SurfaceModel& surface)
{
  return surface;
}

void Flip(std::vector<double>& values, double sign)
{
  for (double& value : values)
  {
    value *= sign;
  }
}

/// Reads braces, commas and numbers, with any white space between them.
class CoefficientReader
{
public:
  CoefficientReader(std::string_view text, const std::string& name) : Rest(text), FileName(name) {}

  std::array<std::vector<double>, 3> Rows(int& degree)
  {
    this->Expect('{');
    const std::size_t count = this->Count(degree);
    std::array<std::vector<double>, 3> rows;
    for (std::size_t row = 0; row < count; ++row)
    {
      this->Expect(',');
      this->Expect('{');
      for (std::size_t k = 0; k < rows.size(); ++k)
      {
        rows[k].push_back(this->Number());
        if (k + 1 < rows.size())
        {
          this->Expect(',');
        }
      }
      this->Expect('}');
    }
    this->Take(','); // SPHARM-PDM ends the last row with a comma too
    this->Expect('}');
    this->SkipBlanks();
    if (!this->Rest.empty())
    {
      this->Refuse("there is text after its last brace");
    }
    return rows;
  }

private:
  [[noreturn]] void Refuse(const std::string& fact) const
  {
    palpate::Refuse(this->FileName, "is not an SPHARM-PDM coefficient file: " + fact,
                    "specify a .coef file that SPHARM-PDM or palpate wrote");
  }

  void SkipBlanks()
  {
    const std::size_t first = this->Rest.find_first_not_of(" \t\r\n");
    this->Rest.remove_prefix(first == std::string_view::npos ? this->Rest.size() : first);
  }

  bool Take(char sign)
  {
    this->SkipBlanks();
    if (this->Rest.empty() || this->Rest.front() != sign)
    {
      return false;
    }
    this->Rest.remove_prefix(1);
    return true;
  }

  void Expect(char sign)
  {
    if (!this->Take(sign))
    {
      this->Refuse(this->Rest.empty() ? "it ends too early"
                                      : std::string("a '") + sign + "' is missing");
    }
  }

  std::string_view Word()
  {
    const std::size_t end = this->Rest.find_first_of(",{}");
    const std::string_view word = this->Rest.substr(0, end);
    this->Rest.remove_prefix(word.size());
    return word;
  }

  double Number()
  {
    const std::optional<double> value = ParseNumber(this->Word());
    if (!value)
    {
      this->Refuse("it holds a value that is not a finite number");
    }
    return *value;
  }

  std::size_t Count(int& degree)
  {
    const std::optional<int> count = ParseInteger(this->Word());
    degree = count && *count > 0 ? DegreeOfCount(static_cast<std::size_t>(*count)) : -1;
    if (degree < 0 || degree > ModelConvention::MaximumDegree)
    {
      this->Refuse("its number of coefficients is not the square of a whole number up to " +
                   std::to_string(ModelConvention::MaximumDegree + 1));
    }
    return static_cast<std::size_t>(*count);
  }

  std::string_view Rest;
  const std::string& FileName;
};
} // namespace

std::string SurfaceToSpharmPdm(const OrganModel& surface, const std::string& fileName)
{
  const SurfaceModel written =
      std::visit([](const auto& s) -> SurfaceModel { return AsSurfaceModel(s); }, surface);
  std::array<std::vector<double>, 3> rows;
  for (std::size_t k = 0; k < rows.size(); ++k)
  {
    rows[k] = ToSpharmPdm(written.Coefficients(static_cast<int>(k)));
    Flip(rows[k], FrameSigns[k]);
  }
  std::string text = "{ " + std::to_string(rows[0].size()) + ",";
  for (std::size_t i = 0; i < rows[0].size(); ++i)
  {
    if (!std::isfinite(rows[0][i]) || !std::isfinite(rows[1][i]) || !std::isfinite(rows[2][i]))
    {
      Refuse(fileName, "cannot be written: a coefficient is not a finite number",
             "fit the model again");
    }
    text += (i == 0 ? "{" : ",\n{") + ExactText(rows[0][i]) + ", " + ExactText(rows[1][i]) + ", " +
            ExactText(rows[2][i]) + "}";
  }
  return text + "}\n";
}

SurfaceModel SurfaceFromSpharmPdm(const std::string& text, const std::string& fileName)
{
  int degree = 0;
  const std::array<std::vector<double>, 3> rows = CoefficientReader(text, fileName).Rows(degree);
  std::array<std::vector<double>, 3> coefficients;
  for (std::size_t k = 0; k < rows.size(); ++k)
  {
    coefficients[k] = FromSpharmPdm(rows[k]);
    Flip(coefficients[k], FrameSigns[k]);
  }
  return {degree, coefficients};
}
} // namespace palpate
