#pragma once

#include "CorrectedShape.h"
#include "IndexToWorld.h"
#include "PalpateStudyModule.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// A structure of a study under correction, and the steps so far; mm, patient LPS.
struct StudyCorrection
{
  static constexpr std::size_t MostSteps = 1100;     ///< as files have
  static constexpr std::size_t MostNumbers = 300000; ///< of strokes, so that files can be read

  int StructureId = 0; ///< a label of a segmentation or a model; 0: none
  std::vector<CorrectionStep> Steps;
  NeighborPolicy Neighbors = NeighborPolicy::Stop;
};

PALPATESTUDY_EXPORT bool operator==(const StudyCorrection& a, const StudyCorrection& b);

/// How wide the next pulls are.
struct PullWidth
{
  static constexpr double Second = 2.2; ///< of the first width
  static constexpr double Least = SurfaceCorrection::LeastWidth;
  static constexpr double Largest = SurfaceCorrection::LargestWidth / Second;

  double Width = 8.0;  ///< mm
  bool HasTwo = false; ///< the mean of this width and Second times it
};

/// A pull of a place, which moves nothing yet.
PALPATESTUDY_EXPORT SurfacePull PullAt(const PullWidth& width, const Vector3& placeWorld);

/// How far (mm) the place on the line from `place` along a unit normal that is nearest to a line of
/// sight (`from` to `to`) is from `place`. None if the two are nearly parallel (25 degrees).
PALPATESTUDY_EXPORT std::optional<double>
OffsetOnNormal(const Vector3& place, const Vector3& normal, const Vector3& from, const Vector3& to);

/// How many numbers the steps' strokes have: three for a point, four for a run of voxels.
PALPATESTUDY_EXPORT std::size_t NumbersIn(const std::vector<CorrectionStep>& steps);

/// A slice of a mask's grid.
struct GridSlice
{
  int Axis = 2; ///< 0 to 2
  int Slice = 0;
};

/// The slice of a grid in which a plane through a point lies; none if the plane is turned away from
/// the grid's slices by more than 2 degrees.
PALPATESTUDY_EXPORT std::optional<GridSlice>
SliceOfPlane(const IndexToWorld& grid, const Vector3& pointWorld, const Vector3& normal);

/// Fills between the two slices of one axis that steps painted last, or copied to, with others
/// between them; none if there are no such two.
PALPATESTUDY_EXPORT std::optional<SliceFilling>
FillingBetweenPainted(const std::vector<CorrectionStep>& steps, const IndexToWorld& grid);

/// "Pull the surface", "Remove islands", ...
PALPATESTUDY_EXPORT std::string NameOf(const CorrectionStep& step);
} // namespace palpate
