#pragma once

#include "CellLanes.h"
#include "LaneArithmetic.h"
#include "RayKernel.h"

// Compiled for AVX2 alone: see RayKernel.h.

namespace palpate::rays
{
/// As many rays as a vector has lanes, traversing a field: the work of RayTraversal, with the same
/// numbers. A lane leaps over bricks without a surface, or walks from cell to cell in a brick with
/// one, until all lanes wait: at a cell through which a surface may pass, or at their end.
template <typename Set>
struct RayLanes : LaneArithmetic<Set>
{
  using Base = LaneArithmetic<Set>;
  using Base::Absolute;
  using Base::All;
  using Base::Lanes;
  using Base::Largest;
  using Base::Least;
  using Base::Where;
  using typename Base::Mask;
  using typename Base::Vector;
  static constexpr double BrickCells = 1 << BrickShift;
  static constexpr long MaterialsAt = 1L << (3 * BrickShift - 3); ///< after the bits of the cells

  // The rays.
  Vector Origin[3];
  Vector Direction[3];
  Vector From[3];
  Vector Inverse[3];
  Vector Step[3];
  Vector Ahead[3]; ///< 1 where the ray rises, else 0
  Mask IsRising[3];
  Mask IsMoving[3];
  Mask Stride[3]; ///< from cell to cell, in a CellSet
  Vector GridEnd;
  Vector TMin;
  Vector TMax;
  // Their positions.
  Vector T;           ///< when the cell was entered
  Vector Plane[3];    ///< across which it is left
  Vector BrickEnd{};  ///< when the lane leaves the brick in which it walks
  Mask Surface{};     ///< that brick, in bytes
  Mask Bit{};         ///< of the cell in its CellSet
  Mask StartsOutside; ///< of the grid
  // Their activity; lanes with none wait.
  Mask IsArrived; ///< in a brick that is not yet looked up
  Mask IsWalking;
  Mask IsFirst; ///< in the first cell, which is not yet examined

  inline __attribute__((always_inline)) Vector Crossing(int axis, const Vector& plane) const
  {
    return (plane - this->From[axis]) * this->Inverse[axis];
  }
  inline __attribute__((always_inline)) Vector Coordinate(int axis, const Vector& t) const
  {
    return this->Origin[axis] + t * this->Direction[axis];
  }
  inline __attribute__((always_inline)) Vector Cell(int axis) const
  {
    return this->Plane[axis] - this->Ahead[axis];
  }
  inline __attribute__((always_inline)) Mask IsUnderway() const
  {
    return (this->T < this->GridEnd) & (this->T <= this->TMax);
  }

  // The plane ahead of all planes crossed before t, or at t if `isAfter`. Rounding puts no
  // coordinate beyond the nearest plane: rays long enough for that are left to RayTraversal.
  inline __attribute__((always_inline)) Vector PlaneAfter(int axis, const Vector& t,
                                                          const Mask& isAfter) const
  {
    const Vector nearest = Base::Nearest(this->Coordinate(axis, t));
    const Vector crossing = this->Crossing(axis, nearest);
    const Mask isCrossed = (crossing < t) | ((crossing == t) & isAfter);
    return nearest + Where(isCrossed, this->Step[axis]);
  }

  /// Reads consecutive rays of the batch. Returns the lanes that are unfit for vector processing;
  /// those that miss the grid become inactive.
  inline __attribute__((always_inline)) Mask Enter(const Field& field, int first,
                                                   const Batch& batch)
  {
    constexpr double Infinity = __builtin_inf();
    this->TMin = Get(batch.TMin + first);
    this->TMax = Get(batch.TMax + first);
    Mask isGood = (this->TMin == this->TMin) & (this->TMax == this->TMax);
    Mask isAny{};
    Mask isMissed = this->TMin > this->TMax;
    Vector entry = All(-Infinity);
    this->GridEnd = All(Infinity);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Origin[axis] = Get(batch.Origin[axis] + first);
      this->Direction[axis] = Get(batch.Direction[axis] + first);
      isGood &= this->Divide(axis);
      isAny |= this->IsMoving[axis];
      const Vector cells = All(field.Cells[axis]);
      const Vector last = Where(this->IsRising[axis], cells);
      const Vector start = this->Crossing(axis, cells - last);
      entry = Largest(entry, this->IsMoving[axis] ? start : All(-Infinity));
      this->GridEnd = Least(this->GridEnd, this->Crossing(axis, last));
      const Vector at = this->Coordinate(axis, Vector{});
      isMissed |= ~this->IsMoving[axis] & ~((at >= 0.0) & (at <= cells));
    }
    isMissed |= (entry >= this->GridEnd) | (this->TMin > this->GridEnd) | (entry > this->TMax);
    isGood &= isAny;
    this->StartsOutside = this->TMin <= entry;
    this->IsArrived = isGood & ~isMissed;
    this->IsFirst = this->IsArrived;
    this->IsWalking = Mask{};
    this->Place(field, entry);
    return ~isGood;
  }

  // RayPath::Set along one axis. Returns false if, due to the rounding of t, planes might not be
  // crossed in order, or coordinates be wrong by a fraction of a voxel.
  inline __attribute__((always_inline)) Mask Divide(int axis)
  {
    constexpr double Infinity = __builtin_inf();
    constexpr double Far = 1e12;
    constexpr double Extreme = 1e100;
    const Vector inverse = 1.0 / this->Direction[axis];
    this->IsMoving[axis] = Absolute(inverse) < Infinity;
    this->From[axis] = this->IsMoving[axis] ? this->Origin[axis] : All(-Infinity);
    this->Inverse[axis] = this->IsMoving[axis] ? inverse : All(Infinity);
    this->Step[axis] = Where(this->IsMoving[axis], inverse > 0.0 ? All(1.0) : All(-1.0));
    this->Orient(axis);
    return (Absolute(this->Origin[axis]) < Far) & (Absolute(this->Direction[axis]) < Extreme) &
           ((Absolute(inverse) < Extreme) | (this->Direction[axis] == 0.0));
  }
  inline __attribute__((always_inline)) void Orient(int axis)
  {
    this->IsMoving[axis] = this->Step[axis] != 0.0;
    this->IsRising[axis] = this->Step[axis] > 0.0;
    this->Ahead[axis] = Where(this->IsRising[axis], All(1.0));
    this->Stride[axis] = (this->IsRising[axis] & (2LL << (BrickShift * axis))) -
                         (this->IsMoving[axis] & (1LL << (BrickShift * axis)));
  }

  // Places the rays in their first cells: where they enter the grid, or where they are just before
  // TMin.
  inline __attribute__((always_inline)) void Place(const Field& field, const Vector& entry)
  {
    const Vector start = this->StartsOutside ? entry : this->TMin;
    this->T = entry;
    for (int axis = 0; axis < 3; ++axis)
    {
      // Along an axis without movement: the integer part; on the grid's last face the last cell.
      const Vector place = Least(this->Origin[axis], All(field.Cells[axis] - 1));
      const Vector nearest = Base::Nearest(place);
      const Vector still = Largest(nearest - Where(nearest > place, All(1.0)), Vector{});
      const Vector plane = this->PlaneAfter(axis, start, this->StartsOutside);
      this->Plane[axis] = this->IsMoving[axis] ? plane : still;
      const Vector behind = this->Crossing(axis, this->Cell(axis) + 1.0 - this->Ahead[axis]);
      const Mask isLater = ~this->StartsOutside & this->IsMoving[axis];
      this->T = isLater ? Largest(this->T, behind) : this->T;
    }
  }
  static inline __attribute__((always_inline)) Vector Get(const double* first)
  {
    Vector vector;
    __builtin_memcpy(&vector, first, sizeof(vector));
    return vector;
  }

  template <typename T>
  static inline __attribute__((always_inline)) T Read(const unsigned char* from)
  {
    T value;
    __builtin_memcpy(&value, from, sizeof(value));
    return value;
  }

  /// Lowest corners of the lanes' bricks.
  inline __attribute__((always_inline)) void GetCorners(Vector* corner) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      corner[axis] = Base::template FloorOf<1 << BrickShift>(this->Cell(axis));
    }
  }
  /// The number of each lane's brick, times the cells of a brick along an axis; 0 for lanes outside
  /// the mask.
  static inline __attribute__((always_inline)) Mask
  CellsTimesBrick(const Field& field, const Vector* corner, const Mask& mask)
  {
    return Base::Whole((corner[2] * field.BrickRows + corner[1]) * field.BrickColumns + corner[0]) &
           mask;
  }

  /// Advances until all lanes wait.
  inline __attribute__((always_inline)) void Move(const Field& field, unsigned* startsInside)
  {
    do
    {
      while (Base::IsAny(this->IsArrived))
      {
        this->Leap(field, startsInside);
      }
      this->Walk(field);
    } while (Base::IsAny(this->IsArrived));
  }

  // Lanes that have entered a brick: without a surface they leap as far as no surface is near;
  // otherwise they begin to walk.
  inline __attribute__((always_inline)) void Leap(const Field& field, unsigned* startsInside)
  {
    Vector corner[3];
    this->GetCorners(corner);
    const Mask offset = CellsTimesBrick(field, corner, this->IsArrived) * 8 >> BrickShift;
    const auto entry = Base::template Each<Mask>(
        [&](int lane) { return Read<long long>(field.Entries + offset[lane]); });
    Mask leap = entry >> 32;
    const Mask isAtSurface = this->IsArrived & (leap == 0);
    Mask isWalk = isAtSurface;
    if (Base::IsAny(isAtSurface | (this->IsArrived & this->IsFirst)))
    {
      isWalk = this->Begin(field, corner, entry, isAtSurface, startsInside);
      leap |= isAtSurface & ~isWalk & 1; // no wanted material
    }
    const Mask isLeaping = this->IsArrived & ~isWalk;
    if (Base::IsAny(isLeaping))
    {
      this->LeaveBox(corner, BrickCells * Base::OfWhole(leap), isLeaping);
    }
    this->IsArrived = isLeaping & this->IsUnderway();
  }

  // Advances to the end of the box that extends `reach` cells from the brick's far face, and one
  // brick less to all other sides.
  inline __attribute__((always_inline)) void LeaveBox(const Vector* corner, const Vector& reach,
                                                      const Mask& isLeaping)
  {
    Vector ends[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector side = this->IsRising[axis] ? reach : BrickCells - reach;
      ends[axis] = this->Crossing(axis, corner[axis] + side);
    }
    const Vector t = Least(Least(ends[0], ends[1]), Least(ends[2], this->GridEnd));
    this->T = isLeaping ? t : this->T;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector nearest = Base::Nearest(this->Coordinate(axis, t));
      const Mask isCrossed = this->Crossing(axis, nearest) <= t;
      const Vector plane = nearest + Where(isCrossed, this->Step[axis]);
      this->Plane[axis] = isLeaping & this->IsMoving[axis] ? plane : this->Plane[axis];
    }
  }

  // Which lanes at a brick with a surface begin to walk: those where a wanted material's surface
  // passes. For lanes in their first cell it adds the materials that fill the brick.
  inline __attribute__((always_inline)) Mask Begin(const Field& field, const Vector* corner,
                                                   const Mask& entry, const Mask& isAtSurface,
                                                   unsigned* startsInside)
  {
    const Mask surface = (entry & 0xFFFFFFFFLL & isAtSurface) << 3;
    const auto materials = Base::template Each<Mask>(
        [&](int lane) { return Read<long long>(field.Surfaces + surface[lane] + MaterialsAt); });
    const Mask isWalk = isAtSurface & ((materials & field.Wanted) != 0);
    const Mask isNew = this->IsArrived & this->IsFirst;
    if (Base::IsAny(isNew))
    {
      const Mask inside = isAtSurface ? materials >> 32 : entry;
      for (int lane = 0; lane < Lanes; ++lane)
      {
        startsInside[lane] |= static_cast<unsigned>((inside & isNew & field.Wanted)[lane]);
      }
    }
    Vector end = this->GridEnd;
    Vector bit{};
    for (int axis = 2; axis >= 0; --axis)
    {
      bit = BrickCells * bit + (this->Cell(axis) - corner[axis]);
      end = Least(
          end, this->Crossing(axis, corner[axis] + Where(this->IsRising[axis], All(BrickCells))));
    }
    this->BrickEnd = isWalk ? end : this->BrickEnd;
    this->Bit = isWalk ? Base::Whole(bit) : this->Bit;
    this->Surface = isWalk ? surface : this->Surface;
    // For lanes that start without a surface nearby, the start is known already; they wait if
    // inside.
    this->IsFirst &= isWalk | ~this->IsArrived;
    this->IsWalking |= isWalk & ~this->IsFirst;
    this->IsWalking &= ~IsAtSurface(field, this->Surface & this->IsWalking, this->Bit);
    return isWalk;
  }

  /// Moves walking lanes from cell to cell until they wait or leave the brick. No step waits to
  /// know whether it is needed: all lanes advance, and their state is kept while it is.
  inline __attribute__((always_inline)) void Walk(const Field& field)
  {
    const Mask isWalker = this->IsWalking;
    const Mask surface = this->Surface & isWalker;
    Vector plane[3] = {this->Plane[0], this->Plane[1], this->Plane[2]};
    Mask bit = this->Bit;
    Mask isWaiting{};
    while (Base::IsAny(this->IsWalking))
    {
      const Vector t = this->NextCell(plane, bit);
      this->T = this->IsWalking ? t : this->T;
      this->Bit = this->IsWalking ? bit : this->Bit;
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Plane[axis] = this->IsWalking ? plane[axis] : this->Plane[axis];
      }
      const Mask isCandidate = IsAtSurface(field, surface, bit);
      const Mask isIn = this->IsWalking & (t < this->BrickEnd) & (t <= this->TMax);
      isWaiting |= isIn & isCandidate;
      this->IsWalking = isIn & ~isCandidate;
    }
    this->IsArrived |= isWalker & ~isWaiting & this->IsUnderway();
  }
  // Advances into the next cell; returns the parameter.
  inline __attribute__((always_inline)) Vector NextCell(Vector* plane, Mask& bit) const
  {
    Vector exits[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      exits[axis] = this->Crossing(axis, plane[axis]);
    }
    const Vector t = Least(Least(exits[0], exits[1]), exits[2]);
    for (int axis = 0; axis < 3; ++axis)
    {
      const Mask isCrossed = exits[axis] <= t;
      plane[axis] += Where(isCrossed, this->Step[axis]);
      bit += isCrossed & this->Stride[axis];
    }
    return t;
  }
  // Lanes in a cell through which a surface may pass; valid for any value of the bit.
  static inline __attribute__((always_inline)) Mask
  IsAtSurface(const Field& field, const Mask& surface, const Mask& bit)
  {
    const Mask at = surface + (bit >> 3 & (MaterialsAt - 8));
    const auto word = Base::template Each<Mask>(
        [&](int lane) { return Read<long long>(field.Surfaces + at[lane]); });
    return -(word >> (bit & 63) & 1);
  }
};
} // namespace palpate::rays
