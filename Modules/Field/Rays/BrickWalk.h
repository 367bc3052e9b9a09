#pragma once

#include "BrickLayout.h"
#include "RayPath.h"

#include <algorithm>

namespace palpate
{
/// Walks from cell to cell of one brick, along a ray. The next plane is unpredictable for the
/// processor, so no step branches on it: all three axes are handled alike, in pairs.
class BrickWalk
{
public:
  /// `end` is when the ray leaves the brick, or the grid.
  BrickWalk(const RayPath& path, const int* cell, double end) noexcept : Path(path), End(end)
  {
    constexpr int Mask = BrickLayout::Cells - 1;
    double planes[4] = {};
    for (int axis = 0; axis < 3; ++axis)
    {
      planes[axis] = path.PlaneAhead(axis, cell[axis]);
      const int shift = BrickLayout::Shift * axis;
      this->Strides[axis] = path.StepOf(axis) * (1 << shift);
      this->Bit += (cell[axis] & Mask) << shift;
    }
    this->PlanesXy = Pair{planes[0], planes[1]};
    this->PlanesZ = Pair{planes[2], planes[3]};
    this->FindExit();
  }

  /// Bit of the cell in a CellSet.
  int CellBit() const noexcept { return this->Bit; }
  double Exit() const noexcept { return this->NextExit; }
  /// Whether the ray leaves the brick with this cell.
  bool IsLast() const noexcept { return this->NextExit >= this->End; }
  void GetCell(int* cell) const noexcept
  {
    cell[0] = this->Path.CellBehind(0, this->PlanesXy[0]);
    cell[1] = this->Path.CellBehind(1, this->PlanesXy[1]);
    cell[2] = this->Path.CellBehind(2, this->PlanesZ[0]);
  }

  void Step() noexcept
  {
    const Pair exit{this->NextExit, this->NextExit};
    const auto isXyNext = this->ExitsXy <= exit;
    const auto isZNext = this->ExitsZ <= exit;
    using Bits = decltype(this->ExitsXy <= exit);
    this->PlanesXy += (Pair)((Bits)this->Path.StepsOf(0) & isXyNext);
    this->PlanesZ += (Pair)((Bits)this->Path.StepsOf(1) & isZNext);
    this->Bit += (static_cast<int>(isXyNext[0]) & this->Strides[0]) +
                 (static_cast<int>(isXyNext[1]) & this->Strides[1]) +
                 (static_cast<int>(isZNext[0]) & this->Strides[2]);
    this->FindExit();
  }

private:
  using Pair = RayPath::Pair;

  void FindExit() noexcept
  {
    this->ExitsXy = this->Path.Crossings(0, this->PlanesXy);
    this->ExitsZ = this->Path.Crossings(1, this->PlanesZ);
    this->NextExit = std::min(std::min(this->ExitsXy[0], this->ExitsXy[1]), this->ExitsZ[0]);
  }

  const RayPath& Path;
  double End;
  Pair PlanesXy; ///< across which the ray leaves the cell
  Pair PlanesZ;
  Pair ExitsXy; ///< parameters of these crossings
  Pair ExitsZ;
  double NextExit = 0.0;
  int Strides[3];
  int Bit = 0;
};
} // namespace palpate
