#pragma once

#include "FieldHit.h"
#include "HitError.h"
#include "MaterialCrossings.h"
#include "RayPath.h"
#include "ScalarField.h"

namespace palpate
{
/// One ray on its way through a field: over bricks without a surface it leaps, in the others it
/// goes from cell to cell (Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing",
/// Eurographics 1987, with planes instead of increments). All in index coordinates. `Cell` is the
/// interpolation.
template <typename Cell>
class RayTraversal
{
public:
  RayTraversal(const ScalarField& field, const RayPath& path, double tMin, double tMax,
               MaterialSet materials, const CoordinateRounding& rounding) noexcept
      : Field(field), Layout(field.Layout()), Path(path), TMin(tMin), TMax(tMax), Wanted(materials),
        Rounding(rounding)
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
    const MaterialSet inside = this->MaterialsAtStart();
    if (this->StartsOutside && inside != 0)
    {
      return this->BorderHit(this->T, this->Axis, true, inside);
    }
    hit.StartsInside = inside;
    while (this->IsInGrid)
    {
      const BrickDirectory::Entry entry = this->Field.Directory()[this->Brick()];
      if (entry.Leap > 0)
      {
        this->Leap(static_cast<int>(entry.Leap));
      }
      else if (this->WalkBrick(this->Field.Directory().Surface(entry), hit))
      {
        return hit;
      }
      if (this->T > this->TMax)
      {
        return hit;
      }
    }
    return inside != 0 ? this->BorderHit(this->T, this->Axis, false, inside) : hit;
  }

private:
  // Goes to the cell that the ray is in just before TMin, or to the first one of the grid.
  bool Enter() noexcept
  {
    constexpr double Infinity = std::numeric_limits<double>::infinity();
    double exit = Infinity;
    int exitAxis = 0;
    this->T = -Infinity;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int last = this->CellCount[axis] - 1;
      const int step = this->Path.StepOf(axis);
      const double at = this->Path.Coordinate(axis, 0.0);
      if (step == 0 && !(at >= 0.0 && at <= last + 1))
      {
        return false;
      }
      const double entry = this->Path.EntryAt(axis, step > 0 ? 0 : last);
      if (entry >= this->T)
      {
        this->T = entry;
        this->Axis = axis;
      }
      const double leave = this->Path.ExitAt(axis, step > 0 ? last : 0);
      if (leave < exit)
      {
        exit = leave;
        exitAxis = axis;
      }
    }
    if (this->T > exit || (this->T == exit && this->Axis >= exitAxis) || this->TMin > exit ||
        this->T > this->TMax)
    {
      return false;
    }
    this->StartsOutside = this->TMin <= this->T;
    this->StartsOutside ? this->GoToFirstCell() : this->GoToCellBefore(this->TMin);
    return true;
  }

  void GoToFirstCell() noexcept
  {
    const int entryAxis = this->Axis;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->At[axis] = this->Path.CellAt(axis, this->T, axis < entryAxis, this->CellCount[axis]);
    }
    this->At[entryAxis] = this->Path.StepOf(entryAxis) > 0 ? 0 : this->CellCount[entryAxis] - 1;
  }

  void GoToCellBefore(double t) noexcept
  {
    this->T = -std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
    {
      this->At[axis] = this->Path.CellAt(axis, t, false, this->CellCount[axis]);
      const double entry = this->Path.EntryAt(axis, this->At[axis]);
      if (entry >= this->T)
      {
        this->T = entry;
        this->Axis = axis;
      }
    }
  }

  std::size_t Brick() const noexcept
  {
    return this->Layout.NumberOfCell(this->At[0], this->At[1], this->At[2]);
  }
  int FirstNode() const noexcept
  {
    return this->Layout.FirstNodeOfCell(this->At[0], this->At[1], this->At[2]);
  }

  // From the present cell's entry to its exit.
  CellSegment Segment() const noexcept
  {
    int axis = 0;
    double exit = this->Path.ExitAt(0, this->At[0]);
    for (int a = 1; a < 3; ++a)
    {
      const double leave = this->Path.ExitAt(a, this->At[a]);
      if (leave < exit)
      {
        exit = leave;
        axis = a;
      }
    }
    return {this->Path, this->At, this->T, this->Axis, exit, axis};
  }

  // Of those wanted: just before TMin, or at the first cell's face.
  MaterialSet MaterialsAtStart() const noexcept
  {
    const BrickDirectory::Entry entry = this->Field.Directory()[this->Brick()];
    if (entry.Leap > 0)
    {
      return entry.Word & this->Wanted;
    }
    const SurfaceBrick& surface = this->Field.Directory().Surface(entry);
    const CellSegment segment = this->Segment();
    MaterialSet inside = surface.Inside & this->Wanted;
    for (int m = 0; surface.Materials >> m != 0 && m < MostMaterials; ++m)
    {
      if (!Contains(surface.Materials & this->Wanted, m))
      {
        continue;
      }
      const MaterialCrossings<Cell> crossings(this->Field, this->Field.Material(m), this->Brick(),
                                              this->FirstNode(), segment);
      bool isInside = crossings.IsInsideAtStart();
      for (int n = 0; n < crossings.Count() && crossings[n].T < this->TMin; ++n)
      {
        isInside = !isInside;
      }
      inside |= isInside ? OnlyMaterial(m) : 0;
    }
    return inside;
  }

  // Crosses the boundary of the largest box of bricks round this one that has no surface.
  void Leap(int bricks) noexcept
  {
    int last[3];
    double exit = std::numeric_limits<double>::infinity();
    int exitAxis = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int brick = this->At[axis] >> BrickLayout::Shift;
      const int ahead = (brick + bricks) * BrickLayout::Cells - 1;
      const int behind = (brick - bricks + 1) * BrickLayout::Cells;
      last[axis] = this->Path.StepOf(axis) > 0
                       ? (ahead < this->CellCount[axis] - 1 ? ahead : this->CellCount[axis] - 1)
                       : (behind > 0 ? behind : 0);
      const double leave = this->Path.ExitAt(axis, last[axis]);
      if (leave < exit)
      {
        exit = leave;
        exitAxis = axis;
      }
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      this->At[axis] = axis == exitAxis
                           ? last[axis]
                           : this->Path.CellAt(axis, exit, axis < exitAxis, this->CellCount[axis]);
    }
    this->T = exit;
    this->StepAlong(exitAxis);
  }

  void StepAlong(int axis) noexcept
  {
    this->Axis = axis;
    this->At[axis] += this->Path.StepOf(axis);
    this->IsInGrid = this->At[axis] >= 0 && this->At[axis] < this->CellCount[axis];
  }

  // Cell by cell until the ray leaves the brick; true at a hit, or past TMax.
  bool WalkBrick(const SurfaceBrick& surface, FieldHit& hit) noexcept
  {
    const std::size_t brick = this->Brick();
    const MaterialSet materials = surface.Materials & this->Wanted;
    double exits[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      exits[axis] = this->Path.ExitAt(axis, this->At[axis]);
    }
    for (;;)
    {
      const int lower = exits[1] < exits[0] ? 1 : 0;
      const int axis = exits[2] < exits[lower] ? 2 : lower;
      const double exit = exits[axis];
      if (this->MayHaveSurface(surface))
      {
        const CellSegment segment(this->Path, this->At, this->T, this->Axis, exit, axis);
        if (this->FindHit(materials, brick, segment, hit))
        {
          return true;
        }
      }
      const int before = this->At[axis];
      this->T = exit;
      this->StepAlong(axis);
      if (exit > this->TMax || !this->IsInGrid ||
          (before ^ this->At[axis]) >> BrickLayout::Shift != 0)
      {
        return false;
      }
      exits[axis] = this->Path.ExitAt(axis, this->At[axis]);
    }
  }

  bool MayHaveSurface(const SurfaceBrick& surface) const noexcept
  {
    constexpr int Mask = BrickLayout::Cells - 1;
    const int bit = (this->At[1] & Mask) * BrickLayout::Cells + (this->At[0] & Mask);
    return (surface.Cells[static_cast<std::size_t>(this->At[2] & Mask)] >> bit & 1u) != 0;
  }

  // The earliest crossing of all wanted materials in this cell, from TMin on.
  bool FindHit(MaterialSet materials, std::size_t brick, const CellSegment& segment,
               FieldHit& hit) noexcept
  {
    double earliest = this->TMax;
    for (int m = 0; materials >> m != 0; ++m)
    {
      if (!Contains(materials, m))
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
      if (n < crossings.Count() && (crossings[n].T < earliest ||
                                    (crossings[n].T == earliest && hit.Kind == HitKind::Missed)))
      {
        earliest = crossings[n].T;
        hit.Material = m;
        hit.IsEntering = crossings.IsInsideAtStart() == (n % 2 != 0);
        this->Describe(crossings, crossings[n], segment, hit);
      }
    }
    return hit.Kind != HitKind::Missed;
  }

  void Describe(const MaterialCrossings<Cell>& crossings,
                const typename MaterialCrossings<Cell>::Crossing& crossing,
                const CellSegment& segment, FieldHit& hit) const noexcept
  {
    hit.Kind = HitKind::Surface;
    hit.T = crossing.T;
    hit.Position = this->Path.Point(crossing.T);
    double u[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      u[axis] = CellSegment::Within(hit.Position[axis] - this->At[axis]);
    }
    const Cell& relation = crossings.Relation(crossing.Condition);
    relation.Gradient(u, hit.Gradient.data());
    const double coordinateError = this->Rounding.At(this->Path, crossing.T);
    const double parameterError = ParameterError(crossings.Polynomial(crossing.Condition), relation,
                                                 crossing.Parameter, coordinateError) +
                                  crossing.LastStep;
    hit.ErrorT = parameterError * (segment.T1 - segment.T0) + RoundingOfT(crossing.T);
  }

  FieldHit BorderHit(double t, int axis, bool isEntering, MaterialSet inside) const noexcept
  {
    FieldHit hit;
    hit.StartsInside = isEntering ? 0 : inside;
    if (t > this->TMax)
    {
      return hit;
    }
    hit.Kind = HitKind::Border;
    hit.IsEntering = isEntering;
    while (!Contains(inside, ++hit.Material))
    {
    }
    hit.T = t;
    hit.Position = this->Path.Point(t);
    hit.Gradient[axis] = (this->Path.StepOf(axis) > 0) == isEntering ? 1.0 : -1.0;
    hit.ErrorT = RoundingOfT(t) + this->Rounding.At(this->Path, t) * this->Path.Slowness(axis);
    return hit;
  }

  const ScalarField& Field;
  const BrickLayout& Layout;
  const RayPath& Path;
  double TMin;
  double TMax;
  MaterialSet Wanted;
  const CoordinateRounding& Rounding;
  int CellCount[3];
  int At[3];      ///< the present cell
  double T = 0.0; ///< when the ray entered it,
  int Axis = 0;   ///< and across which plane
  bool IsInGrid = true;
  bool StartsOutside = false;
};
} // namespace palpate
