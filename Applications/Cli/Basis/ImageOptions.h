#pragma once

#include "Volume.h"

#include <string>
#include <vector>

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

  /// Adds --threshold and --background, which make masks of images.
  void DeclareValues(CLI::App& app);
  /// Adds --resample.
  void DeclareResampling(CLI::App& app);

  LeftHandedAxes LeftHanded() const;
  /// Throws InputError for a background that is no number.
  VolumeChoice Choice() const;
  /// The same for grey values, which --threshold and --background are not for.
  VolumeChoice ChoiceOfVolume() const;
  /// --threshold and --background as one text, for keys; empty if neither is given.
  std::string ValueText() const;

private:
  std::string Series;
  bool RefuseLeftHanded = false;
  bool Resample = false;
  std::vector<double> Threshold; ///< one or none
  std::vector<std::string> Background;
};
} // namespace palpate::cli
