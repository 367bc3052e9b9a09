#pragma once

#include "Status.h"
#include "Vector3.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// What a guide keeps the tool at: points, or a level of the signed distance to a structure.
enum class GuideShape
{
  Point,   ///< the first point
  Path,    ///< straight lines from point to point
  Plane,   ///< through the first three points
  Inside,  ///< of the level; there, it does not act
  Outside, ///< of the level; there, it does not act
  Surface  ///< at the level, which is the structure's surface at the distance 0
};

/// A guide, in the world.
struct GuideSettings
{
  static constexpr std::size_t MostPoints = 1000;
  static constexpr double MostStiffness = 10.0; ///< N/mm, of files and the window
  static constexpr double MostForce = 3.0;      ///< N

  GuideShape Shape = GuideShape::Point;
  std::vector<Vector3> PointsWorld; ///< mm
  double Stiffness = 0.2;           ///< N per mm of the world, at the guide
  double Range = 10.0;              ///< mm; farther away it does not act
  double LargestForce = 0.5;        ///< N
  int Structure = 0;                ///< id of the structure; 0: none
  double Distance = 0.0;            ///< mm, of the level from its surface, negative inside

  bool HasStructure() const noexcept { return this->Shape >= GuideShape::Inside; }
};

bool operator==(const GuideSettings& a, const GuideSettings& b);

/// Fails for missing points or more than MostPoints, a plane's points on one line, a missing
/// structure, numbers that are not finite, and stiffness, range or force that are not positive.
Status CheckGuide(const GuideSettings& settings);
} // namespace palpate
