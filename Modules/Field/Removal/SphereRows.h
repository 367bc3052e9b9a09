#pragma once

#include "FieldGrid.h"

#include <array>
#include <cmath>
#include <cstring>

namespace palpate
{
/// Distances (mm) from rows of nodes to a sphere swept along a segment, as floats: accurate to a
/// millionth of the distance to them. Written so that a row vectorises.
class SphereRows
{
public:
  static constexpr int Count = 8; ///< nodes of a row

  SphereRows(const FieldGrid& grid, const Vector3& from, const Vector3& path, double radius)
      : Grid(grid), From(from), Path(path.cast<float>()), Radius(static_cast<float>(radius))
  {
    constexpr double Shortest = 1e-6; // mm; shorter segments count as points
    const double squared = path.squaredNorm();
    const double perPath = squared > Shortest * Shortest ? 1.0 / squared : 0.0;
    this->PartOf = perPath * path;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector3 step = grid.VectorWorld(Vector3::Unit(axis));
      this->Steps[static_cast<std::size_t>(axis)] = step.cast<float>();
      this->Parts[axis] = static_cast<float>(step.dot(this->PartOf));
    }
  }

  /// Sets the first node of row (0, 0): whole indices.
  void Begin(const std::array<int, 3>& node) noexcept
  {
    const Vector3 offset = this->Grid.PointWorld(Vector3(node[0], node[1], node[2])) - this->From;
    this->Offset = offset.cast<float>();
    this->Part = static_cast<float>(offset.dot(this->PartOf));
  }
  /// Whether the segment's start is its nearest point to every node of row (j, k).
  bool IsBehind(int j, int k) const noexcept
  {
    const float part = this->PartAt(j, k);
    return part <= 0.0f && part + static_cast<float>(Count - 1) * this->Parts[0] <= 0.0f;
  }
  /// Lowers `kept`, the distances of row (j, k), all clamped to at least `least`, to the sphere's;
  /// returns the lowered ones, bit n for node n.
  unsigned Lower(int j, int k, float least, float* kept) const noexcept
  {
    const Eigen::Vector3f first = this->Offset + static_cast<float>(j) * this->Steps[1] +
                                  static_cast<float>(k) * this->Steps[2];
    const Eigen::Vector3f& step = this->Steps[0];
    const Lanes none = {0.0f, 0.0f, 0.0f, 0.0f};
    Lanes at = {0.0f, 1.0f, 2.0f, 3.0f};
    unsigned lowered = 0;
    for (int half = 0; half < Count / LaneCount; ++half, at += LaneCount, kept += LaneCount)
    {
      Lanes t = this->PartAt(j, k) + at * this->Parts[0];
      t = t > none ? t : none;
      t = t < none + 1.0f ? t : none + 1.0f;
      const Lanes x = first[0] + at * step[0] - t * this->Path[0];
      const Lanes y = first[1] + at * step[1] - t * this->Path[1];
      const Lanes z = first[2] + at * step[2] - t * this->Path[2];
      const Lanes square = x * x + y * y + z * z;
      Lanes distance = {std::sqrt(square[0]), std::sqrt(square[1]), std::sqrt(square[2]),
                        std::sqrt(square[3])};
      distance -= this->Radius;
      distance = distance > none + least ? distance : none + least;
      Lanes before;
      std::memcpy(&before, kept, sizeof(before));
      const auto isLower = distance < before;
      const Lanes after = isLower ? distance : before;
      std::memcpy(kept, &after, sizeof(after));
      lowered |= BitsOf(isLower) << (LaneCount * half);
    }
    return lowered;
  }

private:
  static constexpr int LaneCount = 4;
  using Lanes = float __attribute__((vector_size(LaneCount * sizeof(float))));

  template <typename Mask>
  static unsigned BitsOf(const Mask& mask) noexcept
  {
    const Mask bits = mask & Mask{1, 2, 4, 8};
    return static_cast<unsigned>(bits[0] | bits[1] | bits[2] | bits[3]);
  }
  float PartAt(int j, int k) const noexcept
  {
    return this->Part + static_cast<float>(j) * this->Parts[1] +
           static_cast<float>(k) * this->Parts[2];
  }

  const FieldGrid& Grid;
  Vector3 From;
  Vector3 PartOf; // factor from an offset to the parameter of the segment
  Eigen::Vector3f Path;
  float Radius;
  std::array<Eigen::Vector3f, 3> Steps;
  Eigen::Vector3f Parts;
  Eigen::Vector3f Offset;
  float Part = 0.0f;
};
} // namespace palpate
