#pragma once

#include "LabelImages.h"
#include "TradeBench.h"

#include <cmath>
#include <memory>

namespace palpate::test
{
/// A clock on which nothing takes any time, so that what is measured has the same bits each time.
class StillClock final : public Clock
{
public:
  std::int64_t Now() const noexcept override { return 0; }
  void WaitUntil(std::int64_t /*time*/) noexcept override {}
};

inline bool GoOn(double /*fraction*/, const std::string& /*stage*/)
{
  return true;
}

constexpr double BallRadius = 20.0; // mm

/// A ball of 20 mm with bumps of degree 6, so high (mm) where the pole is; 0 for none.
inline TradeSource BumpyModel(double height)
{
  constexpr int Degree = 6;
  std::vector<double> coefficients(49, 0.0);
  coefficients[0] = BallRadius * std::sqrt(4.0 * M_PI);
  // Y_l0 at the pole is sqrt((2 l + 1) / 4 pi), where it is largest.
  coefficients[Degree * (Degree + 1)] = height / std::sqrt((2.0 * Degree + 1.0) / (4.0 * M_PI));
  TradeSource source;
  source.Name = "bumpy";
  source.File = "bumpy.json";
  source.Is = std::make_shared<const SphericalHarmonicModel>(Degree, coefficients,
                                                             Vector3(3.0, -7.0, 11.0));
  return source;
}

template <typename Inside>
TradeSource MaskOf(const Inside& inside)
{
  LabelGrid grid;
  grid.Size = {{48, 48, 32}};
  grid.Spacing = {{0.8, 0.8, 1.2}};
  grid.CenterOnOrigin();
  auto segmentation = std::make_shared<Segmentation>();
  segmentation->Layers.emplace_back(MakeLabelImage(grid, inside));
  Segment segment;
  segment.Label = 1;
  segment.Value = 1;
  segmentation->Segments.push_back(segment);
  segmentation->Source = "mask.nrrd";
  TradeSource source;
  source.Name = "mask";
  source.File = "mask.nrrd";
  source.Is = TradeSource::Mask{segmentation, segment};
  return source;
}

inline TradeSource BallMask()
{
  return MaskOf([](double x, double y, double z) { return std::hypot(x, y, z) < 14.0; });
}

/// Short, since errors need no good times.
inline TradeBench::Settings ShortPath(std::uint64_t seed = 1)
{
  TradeBench::Settings settings;
  settings.Path.Seconds = 2.0;
  settings.Path.Seed = seed;
  settings.Runs = 1;
  return settings;
}

inline TradeSetting Harmonics(int degree)
{
  TradeSetting setting;
  setting.Representation = TouchRepresentation::Harmonics;
  setting.Degree = degree;
  return setting;
}

inline TradeSetting Facets(int facets)
{
  TradeSetting setting;
  setting.Representation = TouchRepresentation::Facets;
  setting.Facets = facets;
  return setting;
}

inline TradeSetting SubVoxel(FieldInterpolation interpolation, int points)
{
  TradeSetting setting;
  setting.Representation = TouchRepresentation::SubVoxel;
  setting.Interpolation = interpolation;
  setting.ToolPoints = points;
  return setting;
}
} // namespace palpate::test
