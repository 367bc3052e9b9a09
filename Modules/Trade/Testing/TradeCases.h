#pragma once

#include "ImageWriter.h"
#include "LabelImages.h"
#include "StructureTrade.h"
#include "TemporaryFolder.h"
#include "TradeMeasure.h"

#include <cmath>
#include <memory>

namespace palpate::test
{
/// A clock that stands still, so that measurements are reproducible bit for bit.
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

constexpr double SphereRadius = 20.0; // mm

/// A sphere of 20 mm with bumps of degree 6 of this height (mm) at the pole; 0 for none.
inline RadialModel BumpyModel(double height)
{
  constexpr int Degree = 6;
  std::vector<double> coefficients(49, 0.0);
  coefficients[0] = SphereRadius * std::sqrt(4.0 * M_PI);
  // Y_l0 at the pole is sqrt((2 l + 1) / 4 pi), where it is largest.
  coefficients[Degree * (Degree + 1)] = height / std::sqrt((2.0 * Degree + 1.0) / (4.0 * M_PI));
  return {Degree, coefficients, Vector3(3.0, -7.0, 11.0)};
}

/// Short, since errors do not depend on exact times.
inline StructureTrade::Settings ShortPath(std::uint64_t seed = 1)
{
  StructureTrade::Settings settings;
  settings.Path.Seconds = 2.0;
  settings.Path.Seed = seed;
  settings.Runs = 1;
  return settings;
}

inline ContactSetting Harmonics(int degree)
{
  ContactSetting setting;
  setting.Structure.Representation = TouchRepresentation::Harmonics;
  setting.Structure.Degree = degree;
  return setting;
}

/// The bumpy model as the reference of a path, and the measurement of contact models along it.
struct ModelTrade
{
  explicit ModelTrade(double height, double toolRadius = 2.0)
      : Model(std::make_shared<const RadialModel>(BumpyModel(height)))
  {
    this->Touch.Tool.Radius = toolRadius;
    this->Touch.Runs = 1;
    this->Reference = ModelReference(*this->Model, this->Touch.Tool);
    this->Path = MakeTradePath(*this->Reference, this->Touch.Tool, ShortPath().Path, GoOn);
  }
  TradeRow Measure(const TouchContact& contact, const Clock& clock = StillClock()) const
  {
    TradeRow row;
    MeasureTouch(*contact.Model, this->Touch, this->Path, clock, row, GoOn);
    return row;
  }
  TradeRow MeasureDegree(int degree) const
  {
    return this->Measure(MakeModelContact(this->Model->WithDegree(degree),
                                          RadialContactMode::Nearest, "bumpy.json"));
  }

  std::shared_ptr<const RadialModel> Model;
  TradeTouch Touch;
  std::unique_ptr<TradeReference> Reference;
  TradePath Path;
};

/// A label map in a file, with one structure, and its measurement.
class MaskTrade
{
public:
  template <typename Inside>
  explicit MaskTrade(const Inside& inside,
                     const LabelGrid& grid = GridOf({{48, 48, 32}}, {{0.8, 0.8, 1.2}}))
  {
    const std::filesystem::path file = this->Folder / "mask.nii.gz";
    WriteImage(file, MakeLabelImage(grid, inside));
    SceneStructure structure;
    structure.Id = 1;
    structure.File = file;
    structure.Labels = {"1"};
    this->Scene.Structures.push_back(structure);
  }
  ContactSetting SubVoxel(FieldInterpolation interpolation, int points) const
  {
    ContactSetting setting = SettingOf(this->Scene, TouchRepresentation::SubVoxel);
    setting.Structure.Interpolation = interpolation;
    setting.ToolPoints = points;
    return setting;
  }
  StructureTrade Trade(const StructureTrade::Settings& settings = ShortPath()) const
  {
    return {this->Scene, this->Scene.Structures.front(), SceneRun(), settings, this->Time};
  }

  /// Its values are those of an image; the reference is then their tricubic field.
  void TakeAsImage()
  {
    this->Scene.Structures.front().Labels.clear();
    this->Scene.Structures.front().Iso = 0.5;
  }

  static LabelGrid GridOf(const std::array<int, 3>& size, const std::array<double, 3>& spacing)
  {
    LabelGrid grid;
    grid.Size = size;
    grid.Spacing = spacing;
    grid.CenterOnOrigin();
    return grid;
  }

  SceneSettings Scene;

private:
  TemporaryFolder Folder;
  StillClock Time;
};

inline MaskTrade SphereMask()
{
  return MaskTrade([](double x, double y, double z) { return std::hypot(x, y, z) < 14.0; });
}
} // namespace palpate::test
