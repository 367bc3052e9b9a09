#pragma once

#include "FieldGrid.h"

#include <array>
#include <cmath>

namespace palpate
{
/// Distances (mm) from rows of nodes to what a ball passes on its way, as floats: right to a
/// millionth of the way to them. Written so that a row goes through the lanes of vectors.
class SphereRows
{
public:
  static constexpr int Count = 8; ///< nodes of a row
  using Row = std::array<float, Count>;

  SphereRows(const FieldGrid& grid, const Vector3& from, const Vector3& way, double radius)
      : Grid(grid), From(from), Way(way.cast<float>()), Radius(static_cast<float>(radius))
  {
    constexpr double Shortest = 1e-6; // mm, that a float can divide by
    const double squared = way.squaredNorm();
    const double perWay = squared > Shortest * Shortest ? 1.0 / squared : 0.0;
    this->PartOf = perWay * way;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector3 step = grid.VectorWorld(Vector3::Unit(axis));
      this->Steps[static_cast<std::size_t>(axis)] = step.cast<float>();
      this->Parts[axis] = static_cast<float>(step.dot(this->PartOf));
    }
  }

  /// Of what follows, where the first node of row (0, 0) is: whole indices.
  void Begin(const std::array<int, 3>& node) noexcept
  {
    const Vector3 offset = this->Grid.PointWorld(Vector3(node[0], node[1], node[2])) - this->From;
    this->Offset = offset.cast<float>();
    this->Part = static_cast<float>(offset.dot(this->PartOf));
  }
  /// Whether no node of row (j, k) comes nearer than to the way's beginning.
  bool IsBehind(int j, int k) const noexcept
  {
    const float part = this->PartAt(j, k);
    return part <= 0.0f && part + static_cast<float>(Count - 1) * this->Parts[0] <= 0.0f;
  }
  void Distances(int j, int k, Row& distances) const noexcept
  {
    const Eigen::Vector3f first = this->Offset + static_cast<float>(j) * this->Steps[1] +
                                  static_cast<float>(k) * this->Steps[2];
    const Eigen::Vector3f& step = this->Steps[0];
    const float part = this->PartAt(j, k);
    for (int n = 0; n < Count; ++n)
    {
      const auto at = static_cast<float>(n);
      const float along = part + at * this->Parts[0];
      const float positive = along > 0.0f ? along : 0.0f;
      const float t = positive < 1.0f ? positive : 1.0f;
      const float x = first[0] + at * step[0] - t * this->Way[0];
      const float y = first[1] + at * step[1] - t * this->Way[1];
      const float z = first[2] + at * step[2] - t * this->Way[2];
      distances[static_cast<std::size_t>(n)] = std::sqrt(x * x + y * y + z * z) - this->Radius;
    }
  }

private:
  float PartAt(int j, int k) const noexcept
  {
    return this->Part + static_cast<float>(j) * this->Parts[1] +
           static_cast<float>(k) * this->Parts[2];
  }

  const FieldGrid& Grid;
  Vector3 From;
  Vector3 PartOf; // by which an offset gives the part of the way
  Eigen::Vector3f Way;
  float Radius;
  std::array<Eigen::Vector3f, 3> Steps;
  Eigen::Vector3f Parts;
  Eigen::Vector3f Offset;
  float Part = 0.0f;
};
} // namespace palpate
