#include "TradeSetting.h"

#include <tuple>

namespace palpate
{
namespace
{
std::string HarmonicsText(const TradeSetting& setting)
{
  const std::string text = "harmonics of degree " + std::to_string(setting.Degree);
  if (setting.DrawnFrequency > 0)
  {
    const int triangles = 20 * setting.DrawnFrequency * setting.DrawnFrequency;
    return text + ", drawn by " + std::to_string(triangles) + " triangles";
  }
  return text + (setting.Mode == HarmonicContactMode::Nearest ? ", nearest point" : ", radial");
}

std::string FieldText(const TradeSetting& setting)
{
  const bool isLinear = setting.Interpolation == FieldInterpolation::Trilinear;
  return std::string("sub-voxel, ") + (isLinear ? "trilinear, " : "tricubic, ") +
         (setting.ToolPoints > 0 ? std::to_string(setting.ToolPoints) : "enough") + " tool points";
}
} // namespace

bool operator==(const TradeSetting& a, const TradeSetting& b)
{
  const auto fields = [](const TradeSetting& s)
  {
    return std::tie(s.Representation, s.Degree, s.Mode, s.Facets, s.Interpolation, s.ToolPoints,
                    s.DrawnFrequency);
  };
  return fields(a) == fields(b);
}

std::string Describe(const TradeSetting& setting)
{
  switch (setting.Representation)
  {
  case TouchRepresentation::Harmonics:
    return HarmonicsText(setting);
  case TouchRepresentation::Facets:
    return setting.Facets > 0 ? "about " + std::to_string(setting.Facets) + " facets"
                              : "all facets of the surface";
  default:
    return FieldText(setting);
  }
}

std::string KeyOf(const TradeSetting& setting)
{
  switch (setting.Representation)
  {
  case TouchRepresentation::Harmonics:
    return "harmonics/" + std::to_string(setting.Degree) +
           (setting.DrawnFrequency > 0
                ? "/drawn/" + std::to_string(setting.DrawnFrequency)
                : std::string(setting.Mode == HarmonicContactMode::Nearest ? "/nearest"
                                                                           : "/radial"));
  case TouchRepresentation::Facets:
    return "facets/" + (setting.Facets > 0 ? std::to_string(setting.Facets) : "all");
  default:
    return std::string("sub-voxel/") +
           (setting.Interpolation == FieldInterpolation::Trilinear ? "linear/" : "cubic/") +
           std::to_string(setting.ToolPoints);
  }
}
} // namespace palpate
