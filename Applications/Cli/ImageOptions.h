#pragma once

#include "Volume.h"

#include <string>

namespace CLI
{
class App;
}

namespace palpate::cli
{
/// How the images of a command are to be read: the part of the option vocabulary that every command
/// with image files shares.
class ImageOptions
{
public:
  /// Adds --series, with what it chooses from, and --refuse-left-handed.
  void Declare(CLI::App& app, const std::string& seriesOf);
  /// Adds --refuse-left-handed alone, where no DICOM series is read.
  void DeclareAxes(CLI::App& app);

  LeftHandedAxes LeftHanded() const;
  VolumeChoice Choice() const { return {this->Series, this->LeftHanded()}; }

private:
  std::string Series;
  bool RefuseLeftHanded = false;
};
} // namespace palpate::cli
