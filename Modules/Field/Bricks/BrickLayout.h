#pragma once

#include <array>
#include <cstddef>

namespace palpate
{
/// How a field is interpolated between nodes.
enum class FieldInterpolation
{
  Trilinear,      ///< continuous; its gradient jumps at the faces of cells
  TricubicBSpline ///< interpolating cubic B-spline: value, gradient and curvature are continuous
};

/// How a field is interpolated and stored.
struct FieldForm
{
  FieldInterpolation Interpolation;
  bool KeepsInside;       ///< for all materials, as FieldBuilder::KeepInside; drilling requires it
  double Smoothing = 0.0; ///< voxels, of the label that it is made from: for ScalarField::Smoothing

  FieldForm(FieldInterpolation interpolation, bool keepsInside = false)
      : Interpolation(interpolation), KeepsInside(keepsInside)
  {
  }
};

/// Division of a grid into bricks of 8^3 cells. Cell i lies between the nodes i and i + 1. A brick
/// has its own copy of every node that its cells need: one node more than cells along an axis for
/// trilinear interpolation; three more for the cubic B-spline, starting one node before its first
/// cell.
struct BrickLayout
{
  static constexpr int Shift = 3;          ///< log2 of Cells
  static constexpr int Cells = 1 << Shift; ///< of a brick along an axis

  std::array<int, 3> Nodes{}; ///< of the grid
  std::array<int, 3> Bricks{};
  int Window = 2; ///< nodes that a cell needs along an axis
  int Side = 9;   ///< nodes of a brick along an axis

  BrickLayout() = default;
  BrickLayout(const std::array<int, 3>& nodes, FieldInterpolation interpolation)
      : Nodes(nodes), Window(interpolation == FieldInterpolation::Trilinear ? 2 : 4),
        Side(Cells + Window - 1)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Bricks[axis] = (nodes[axis] - 2) / this->Cells + 1;
    }
  }

  /// Number of nodes that a brick has before its first cell.
  int Apron() const noexcept { return this->Window / 2 - 1; }
  std::size_t BrickCount() const noexcept { return this->Number(0, 0, this->Bricks[2]); }
  std::size_t NodesOfBrick() const noexcept
  {
    return static_cast<std::size_t>(this->Side * this->Side * this->Side);
  }
  std::size_t Number(int i, int j, int k) const noexcept
  {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(this->Bricks[1]) +
            static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(this->Bricks[0]) +
           static_cast<std::size_t>(i);
  }
  /// The brick that a cell lies in.
  std::size_t NumberOfCell(int i, int j, int k) const noexcept
  {
    return this->Number(i >> this->Shift, j >> this->Shift, k >> this->Shift);
  }
  /// Offset of the first node that a cell needs in its brick's copy.
  int FirstNodeOfCell(int i, int j, int k) const noexcept
  {
    const int mask = this->Cells - 1;
    return ((k & mask) * this->Side + (j & mask)) * this->Side + (i & mask);
  }
};
} // namespace palpate
