#include "TradeSetting.h"

#include <tuple>

namespace palpate
{
namespace
{
int CellsOf(BrickSize size)
{
  return 1 << static_cast<int>(size);
}

std::string IntervalText(int interval)
{
  return interval > 1 ? ", asked every " + std::to_string(interval) + " ticks" : std::string();
}

std::string HarmonicsText(const TradeSetting& setting)
{
  const std::string text = "harmonics of degree " + std::to_string(setting.Degree);
  if (setting.DrawnFrequency > 0)
  {
    const int triangles = 20 * setting.DrawnFrequency * setting.DrawnFrequency;
    return text + ", drawn by " + std::to_string(triangles) + " triangles";
  }
  return text + (setting.Mode == HarmonicContactMode::Nearest ? ", nearest point" : ", radial") +
         (setting.Precision == EvaluationPrecision::Float ? ", in float" : "");
}

std::string FieldText(const TradeSetting& setting)
{
  const bool isLinear = setting.Interpolation == FieldInterpolation::Trilinear;
  const bool isUsual = setting.Bricks == BrickSize::Cells8;
  return std::string("sub-voxel, ") + (isLinear ? "trilinear, " : "tricubic, ") +
         (isUsual ? ""
                  : "bricks of " + std::to_string(CellsOf(setting.Bricks)) + "\u00b3 cells, ") +
         (setting.ToolPoints > 0 ? std::to_string(setting.ToolPoints) : "enough") + " tool points";
}
} // namespace

bool operator==(const TradeSetting& a, const TradeSetting& b)
{
  const auto fields = [](const TradeSetting& s)
  {
    return std::tie(s.Representation, s.Degree, s.Mode, s.Precision, s.Facets, s.Interpolation,
                    s.Bricks, s.ToolPoints, s.ModelInterval, s.DrawnFrequency);
  };
  return fields(a) == fields(b);
}

std::string Describe(const TradeSetting& setting)
{
  std::string text;
  switch (setting.Representation)
  {
  case TouchRepresentation::Harmonics:
    text = HarmonicsText(setting);
    break;
  case TouchRepresentation::Facets:
    text = setting.Facets > 0 ? "about " + std::to_string(setting.Facets) + " facets"
                              : "all facets of the surface";
    break;
  default:
    text = FieldText(setting);
  }
  return text + IntervalText(setting.ModelInterval);
}

std::string KeyOf(const TradeSetting& setting)
{
  const std::string interval = "/" + std::to_string(setting.ModelInterval);
  switch (setting.Representation)
  {
  case TouchRepresentation::Harmonics:
    return "harmonics/" + std::to_string(setting.Degree) +
           (setting.DrawnFrequency > 0
                ? "/drawn/" + std::to_string(setting.DrawnFrequency)
                : std::string(setting.Mode == HarmonicContactMode::Nearest ? "/nearest"
                                                                           : "/radial") +
                      (setting.Precision == EvaluationPrecision::Float ? "/float" : "") + interval);
  case TouchRepresentation::Facets:
    return "facets/" + (setting.Facets > 0 ? std::to_string(setting.Facets) : "all") + interval;
  default:
    return std::string("sub-voxel/") +
           (setting.Interpolation == FieldInterpolation::Trilinear ? "linear/" : "cubic/") +
           std::to_string(CellsOf(setting.Bricks)) + "/" + std::to_string(setting.ToolPoints) +
           interval;
  }
}
} // namespace palpate
