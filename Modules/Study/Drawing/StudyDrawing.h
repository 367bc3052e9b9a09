#pragma once

#include "PalpateStudyModule.h"
#include "Status.h"
#include "SurfaceTouch.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace palpate
{
///@{
/// Bounds of the standard deviations of touches, mm.
constexpr double LeastTouchDeviation = 0.01;
constexpr double LargestTouchDeviation = 100.0;
///@}

/// What a user knows of an organ that is drawn by touch; mm, patient LPS.
struct StudyDrawing
{
  static constexpr int KnownByName = -1;

  std::filesystem::path PriorFile; ///< see ReadOrganPrior; empty: smoothness alone
  /// The structure that is known, if the prior relates to another organ: an id, 0 for none, or
  /// KnownByName.
  int KnownId = KnownByName;
  double Sigma = 1.0;                 ///< standard deviation of the next touches, mm
  std::optional<Vector3> CenterWorld; ///< near the organ's middle; none: that of the touches' box
  std::vector<SurfaceTouch> Touches;  ///< a stroke's are next to each other
  bool IsTouchable = true;            ///< whether the tool feels the organ
  bool IsSoftened = true;             ///< softer where it is uncertain, see UncertainStiffness

  bool HasPlaces() const { return this->CenterWorld || !this->Touches.empty(); }
};

PALPATESTUDY_EXPORT bool operator==(const StudyDrawing& a, const StudyDrawing& b);

/// Touches that are on the surface.
PALPATESTUDY_EXPORT std::size_t SurfaceCount(const StudyDrawing& drawing);

/// The standard deviation of the next touches; those that have the former one take it, too.
PALPATESTUDY_EXPORT void SetSigma(StudyDrawing& drawing, double sigma);

/// A touch counts once, one with a normal thrice: what the time of a completion depends on. A
/// drawing has at most MostDrawnRows, which take 15 ms, or a second if they are refused.
PALPATESTUDY_EXPORT std::size_t RowCount(const std::vector<SurfaceTouch>& touches);
constexpr std::size_t MostDrawnRows = 300;

/// Adds touches after those that are there. Their strokes get numbers that are free, and their
/// normals a length of 1. Fails, and adds none, for more than MostDrawnRows, and for standard
/// deviations out of bounds.
PALPATESTUDY_EXPORT Status AddTouches(StudyDrawing& drawing, std::vector<SurfaceTouch> touches);

/// Touches of one stroke, about `spacing` (mm) apart on the line through these points; fewer than
/// two of them are no stroke.
PALPATESTUDY_EXPORT std::vector<SurfaceTouch> TouchesOfStroke(const std::vector<Vector3>& points,
                                                              double spacing, double deviation);

/// Removes the touch of this number, or the stroke that it belongs to.
PALPATESTUDY_EXPORT void RemoveTouch(StudyDrawing& drawing, std::size_t number);
} // namespace palpate
