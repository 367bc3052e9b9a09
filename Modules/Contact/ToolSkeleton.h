#pragma once

#include "Vector3.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// A stiff tool as balls in it: a capsule, a needle, a drill with its shaft, an ellipsoid, any
/// closed surface. The tool is what the balls sweep from each to the next if they are closer than
/// the surfaces that they meet are curved. Lengths are mm, in the tool's frame.
class ToolSkeleton
{
public:
  struct Ball
  {
    Vector3 Center = Vector3::Zero();
    double Radius = 0.0;
    bool Cuts = true; ///< where the tool drills: a shaft only touches
  };
  /// Balls that lie together, by their numbers, and a ball around them.
  struct Cluster
  {
    std::size_t Begin = 0;
    std::size_t End = 0;
    Vector3 Center = Vector3::Zero();
    double Radius = 0.0;
  };
  static constexpr std::size_t ClusterSize = 12; ///< at most

  /// Along z, `length` between the centres of the end balls, `count` >= 1 balls.
  static ToolSkeleton Capsule(double radius, double length, int count);
  /// A ball of `radius` at the origin, which cuts, and a shaft above it, along z, which does not.
  static ToolSkeleton Drill(double radius, double shaftRadius, double shaftLength, int count);
  /// Along z around the origin, with flat ends, whose rims are rounded by `rim`: balls of its own
  /// radius along the axis, and at and near the ends balls of the rim's, a fifth of the radius
  /// apart.
  static ToolSkeleton Cylinder(double radius, double length, double rim);
  /// The largest balls inside, `semiAxes` (above 0) along x, y, z: centred on its medial axis, a
  /// line or an elliptic disc across the shortest axis.
  static ToolSkeleton Ellipsoid(const Vector3& semiAxes);
  /// Their order changes: those of a cluster follow each other.
  explicit ToolSkeleton(std::vector<Ball> balls);

  /// How many balls of this radius stand for a line: half a radius apart, or a radius if that is
  /// less than half a millimetre. Between them a tool is at most an eighth of a radius thinner than
  /// it should be, at a sharp edge.
  static int CountAlong(double radius, double length);

  /// Where the ellipsoid is the lowest against a direction, if that is between the touching point
  /// of this ball and those of its neighbours; of other tools, and elsewhere, the ball's own point.
  /// `direction` is a unit vector. So an ellipsoid touches with its own surface.
  Vector3 PointAgainst(const Vector3& direction, const Ball& ball) const noexcept;

  const std::vector<Ball>& Balls() const noexcept { return this->All; }
  const std::vector<Cluster>& Clusters() const noexcept { return this->Groups; }
  /// Of a ball around the origin that holds the tool.
  double BoundingRadius() const noexcept { return this->Extent; }
  /// How much a turn counts as a shift: the radius of gyration of the centres about the origin, no
  /// less than the largest ball's radius, so that a single ball has one too.
  double Gyration() const noexcept { return this->TurnLength; }

private:
  void Group(std::size_t begin, std::size_t end);

  std::vector<Ball> All;
  std::vector<Cluster> Groups;
  Vector3 SemiAxes = Vector3::Zero(); // of an ellipsoid, mm; 0 of others
  double Apart = 0.0;                 // of its balls' touching points, mm
  double Extent = 0.0;
  double TurnLength = 1.0;
};
} // namespace palpate
