#pragma once

#include "BrickedChannel.h"
#include "FieldMaterial.h"

namespace palpate
{
/// Trilinear interpolation between the eight nodes of a cell; u runs from 0 to 1 along each axis.
///
/// Values are means, taken axis after axis, as a (1 - u) + b u. With the rounding of this form, the
/// value on a face is the same bit by bit from both of its cells, and a value between nodes of one
/// sign has that sign; a + u (b - a) guarantees neither. This is what prevents rays from leaking.
struct TrilinearCell
{
  static constexpr int Window = 2;
  static constexpr int Degree = 3; ///< of the value along a straight line
  static constexpr int Count = 8;

  double Nodes[Count]; ///< i fastest

  void Load(const BrickedChannel& channel, std::uint32_t block, int firstNode) noexcept
  {
    channel.Load<Window>(block, firstNode, this->Nodes);
  }
  /// Converts values to the condition's margin: negative where it does not hold.
  void Relate(const FieldCondition& condition) noexcept { condition.Relate(this->Nodes, Count); }

  double Value(const double* u) const noexcept
  {
    double rows[4];
    for (int r = 0; r < 4; ++r)
    {
      rows[r] = Mean(this->Nodes[2 * r], this->Nodes[2 * r + 1], u[0]);
    }
    return Mean(Mean(rows[0], rows[1], u[1]), Mean(rows[2], rows[3], u[1]), u[2]);
  }

  void Gradient(const double* u, double* gradient) const noexcept
  {
    double rows[4];
    double slopes[4];
    for (int r = 0; r < 4; ++r)
    {
      rows[r] = Mean(this->Nodes[2 * r], this->Nodes[2 * r + 1], u[0]);
      slopes[r] = this->Nodes[2 * r + 1] - this->Nodes[2 * r];
    }
    gradient[0] = Mean(Mean(slopes[0], slopes[1], u[1]), Mean(slopes[2], slopes[3], u[1]), u[2]);
    gradient[1] = Mean(rows[1] - rows[0], rows[3] - rows[2], u[2]);
    gradient[2] = Mean(rows[2], rows[3], u[1]) - Mean(rows[0], rows[1], u[1]);
  }

  /// The value along the segment between two points as Bernstein coefficients: the value is a cubic
  /// there, and its polar form is symmetric, so the inner coefficients are means of the values at
  /// points that take coordinates from both ends.
  void Restrict(const double* from, const double* to, double* bernstein) const noexcept
  {
    double near[4];
    double far[4];
    for (int r = 0; r < 4; ++r)
    {
      near[r] = Mean(this->Nodes[2 * r], this->Nodes[2 * r + 1], from[0]);
      far[r] = Mean(this->Nodes[2 * r], this->Nodes[2 * r + 1], to[0]);
    }
    const double nearNear[2] = {Mean(near[0], near[1], from[1]), Mean(near[2], near[3], from[1])};
    const double nearFar[2] = {Mean(near[0], near[1], to[1]), Mean(near[2], near[3], to[1])};
    const double farNear[2] = {Mean(far[0], far[1], from[1]), Mean(far[2], far[3], from[1])};
    const double farFar[2] = {Mean(far[0], far[1], to[1]), Mean(far[2], far[3], to[1])};
    constexpr double Third = 1.0 / 3.0;
    bernstein[0] = Mean(nearNear[0], nearNear[1], from[2]);
    bernstein[1] =
        Third * (Mean(nearNear[0], nearNear[1], to[2]) + Mean(nearFar[0], nearFar[1], from[2]) +
                 Mean(farNear[0], farNear[1], from[2]));
    bernstein[2] =
        Third * (Mean(nearFar[0], nearFar[1], to[2]) + Mean(farNear[0], farNear[1], to[2]) +
                 Mean(farFar[0], farFar[1], from[2]));
    bernstein[3] = Mean(farFar[0], farFar[1], to[2]);
  }

private:
  static double Mean(double a, double b, double u) noexcept { return a * (1.0 - u) + b * u; }
};
} // namespace palpate
