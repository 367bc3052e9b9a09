#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace palpate
{
/// How a field is interpolated between nodes.
enum class FieldInterpolation
{
  Trilinear,      ///< continuous; its gradient jumps at the faces of cells
  TricubicBSpline ///< interpolating cubic B-spline: value, gradient and curvature are continuous
};

/// Cells of a brick along an axis; the numbers are their logarithms to base 2.
enum class BrickSize
{
  Cells4 = 2,
  Cells8 = 3,
  Cells16 = 4
};
constexpr BrickSize BrickSizes[] = {BrickSize::Cells4, BrickSize::Cells8, BrickSize::Cells16};
constexpr int MostBrickCells = 16;

/// How a field is interpolated, and stored.
struct FieldForm
{
  FieldInterpolation Interpolation;
  BrickSize Bricks;
  bool KeepsInside; ///< of all materials, as FieldBuilder::KeepInside: they can be drilled

  FieldForm(FieldInterpolation interpolation, BrickSize bricks = BrickSize::Cells8,
            bool keepsInside = false)
      : Interpolation(interpolation), Bricks(bricks), KeepsInside(keepsInside)
  {
  }
};

/// Bricks side by side along i, j, k; the last ones included.
struct BrickBox
{
  std::array<int, 3> First{};
  std::array<int, 3> Last{};

  std::size_t Count() const noexcept
  {
    std::size_t count = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      count *= static_cast<std::size_t>(this->Last[axis] - this->First[axis] + 1);
    }
    return count;
  }
};

/// How a grid is cut into bricks of 4^3, 8^3 or 16^3 cells. Cell i lies between the nodes i and
/// i + 1. A brick has its own copy of every node that its cells need: one node more than cells
/// along an axis for trilinear interpolation; three more for the cubic B-spline, from one node
/// before its first. A layout covers all bricks or a box of them; coordinates of bricks and cells
/// are those of the whole grid, numbers of bricks count what is covered.
struct BrickLayout
{
  std::array<int, 3> Nodes{}; ///< of the grid
  std::array<int, 3> Bricks{};
  std::array<int, 3> FirstBrick{};
  std::array<int, 3> FirstCell{};
  std::array<int, 3> LastCell{};
  /// Continuous indices that are covered; on a face between bricks the upper one begins.
  std::array<double, 3> Lower{};
  std::array<double, 3> Upper{};
  std::size_t FirstNumber = 0; ///< of the box's first brick, if the box began with the grid
  int Shift = 3;
  int Cells = 8;  ///< of a brick along an axis
  int Window = 2; ///< nodes that a cell needs along an axis
  int Side = 9;   ///< nodes of a brick along an axis

  BrickLayout() = default;
  BrickLayout(const std::array<int, 3>& nodes, FieldInterpolation interpolation,
              BrickSize size = BrickSize::Cells8)
      : Nodes(nodes), Shift(static_cast<int>(size)), Cells(1 << Shift),
        Window(interpolation == FieldInterpolation::Trilinear ? 2 : 4), Side(Cells + Window - 1)
  {
    BrickBox all;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      all.Last[axis] = (nodes[axis] - 2) / this->Cells;
    }
    this->Cover(all);
  }

  /// The same cut, of which only a box of bricks is covered.
  BrickLayout Part(const BrickBox& box) const
  {
    BrickLayout part = *this;
    part.Cover(box);
    return part;
  }
  bool IsWhole() const noexcept
  {
    bool isWhole = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      isWhole = isWhole && this->FirstCell[axis] == 0 && this->IsLastOfGrid(axis);
    }
    return isWhole;
  }
  /// Whether the grid ends where the covered box does.
  bool IsLastOfGrid(std::size_t axis) const noexcept
  {
    return this->LastCell[axis] == this->Nodes[axis] - 2;
  }

  BrickSize Size() const noexcept { return static_cast<BrickSize>(this->Shift); }
  /// Nodes that a brick has before its first cell.
  int Apron() const noexcept { return this->Window / 2 - 1; }
  std::size_t BrickCount() const noexcept { return this->Plain(0, 0, this->Bricks[2]); }
  std::size_t NodesOfBrick() const noexcept
  {
    return static_cast<std::size_t>(this->Side * this->Side * this->Side);
  }
  std::size_t Number(int i, int j, int k) const noexcept
  {
    return this->Plain(i, j, k) - this->FirstNumber;
  }
  /// The brick that a cell lies in.
  std::size_t NumberOfCell(int i, int j, int k) const noexcept
  {
    return this->Number(i >> this->Shift, j >> this->Shift, k >> this->Shift);
  }
  /// Where the first node that a cell needs stands in its brick's copy.
  int FirstNodeOfCell(int i, int j, int k) const noexcept
  {
    const int mask = this->Cells - 1;
    return ((k & mask) * this->Side + (j & mask)) * this->Side + (i & mask);
  }

private:
  std::size_t Plain(int i, int j, int k) const noexcept
  {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(this->Bricks[1]) +
            static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(this->Bricks[0]) +
           static_cast<std::size_t>(i);
  }
  void Cover(const BrickBox& box)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->FirstBrick[axis] = box.First[axis];
      this->Bricks[axis] = box.Last[axis] - box.First[axis] + 1;
      this->FirstCell[axis] = this->Cells * box.First[axis];
      const int end = this->Cells * (box.Last[axis] + 1);
      const int cells = this->Nodes[axis] - 1;
      this->LastCell[axis] = std::min(end, cells) - 1;
      this->Lower[axis] = this->FirstCell[axis];
      this->Upper[axis] = end < cells ? std::nextafter(static_cast<double>(end), 0.0) : cells;
    }
    this->FirstNumber = this->Plain(box.First[0], box.First[1], box.First[2]);
  }
};
} // namespace palpate
