#pragma once

#include "Vector3.h"

#include <vector>

namespace palpate
{
/// A stiff tool as balls along a line: a capsule, a needle, a drill with its shaft. The tool is
/// what the balls sweep from each to the next if they are closer than the surfaces that they meet
/// are curved; a flat surface and the ends are exact whatever their distance. Lengths are mm, in
/// the tool's frame.
class ToolSkeleton
{
public:
  struct Ball
  {
    Vector3 Center = Vector3::Zero();
    double Radius = 0.0;
  };

  /// Along z, `length` between the centres of the end balls, `count` >= 1 balls.
  static ToolSkeleton Capsule(double radius, double length, int count);
  /// A drill: a ball of `radius` at the origin, which cuts, and a shaft above it, along z.
  static ToolSkeleton Drill(double radius, double shaftRadius, double shaftLength, int count);
  explicit ToolSkeleton(std::vector<Ball> balls);

  const std::vector<Ball>& Balls() const noexcept { return this->All; }
  /// Of a ball around the origin that holds the tool.
  double BoundingRadius() const noexcept { return this->Extent; }
  /// How much a turn counts as a shift: the radius of gyration of the centres about the origin, no
  /// less than the largest ball's radius, so that a single ball has one too.
  double Gyration() const noexcept { return this->TurnLength; }

private:
  std::vector<Ball> All;
  double Extent = 0.0;
  double TurnLength = 1.0;
};
} // namespace palpate
