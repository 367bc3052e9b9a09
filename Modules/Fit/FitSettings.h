#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <tuple>

namespace palpate
{
/// Everything that decides how one structure of a segmentation becomes a model. The defaults are
/// those of the command line and of the application.
struct FitSettings
{
  enum class SurfaceMethod
  {
    ShapeInterpolation, ///< signed distance, interpolated between slices
    Plain               ///< half-level surface of the mask as it is
  };
  enum class CenterChoice
  {
    Centroid,   ///< of the enclosed volume
    MostVisible ///< the point from which most of the surface is seen
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

  SurfaceMethod Method = SurfaceMethod::ShapeInterpolation;
  double Smoothing = 1.0; ///< width of the surface's smoothing, in voxels; 0 for none
  int Component = 1;      ///< which connected component, by falling size, from 1; 0 for all

  int Frequency = 20; ///< of the icosahedron: 10 f^2 + 2 directions
  CenterChoice Center = CenterChoice::Centroid;
  std::optional<std::array<double, 3>> GivenCenterWorld; ///< mm, patient LPS; overrides Center

  int Degree = 12;
  std::optional<double> Tolerance; ///< mm; if set, the smallest degree whose RMS residual meets it
  int MaximumDegree = 40;          ///< where the search for a degree ends
  SampleWeight Weight = SampleWeight::Area;
  Penalty PenaltyKind = Penalty::None;
  double Roughness = 0.0; ///< with Penalty::Given
  bool IsRobust = false;  ///< samples with large residuals count less (HuberWeights)

  double MaximumHiddenPercent = 10.0; ///< more hidden surface than this is refused
  double MinimumDice = 0.75;          ///< a model that overlaps the mask less than this is refused
};

inline bool operator==(const FitSettings& a, const FitSettings& b)
{
  const auto fields = [](const FitSettings& s)
  {
    return std::tie(s.Method, s.Smoothing, s.Component, s.Frequency, s.Center, s.GivenCenterWorld,
                    s.Degree, s.Tolerance, s.MaximumDegree, s.Weight, s.PenaltyKind, s.Roughness,
                    s.IsRobust, s.MaximumHiddenPercent, s.MinimumDice);
  };
  return fields(a) == fields(b);
}
} // namespace palpate
