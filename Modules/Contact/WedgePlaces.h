#pragma once

#include "CenteredSurfaceSample.h"
#include "TouchableSurfaceModel.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// How much room a spherical tool has above a surface model, and where it needs ContactWedge:
/// where the surface crosses itself, and where another part of the surface is nearer to the tool
/// than it is large. Elsewhere the nearest point alone holds it, in a twentieth of the time.
/// Parameters are sorted into cells on the sides of a cube.
class WedgePlaces
{
public:
  /// Tests some ten thousand places for tools up to `radius` + `reach` (mm, without the surface's
  /// margin); takes some 100 milliseconds.
  WedgePlaces(const TouchableSurfaceModel& surface, double radius, double reach);

  bool AreFor(double radius, double reach) const noexcept
  {
    return this->Radius == radius && this->Largest == radius + reach;
  }
  bool IsEmpty() const noexcept;
  /// Whether the tool needs it at this parameter, a unit vector.
  bool Contains(const Vector3& parameter) const noexcept
  {
    return this->Cells[this->CellOf(parameter)].Need == Needed;
  }
  /// Whether it needs it there or next to there: a tool that begins to use it at such a place goes
  /// on until it is outside of the rim around them.
  bool IsBeside(const Vector3& parameter) const noexcept
  {
    return this->Cells[this->CellOf(parameter)].Need != Fits;
  }
  /// How large a sphere (mm) touches the surface there and not in another part.
  double RoomAt(const Vector3& parameter) const noexcept
  {
    return this->Cells[this->CellOf(parameter)].Room;
  }
  /// Whether this minimum of the distance to a place outside is the nearest point of the surface,
  /// since there is room. False if that is not known.
  bool IsNearest(const TouchableSurfaceModel::ClosestPoint& minimum) const noexcept
  {
    constexpr double PartOfFocus = 0.5; // nearer to it, minima of the same hollow are about equal
    return minimum.SignedDistance < this->RoomAt(minimum.Direction) &&
           IsBeforeFocus(minimum.Sample, minimum.Normal, minimum.SignedDistance / PartOfFocus);
  }
  std::size_t Bytes() const noexcept { return this->Cells.size() * sizeof(Cell); }

private:
  enum Mark : unsigned char
  {
    Fits,
    Rim,
    Needed
  };
  struct Cell
  {
    Mark Need;
    float Room; // mm
  };

  std::size_t CellOf(const Vector3& parameter) const noexcept;
  void AddAround(const Vector3& parameter, double free, double width);
  void AddHollows(const TouchableSurfaceModel& surface);
  void AddCrossings(const TouchableSurfaceModel& surface, double radius);

  int Frequency; // of the directions that are tested; as many cells are on an edge of the cube
  double Radius;
  double Largest; // of the tools that are tested, mm
  std::vector<Cell> Cells;
};
} // namespace palpate
