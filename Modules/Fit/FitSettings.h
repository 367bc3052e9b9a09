#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <tuple>

namespace palpate
{
/// All settings of the fit of one structure. The defaults are those of the command line and of the
/// application.
struct FitSettings
{
  enum class ModelKind
  {
    Radial,   ///< a radius in each direction from a centre; star-shaped structures only
    Surface,  ///< three coordinates over the parameter sphere; any closed structure
    Automatic ///< radial where star-shaped (see MaximumHiddenPercent) and good enough, else surface
  };
  enum class SurfaceMethod
  {
    ShapeInterpolation, ///< signed distance, interpolated between slices
    Plain               ///< half-level surface of the unprocessed mask
  };
  enum class CenterChoice
  {
    Centroid,   ///< of the enclosed volume
    MostVisible ///< the point that sees most of the surface
  };
  enum class SampleWeight
  {
    Area,       ///< by the surface's area: small distances along the normal
    SolidAngle, ///< by the solid angle: small radial distances
    Uniform
  };
  enum class Penalty
  {
    None,
    Given,
    Automatic ///< generalised cross-validation
  };

  /// By which kind a model is chosen and what is accepted: 2, or 1 as in files that do not say.
  /// With 2, Automatic compares distances as well (ModelChoice), and radial models are refused for
  /// the same changes as surface models (StructureChanges).
  static constexpr int NewestRules = 2;
  int Rules = NewestRules;

  ModelKind Model = ModelKind::Automatic;
  SurfaceMethod Method = SurfaceMethod::ShapeInterpolation;
  double Smoothing = 1.0; ///< width of the surface's smoothing, in voxels; 0 for none
  int Component = 1;      ///< connected component, by descending size, from 1; 0 for all
  /// Component of a caller that fits each by itself (PartsOf); the stages do not know it.
  static constexpr int EachPart = -1;
  bool IsAlone = false; ///< component 1: a surface model takes in no parts near it, either

  int Frequency = 20; ///< of the icosahedron: 10 f^2 + 2 directions; see also DrawnFrequency
  CenterChoice Center = CenterChoice::Centroid;
  std::optional<std::array<double, 3>> GivenCenterWorld; ///< mm, patient LPS; overrides Center

  int Degree = 12;
  /// mm; if set, the smallest degree whose RMS residual meets it. 0: by the voxels, and at least
  /// Degree (DegreeGoal).
  std::optional<double> Tolerance;
  int MaximumDegree = 40; ///< upper bound of the degree search
  SampleWeight Weight = SampleWeight::Area;
  Penalty PenaltyKind = Penalty::None;
  double Roughness = 0.0; ///< with Penalty::Given
  bool IsRobust = false;  ///< samples with large residuals count less (HuberWeights)

  /// Whether one component is all that is to be modelled, so that others are not missed.
  bool WantsOneComponent() const
  {
    return this->Component > 1 || (this->Component == 1 && this->IsAlone);
  }

  bool Repairs = false; ///< surface models also where the structure's topology has to be changed
                        ///< beyond the limits of CheckTopology

  double MaximumHiddenPercent = 10.0; ///< radial models of more hidden surface are refused;
                                      ///< at 100 Automatic is radial, whatever that loses
  bool AcceptsAllHidden() const { return this->MaximumHiddenPercent >= 100.0; }

  double MinimumDice = 0.75; ///< a model that overlaps the mask less than this is refused
};

/// What files, the command line and the window accept.
struct FitLimits
{
  static constexpr double Smoothing = 10.0; ///< voxels
  static constexpr int Frequency = 200;
  static constexpr int Degree = 100; ///< a fit takes minutes and gigabytes
};

/// The words of the choices in files, on the command line and in the window, in the order of their
/// enumerations.
struct FitWords
{
  using Words = std::initializer_list<const char*>;
  inline static const Words Model{"radial", "surface", "automatic"};
  inline static const Words Method{"shape", "plain"};
  inline static const Words Center{"centroid", "visible"};
  inline static const Words Weight{"area", "solid-angle", "uniform"};
  inline static const Words Penalty{"none", "given", "auto"};

  template <typename Choice>
  static std::string Of(const Words& words, Choice choice)
  {
    return *(words.begin() + static_cast<int>(choice));
  }
  /// The choice of one of the words.
  template <typename Choice>
  static void Take(const Words& words, const std::string& word, Choice& choice)
  {
    choice = static_cast<Choice>(std::find(words.begin(), words.end(), word) - words.begin());
  }
};

inline bool operator==(const FitSettings& a, const FitSettings& b)
{
  const auto fields = [](const FitSettings& s)
  {
    return std::tie(s.Rules, s.Model, s.Repairs, s.Method, s.Smoothing, s.Component, s.IsAlone,
                    s.Frequency, s.Center, s.GivenCenterWorld, s.Degree, s.Tolerance,
                    s.MaximumDegree, s.Weight, s.PenaltyKind, s.Roughness, s.IsRobust,
                    s.MaximumHiddenPercent, s.MinimumDice);
  };
  return fields(a) == fields(b);
}
} // namespace palpate
