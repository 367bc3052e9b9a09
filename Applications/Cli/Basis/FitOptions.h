#pragma once

#include "FitSettings.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
class Option;
} // namespace CLI

namespace palpate::cli
{
/// The options that control how a structure becomes a surface and a model, shared by every command
/// that needs them.
class FitOptions
{
public:
  /// --label.
  void DeclareLabels(CLI::App& app);
  /// --method, --smoothing, --component.
  void DeclareSurface(CLI::App& app);
  /// --model, --rules, --repair, --degree, --tolerance, --max-degree, --frequency, --center,
  /// --weights,
  /// --penalty, --robust, --min-dice, --max-hidden.
  void DeclareModel(CLI::App& app);

  /// Labels by number or name; empty for all.
  const std::vector<std::string>& Labels() const { return this->LabelWords; }
  /// Throws InputError for invalid words.
  FitSettings Settings() const;
  /// Whether --component largest was given, which surface files need for their debris to be
  /// dropped: by default all of a surface counts.
  bool NamesLargest() const;

private:
  void DeclareKind(CLI::App& app);
  void DeclareSamples(CLI::App& app);

  std::vector<std::string> LabelWords;
  FitSettings Values;
  std::string ModelWord = "automatic";
  std::string MethodWord = "shape";
  std::string ComponentWord = "largest";
  const CLI::Option* ComponentOption = nullptr;
  std::string DegreeWord = "12";
  double Tolerance = 0.0;
  std::string CenterWord = "centroid";
  std::string WeightsWord = "area";
  std::string PenaltyWord = "none";
};
} // namespace palpate::cli
