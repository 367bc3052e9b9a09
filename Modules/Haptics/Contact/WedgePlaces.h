#pragma once

#include "ParametricTouchSurface.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// Where on a parametric surface a spherical tool needs HarmonicWedge: where the surface crosses
/// itself, and where another part of the surface is nearer to the tool than it is large. Elsewhere
/// the nearest point alone holds it, in a twentieth of the time. Parameters are sorted into cells
/// on the sides of a cube.
class WedgePlaces
{
public:
  /// Tests some thousand places for a tool of `radius` (mm, without the surface's margin); takes up
  /// to some 100 milliseconds.
  WedgePlaces(const ParametricTouchSurface& surface, double radius);

  bool IsEmpty() const noexcept;
  /// Whether the tool needs it at this parameter, a unit vector.
  bool Contains(const Vector3& parameter) const noexcept
  {
    return this->Cells[this->CellOf(parameter)] == Needed;
  }
  /// Whether it needs it there or next to there: a tool that begins to use it at such a place goes
  /// on until it is outside of the rim around them.
  bool IsBeside(const Vector3& parameter) const noexcept
  {
    return this->Cells[this->CellOf(parameter)] != Fits;
  }
  std::size_t Bytes() const noexcept { return this->Cells.size(); }

private:
  enum Cell : unsigned char
  {
    Fits,
    Rim,
    Needed
  };

  std::size_t CellOf(const Vector3& parameter) const noexcept;
  void AddAround(const Vector3& parameter);
  void AddHollows(const ParametricTouchSurface& surface, double radius);
  void AddCrossings(const ParametricTouchSurface& surface, double radius);

  int Frequency; // of the directions that are tested; as many cells are on an edge of the cube
  std::vector<Cell> Cells;
};
} // namespace palpate
