#pragma once

#include "BrickWalk.h"
#include "FieldHit.h"
#include "MaterialCrossings.h"
#include "RayPath.h"
#include "ScalarField.h"

#include <algorithm>

namespace palpate
{
/// Traverses a field along one ray: it leaps over bricks without a surface, and walks from cell to
/// cell in the others (Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing",
/// Eurographics 1987, with planes instead of increments). All in index coordinates. `Cell` is the
/// interpolation.
template <typename Cell>
class RayTraversal
{
public:
  RayTraversal(const ScalarField& field, const RayPath& path, double tMin, double tMax,
               MaterialSet materials) noexcept
      : Field(field), Layout(field.Layout()), Path(path), TMin(tMin), TMax(tMax), Wanted(materials)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->CellCount[axis] = this->Layout.Nodes[static_cast<std::size_t>(axis)] - 1;
    }
  }

  FieldHit Run() noexcept
  {
    FieldHit hit;
    if (!this->Enter())
    {
      return hit;
    }
    const MaterialSet inside = this->ExamineStart(hit);
    if (this->StartsOutside && inside != 0)
    {
      return this->BorderHit(true, inside);
    }
    hit.StartsInside = inside;
    return this->GoOn(hit);
  }

  /// The same, starting at a cell that the ray enters at t, after its first cell.
  FieldHit RunFrom(const int* cell, double t, MaterialSet startsInside) noexcept
  {
    FieldHit hit;
    hit.StartsInside = startsInside;
    this->GridEnd = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
    {
      this->At[axis] = cell[axis];
      this->GridEnd = std::min(this->GridEnd, this->Path.ExitAt(axis, this->LastCell(axis)));
    }
    this->T = t;
    return this->GoOn(hit);
  }

private:
  FieldHit GoOn(FieldHit hit) noexcept
  {
    while (hit.Kind == HitKind::Missed && this->T < this->GridEnd && this->T <= this->TMax)
    {
      const BrickDirectory::Entry entry = this->Field.Directory()[this->Brick()];
      if (entry.Leap > 0)
      {
        this->GoTo(this->EndOfBox(static_cast<int>(entry.Leap)));
      }
      else
      {
        this->WalkBrick(this->Field.Directory().Surface(entry), hit);
      }
    }
    const bool isAtEnd =
        hit.Kind == HitKind::Missed && this->T >= this->GridEnd && hit.StartsInside != 0;
    return isAtEnd ? this->BorderHit(false, hit.StartsInside) : hit;
  }

  // Goes to the cell that contains the ray just before TMin, or to the first one of the grid.
  bool Enter() noexcept
  {
    constexpr double Infinity = std::numeric_limits<double>::infinity();
    double entry = -Infinity;
    this->GridEnd = Infinity;
    bool misses = false;
    for (int axis = 0; axis < 3; ++axis)
    {
      entry = std::max(entry, this->Path.EntryAt(axis, this->FirstCell(axis)));
      this->GridEnd = std::min(this->GridEnd, this->Path.ExitAt(axis, this->LastCell(axis)));
      const double at = this->Path.Coordinate(axis, 0.0);
      const auto a = static_cast<std::size_t>(axis);
      misses |= this->Path.StepOf(axis) == 0 && !(at >= 0.0 && at <= this->Layout.Nodes[a] - 1);
    }
    if (misses || entry >= this->GridEnd || this->TMin > this->GridEnd || entry > this->TMax)
    {
      return false;
    }
    this->StartsOutside = this->TMin <= entry;
    if (this->StartsOutside)
    {
      this->GoTo(entry);
      return true;
    }
    this->T = entry;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->At[axis] = this->Path.CellBefore(axis, this->TMin, this->CellCount[axis]);
      this->T = std::max(this->T, this->Path.EntryAt(axis, this->At[axis]));
    }
    return true;
  }

  int FirstCell(int axis) const noexcept
  {
    return this->Path.StepOf(axis) > 0 ? 0 : this->CellCount[axis] - 1;
  }
  int LastCell(int axis) const noexcept
  {
    return this->Path.StepOf(axis) > 0 ? this->CellCount[axis] - 1 : 0;
  }

  std::size_t Brick() const noexcept
  {
    return this->Layout.NumberOfCell(this->At[0], this->At[1], this->At[2]);
  }
  int FirstNode() const noexcept
  {
    return this->Layout.FirstNodeOfCell(this->At[0], this->At[1], this->At[2]);
  }

  // From the current cell's entry to its exit.
  CellSegment Segment() const noexcept
  {
    double exit = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
    {
      exit = std::min(exit, this->Path.ExitAt(axis, this->At[axis]));
    }
    return {this->Path, this->At, this->T, exit};
  }

  // The wanted materials that contain the ray just before TMin, or at the first cell's face. Also
  // searches for a hit in the first cell.
  MaterialSet ExamineStart(FieldHit& hit) noexcept
  {
    const BrickDirectory::Entry entry = this->Field.Directory()[this->Brick()];
    if (entry.Leap > 0)
    {
      return entry.Word & this->Wanted;
    }
    const StoredSurface surface = this->Field.Directory().Surface(entry);
    MaterialSet inside = surface.Inside() & this->Wanted;
    inside |=
        this->FindHit(surface.Materials() & this->Wanted, this->Brick(), this->Segment(), hit);
    this->IsFirstCell = true;
    return inside;
  }

  // When the ray leaves the box of bricks closer to this one than `bricks`, if that is in the grid.
  double EndOfBox(int bricks) const noexcept
  {
    double planes[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const int brick = this->At[axis] >> this->Layout.Shift;
      const int ahead = brick + 1 - bricks + this->Path.Rises(axis) * (2 * bricks - 1);
      planes[axis] = ahead * this->Layout.Cells;
    }
    const RayPath::Pair xy = this->Path.Crossings(0, RayPath::Pair{planes[0], planes[1]});
    const RayPath::Pair z = this->Path.Crossings(1, RayPath::Pair{planes[2], 0.0});
    return std::min(std::min(xy[0], xy[1]), std::min(z[0], this->GridEnd));
  }

  // Crosses all planes that are crossed at t.
  void GoTo(double t) noexcept
  {
    this->T = t;
    this->Path.GetCellAfter(t, this->CellCount, this->At);
  }

  // Walks cell by cell until the ray leaves the brick, is past TMax, or hits.
  void WalkBrick(const StoredSurface& surface, FieldHit& hit) noexcept
  {
    const std::size_t brick = this->Brick();
    const MaterialSet materials = surface.Materials() & this->Wanted;
    const double end = this->EndOfBox(1);
    BrickWalk walk(this->Path, this->At, end);
    for (;;)
    {
      if (surface.HasCell(walk.CellBit()) && !this->IsFirstCell)
      {
        walk.GetCell(this->At);
        this->FindHit(materials, brick, {this->Path, this->At, this->T, walk.Exit()}, hit);
        if (hit.Kind != HitKind::Missed)
        {
          return;
        }
      }
      this->IsFirstCell = false;
      this->T = walk.Exit();
      if (walk.IsLast() || this->T > this->TMax)
      {
        return this->GoTo(this->T);
      }
      walk.Step();
    }
  }

  // The earliest crossing of all wanted materials in this cell, from TMin on. Returns those that
  // contain the ray just before TMin or, if that is earlier, at the cell's entry.
  MaterialSet FindHit(MaterialSet materials, std::size_t brick, const CellSegment& segment,
                      FieldHit& hit) noexcept
  {
    MaterialSet inside = 0;
    double earliest = this->TMax;
    for (int m = 0; materials != 0; ++m, materials >>= 1)
    {
      if ((materials & 1u) == 0)
      {
        continue;
      }
      const MaterialCrossings<Cell> crossings(this->Field, this->Field.Material(m), brick,
                                              this->FirstNode(), segment);
      int n = 0;
      while (n < crossings.Count() && crossings[n].T < this->TMin)
      {
        ++n;
      }
      const bool isInside = crossings.IsInsideAtStart() == (n % 2 == 0);
      inside |= isInside ? OnlyMaterial(m) : 0;
      if (n < crossings.Count() && (crossings[n].T < earliest ||
                                    (crossings[n].T == earliest && hit.Kind == HitKind::Missed)))
      {
        earliest = crossings[n].T;
        hit.Material = m;
        hit.IsEntering = !isInside;
        this->Describe(crossings, crossings[n], hit);
      }
    }
    return inside;
  }

  void Describe(const MaterialCrossings<Cell>& crossings,
                const typename MaterialCrossings<Cell>::Crossing& crossing,
                FieldHit& hit) const noexcept
  {
    hit.Kind = HitKind::Surface;
    hit.T = crossing.T;
    hit.Position = this->Path.Point(crossing.T);
    double u[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      u[axis] = CellSegment::Within(hit.Position[axis] - this->At[axis]);
    }
    crossings.Relation(crossing.Condition).Gradient(u, hit.Gradient.data());
  }

  // Hit at the current position.
  FieldHit BorderHit(bool isEntering, MaterialSet inside) const noexcept
  {
    FieldHit hit;
    hit.StartsInside = isEntering ? 0 : inside;
    if (this->T > this->TMax)
    {
      return hit;
    }
    hit.Kind = HitKind::Border;
    hit.IsEntering = isEntering;
    while (!Contains(inside, ++hit.Material))
    {
    }
    hit.T = this->T;
    hit.Position = this->Path.Point(this->T);
    const int axis = this->BorderAxis(isEntering);
    hit.Gradient[axis] = (this->Path.StepOf(axis) > 0) == isEntering ? 1.0 : -1.0;
    return hit;
  }

  // The lowest axis among the grid's faces crossed now.
  int BorderAxis(bool isEntering) const noexcept
  {
    int axis = 0;
    while (axis < 2 && (isEntering ? this->Path.EntryAt(axis, this->FirstCell(axis))
                                   : this->Path.ExitAt(axis, this->LastCell(axis))) != this->T)
    {
      ++axis;
    }
    return axis;
  }

  const ScalarField& Field;
  const BrickLayout& Layout;
  const RayPath& Path;
  double TMin;
  double TMax;
  MaterialSet Wanted;
  int CellCount[3];
  int At[3];            ///< the current cell
  double T = 0.0;       ///< when the ray entered it
  double GridEnd = 0.0; ///< when the ray leaves the grid
  bool StartsOutside = false;
  bool IsFirstCell = false; ///< and already examined
};
} // namespace palpate
