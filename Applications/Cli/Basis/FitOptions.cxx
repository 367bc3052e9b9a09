#include "FitOptions.h"

#include "FiniteNumber.h"
#include "InputError.h"
#include "VectorText.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>

namespace palpate::cli
{
namespace
{
constexpr double FirstTolerance = 0.5; // mm, of --degree auto by the first rules

template <typename T>
bool ParseWhole(const std::string& word, T& value)
{
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  return error == std::errc() && stop == end;
}

int ParseDegree(const std::string& word)
{
  int degree = 0;
  if (!ParseWhole(word, degree) || degree < 0 || degree > FitLimits::Degree)
  {
    throw InputError("--degree " + word + " is not a valid degree; give a whole number from 0 to " +
                     std::to_string(FitLimits::Degree) + ", or auto");
  }
  return degree;
}

// Checked before a mask is read; directions that miss the surface may still leave too few samples.
void CheckDirections(const FitSettings& settings)
{
  const int directions = 10 * settings.Frequency * settings.Frequency + 2;
  const int coefficients = (settings.Degree + 1) * (settings.Degree + 1);
  if (directions < coefficients)
  {
    throw InputError("--frequency " + std::to_string(settings.Frequency) + " gives " +
                     std::to_string(directions) + " samples and --degree " +
                     std::to_string(settings.Degree) + " has " + std::to_string(coefficients) +
                     " coefficients; take more directions or a lower degree");
  }
}

// A surface model has neither a centre nor a penalty, and its samples weigh as their area.
void CheckSurfaceOptions(const FitSettings& settings, const FitSettings& standard)
{
  const auto only = [](bool isChanged, const std::string& option)
  {
    if (isChanged)
    {
      throw InputError(option + " is for radial models; leave it out with --model surface");
    }
  };
  only(settings.GivenCenterWorld || settings.Center != standard.Center, "--center");
  only(settings.Weight != standard.Weight, "--weights");
  only(settings.PenaltyKind != standard.PenaltyKind, "--penalty");
  only(settings.IsRobust, "--robust");
  only(settings.Method != standard.Method, "--method");
  only(settings.Smoothing != standard.Smoothing, "--smoothing");
  only(settings.MaximumHiddenPercent != standard.MaximumHiddenPercent, "--max-hidden");
}

void SetComponent(const std::string& word, FitSettings& settings)
{
  settings.Component = word == "each" ? FitSettings::EachPart : word == "all" ? 0 : 1;
  settings.IsAlone = word != "all" && word != "largest";
  if (settings.IsAlone && word != "each" &&
      (!ParseWhole(word, settings.Component) || settings.Component < 1))
  {
    throw InputError("--component " + word +
                     " is not a valid component; give a whole number from 1, largest, all or each");
  }
}
} // namespace

void FitOptions::DeclareLabels(CLI::App& app)
{
  app.add_option("--label", this->LabelWords,
                 "Structures by number or name, separated by commas (default: all)")
      ->type_name("N|NAME")
      ->allow_extra_args(false);
}

void FitOptions::DeclareSurface(CLI::App& app)
{
  app.add_option("--method", this->MethodWord,
                 "shape: interpolate the shape between slices; plain: the mask's half level")
      ->check(CLI::IsMember(FitWords::Method))
      ->capture_default_str();
  app.add_option("--smoothing", this->Values.Smoothing,
                 "Smoothing of the surface in voxels (0 for none)")
      ->check(FiniteNumber::Between(0.0, FitLimits::Smoothing))
      ->capture_default_str();
  this->ComponentOption =
      app.add_option("--component", this->ComponentWord,
                     "largest (a surface model takes in parts near it), a connected component's "
                     "number by decreasing size from 1, alone, all together, or each (palpate fit: "
                     "a model of each part); of a surface file, the part to keep (default: it must "
                     "be one)")
          ->type_name("largest|N|all|each")
          ->capture_default_str();
}

void FitOptions::DeclareModel(CLI::App& app)
{
  this->DeclareKind(app);
  this->DeclareSamples(app);
}

void FitOptions::DeclareKind(CLI::App& app)
{
  app.add_option("--model", this->ModelWord,
                 "radial: a radius in each direction, for star-shaped structures; surface: three "
                 "coordinates, for any shape; automatic: radial where star-shaped and good "
                 "enough, else surface")
      ->check(CLI::IsMember(FitWords::Model))
      ->capture_default_str();
  app.add_option("--rules", this->Values.Rules,
                 "Rules by which the kind of model is chosen and structures are accepted: 2, or 1 "
                 "as before November 2026")
      ->check(CLI::Range(1, FitSettings::NewestRules))
      ->capture_default_str();
  app.add_flag("--repair", this->Values.Repairs,
               "Accept models of structures whose handles, cavities or parts need large "
               "changes; of a surface file, fit what its voxels enclose if it is not closed");
  app.add_option("--degree", this->DegreeWord,
                 "Degree of the model, or auto: from 12 on the smallest that leaves a fifth of a "
                 "voxel, or from 0 on the smallest that meets --tolerance, up to the resolution "
                 "of the mask (wavelength of two voxels)")
      ->type_name("N|auto")
      ->capture_default_str();
  app.add_option("--tolerance", this->Tolerance,
                 "RMS residual in mm along the normals that --degree auto must meet (default: a "
                 "fifth of a voxel)")
      ->type_name("MM")
      ->check(FiniteNumber::Positive());
  app.add_option("--max-degree", this->Values.MaximumDegree,
                 "Highest degree that --degree auto tries")
      ->check(CLI::Range(0, FitLimits::Degree))
      ->capture_default_str();
}

void FitOptions::DeclareSamples(CLI::App& app)
{
  app.add_option(
         "--frequency", this->Values.Frequency,
         "Subdivision F of the icosahedron: 10 F^2 + 2 directions; surface models are drawn "
         "with at least 1.6 times their degree")
      ->check(CLI::Range(1, FitLimits::Frequency))
      ->capture_default_str();
  app.add_option("--center", this->CenterWord,
                 "centroid, visible (sees most of the surface), or a point x,y,z in mm (LPS)")
      ->type_name("CENTER")
      ->capture_default_str();
  app.add_option("--weights", this->WeightsWord, "Weight of each sample")
      ->check(CLI::IsMember(FitWords::Weight))
      ->capture_default_str();
  app.add_option("--penalty", this->PenaltyWord,
                 "Roughness penalty: none, auto (cross-validation), or its strength")
      ->type_name("none|auto|X")
      ->capture_default_str();
  app.add_flag("--robust", this->Values.IsRobust,
               "Down-weight samples with large residuals (Huber weights), for masks with spikes");
  app.add_option("--min-dice", this->Values.MinimumDice,
                 "Refuse models whose Dice with the mask is below this (0 accepts all)")
      ->check(FiniteNumber::Between(0.0, 1.0))
      ->capture_default_str();
  app.add_option(
         "--max-hidden", this->Values.MaximumHiddenPercent,
         "Refuse structures if more than this share of the surface is hidden from the centre (%)")
      ->type_name("%")
      ->check(FiniteNumber::Between(0.0, 100.0))
      ->capture_default_str();
}

bool FitOptions::NamesLargest() const
{
  return this->ComponentOption != nullptr && this->ComponentOption->count() > 0 &&
         this->ComponentWord == "largest";
}

FitSettings FitOptions::Settings() const
{
  FitSettings settings = this->Values;
  FitWords::Take(FitWords::Model, this->ModelWord, settings.Model);
  FitWords::Take(FitWords::Method, this->MethodWord, settings.Method);
  FitWords::Take(FitWords::Weight, this->WeightsWord, settings.Weight);
  SetComponent(this->ComponentWord, settings);
  if (this->DegreeWord == "auto")
  {
    settings.Tolerance = this->Tolerance > 0.0 ? this->Tolerance
                         : settings.Rules > 1  ? 0.0 // by the voxels
                                               : FirstTolerance;
  }
  else
  {
    settings.Degree = ParseDegree(this->DegreeWord);
    CheckDirections(settings);
    if (this->Tolerance > 0.0)
    {
      throw InputError("--tolerance needs --degree auto; it has no effect on a fixed degree");
    }
    // 3D Slicer passes every option, so that the default is no mistake.
    if (settings.MaximumDegree != FitSettings().MaximumDegree)
    {
      throw InputError("--max-degree needs --degree auto; it has no effect on a fixed degree");
    }
  }
  if (this->CenterWord == "visible")
  {
    settings.Center = FitSettings::CenterChoice::MostVisible;
  }
  else if (this->CenterWord != "centroid")
  {
    const Vector3 center = ParseVector("--center", this->CenterWord);
    settings.GivenCenterWorld = {center.x(), center.y(), center.z()};
  }
  if (this->PenaltyWord == "auto")
  {
    settings.PenaltyKind = FitSettings::Penalty::Automatic;
  }
  else if (this->PenaltyWord != "none")
  {
    settings.PenaltyKind = FitSettings::Penalty::Given;
    if (!ParseWhole(this->PenaltyWord, settings.Roughness) || !(settings.Roughness > 0.0) ||
        !std::isfinite(settings.Roughness))
    {
      throw InputError("--penalty " + this->PenaltyWord +
                       " is not a valid penalty; give none, auto, or a positive number");
    }
  }
  if (settings.Model == FitSettings::ModelKind::Surface)
  {
    CheckSurfaceOptions(settings, FitSettings());
  }
  return settings;
}
} // namespace palpate::cli
