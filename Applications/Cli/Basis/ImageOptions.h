#pragma once

#include "Volume.h"

#include <string>

namespace CLI
{
class App;
}

namespace palpate::cli
{
/// How a command reads its images: the options that every command with image files shares.
class ImageOptions
{
public:
  /// Adds --series and --refuse-left-handed; `seriesOf` says in help what the series is chosen
  /// from.
  void Declare(CLI::App& app, const std::string& seriesOf);

  LeftHandedAxes LeftHanded() const;
  VolumeChoice Choice() const { return {this->Series, this->LeftHanded()}; }

private:
  std::string Series;
  bool RefuseLeftHanded = false;
};
} // namespace palpate::cli
