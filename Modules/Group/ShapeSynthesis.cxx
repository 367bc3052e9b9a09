#include "ShapeSynthesis.h"

#include "DecimalText.h"
#include "InputError.h"
#include "ModelFile.h"
#include "RadiusRange.h"

#include <map>
#include <optional>
#include <sstream>

namespace palpate
{
namespace
{
constexpr double RadiusTolerance = 1e-3; // mm

std::map<int, double> DeviationsOf(const std::string& text)
{
  std::map<int, double> deviations;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');)
  {
    const std::size_t colon = part.find(':');
    const auto mode = ParseInteger(part.substr(0, colon));
    const auto several =
        colon == std::string::npos ? std::nullopt : ParseNumber(part.substr(colon + 1));
    if (!mode || !several || !deviations.emplace(*mode, *several).second)
    {
      throw InputError("the shape " + text +
                       " is not a list of different modes with their standard deviations, such as "
                       "1:2,3:-1");
    }
  }
  return deviations;
}
} // namespace

OrganModel SynthesizeShape(const CohortGroup& group, const std::string& text)
{
  const auto modes = static_cast<int>(group.Modes.Modes.cols());
  Eigen::VectorXd scores = group.Modes.Deviations * 0.0;
  for (const auto& [mode, several] : text == "0" ? std::map<int, double>{} : DeviationsOf(text))
  {
    if (mode < 1 || mode > modes)
    {
      throw InputError("the shape " + text + " needs mode " + std::to_string(mode) +
                       ", but the group has " + std::to_string(modes));
    }
    scores[mode - 1] = several * group.Modes.Deviations[mode - 1];
  }
  OrganModel shape = ShapeWith(group, scores);
  const auto* radial = std::get_if<RadialModel>(&shape);
  if (radial != nullptr && FindRadiusRange(*radial, RadiusTolerance).LowestFound <= 0.0)
  {
    throw InputError("the shape " + text +
                     " passes through its centre; take fewer standard deviations");
  }
  return shape;
}

void WriteSynthesis(const CohortGroup& group, const std::string& text,
                    const std::filesystem::path& folder, const std::string& program)
{
  ModelDocument document;
  document.Surface = SynthesizeShape(group, text);
  document.Provenance.Program = program;
  document.Provenance.Settings = {{"cases", std::to_string(group.Rows.size())}, {"shape", text}};
  WriteModel(folder / "shape.json", document);
}
} // namespace palpate
