#pragma once

#include "BrickedChannel.h"
#include "FieldMaterial.h"

namespace palpate
{
/// Cubic B-spline between the 64 coefficients that a cell needs; u runs from 0 to 1 along each
/// axis. The weights are not negative, and on a face those of both cells are equal bit by bit, so
/// that the guarantees of TrilinearCell hold here too.
struct TricubicCell
{
  static constexpr int Window = 4;
  static constexpr int Degree = 9; ///< of the value along a straight line
  static constexpr int Count = 64;

  double Nodes[Count]; ///< i fastest

  void Load(const BrickedChannel& channel, std::uint32_t block, int firstNode) noexcept
  {
    channel.Load<Window>(block, firstNode, this->Nodes);
  }
  /// Converts values to the condition's margin: negative where it does not hold.
  void Relate(const FieldCondition& condition) noexcept { condition.Relate(this->Nodes, Count); }

  double Value(const double* u) const noexcept;
  void Gradient(const double* u, double* gradient) const noexcept;
  /// The value along the segment between two points as ten Bernstein coefficients.
  void Restrict(const double* from, const double* to, double* bernstein) const noexcept;
};
} // namespace palpate
