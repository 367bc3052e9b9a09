#pragma once

#include "Vector3.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
/// A ray in index coordinates and the planes between cells that it crosses. The parameter of a
/// crossing depends on the ray and the plane alone, and planes crossed at the same parameter are
/// crossed together. So a ray's cells are one sequence, however and from wherever it is walked.
class RayPath
{
public:
  /// Two doubles, as in SSE2 and NEON (vector extension of GCC and Clang).
  typedef double Pair __attribute__((vector_size(16)));
  typedef int Whole __attribute__((vector_size(8)));

  /// Returns false for an invalid ray.
  bool Set(const Vector3& origin, const Vector3& direction) noexcept
  {
    constexpr double Infinity = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
    {
      const double inverse = 1.0 / direction[axis];
      const bool isMoving = std::abs(inverse) < Infinity;
      this->Step[axis] = !isMoving ? 0 : inverse > 0.0 ? 1 : -1;
      this->Ahead[axis] = this->Step[axis] > 0 ? 1 : 0;
      // An axis without movement: all its planes are crossed at infinity.
      this->From[axis] = isMoving ? origin[axis] : -Infinity;
      this->Inverse[axis] = isMoving ? inverse : Infinity;
      this->Steps[axis] = this->Step[axis];
      this->Aheads[axis] = this->Ahead[axis];
      this->Origins[axis] = origin[axis];
      this->Directions[axis] = direction[axis];
    }
    return origin.allFinite() && direction.allFinite() &&
           (this->Step[0] != 0 || this->Step[1] != 0 || this->Step[2] != 0);
  }

  /// 1 where the ray rises along an axis, else 0.
  int Rises(int axis) const noexcept { return this->Ahead[axis]; }
  int StepOf(int axis) const noexcept { return this->Step[axis]; }
  double Coordinate(int axis, double t) const noexcept
  {
    return this->Origins[axis] + t * this->Directions[axis];
  }
  Vector3 Point(double t) const noexcept
  {
    return {this->Coordinate(0, t), this->Coordinate(1, t), this->Coordinate(2, t)};
  }

  /// The plane across which the ray leaves a cell, and the inverse.
  int PlaneAhead(int axis, int cell) const noexcept { return cell + this->Ahead[axis]; }
  int CellBehind(int axis, double plane) const noexcept
  {
    return static_cast<int>(plane) - this->Ahead[axis];
  }
  /// When the ray, if within a cell's slab along an axis, leaves it; infinite without movement.
  double ExitAt(int axis, int cell) const noexcept
  {
    return this->CrossingAt(axis, this->PlaneAhead(axis, cell));
  }
  /// When the ray entered the slab; minus infinity without movement.
  double EntryAt(int axis, int cell) const noexcept
  {
    const double entry = this->CrossingAt(axis, cell + 1 - this->Ahead[axis]);
    return this->Step[axis] == 0 ? -entry : entry;
  }
  /// Two axes at once: pair 0 is i and j, pair 1 is k and nothing.
  Pair Crossings(int pair, const Pair& planes) const noexcept
  {
    return (planes - Load(this->From, pair)) * Load(this->Inverse, pair);
  }
  Pair Coordinates(int pair, double t) const noexcept
  {
    return Load(this->Origins, pair) + t * Load(this->Directions, pair);
  }
  Pair AheadOf(int pair) const noexcept { return Load(this->Aheads, pair); }
  Pair StepsOf(int pair) const noexcept { return Load(this->Steps, pair); }

  /// The cell along an axis, of `cells`, after all planes that are crossed before t.
  int CellBefore(int axis, double t, int cells) const noexcept
  {
    return this->CellWhere(axis, t, cells, [t](double crossing) { return crossing < t; });
  }
  /// The cell after all planes that are crossed before t or at t. `cells`: their number.
  void GetCellAfter(double t, const int* cells, int* cell) const noexcept
  {
    bool isRight = true;
    for (int pair = 0; pair < 2; ++pair)
    {
      const Pair last{cells[2 * pair] - 1.0, pair == 0 ? cells[1] - 1.0 : 0.0};
      const Pair place = this->Coordinates(pair, t);
      const Pair atMost = place < last ? place : last;
      const auto whole = __builtin_convertvector(atMost > 0.0 ? atMost : Pair{}, Whole);
      const Pair low = __builtin_convertvector(whole, Pair);
      const Pair ahead = this->AheadOf(pair);
      const auto isLeft = this->Crossings(pair, low + ahead) <= t;
      const auto isEntered =
          (this->Crossings(pair, low + 1.0 - ahead) <= t) | (this->StepsOf(pair) == 0.0);
      const auto isWrong = isLeft | ~isEntered;
      isRight = isRight && (isWrong[0] | isWrong[1]) == 0;
      cell[2 * pair] = whole[0];
      cell[1] = pair == 0 ? whole[1] : cell[1];
    }
    // Rounding may have chosen a neighbour, or t may be the end of the grid.
    for (int axis = 0; axis < 3 && !isRight; ++axis)
    {
      cell[axis] =
          this->CellWhere(axis, t, cells[axis], [t](double crossing) { return crossing <= t; });
    }
  }

private:
  static Pair Load(const double* axes, int pair) noexcept
  {
    return Pair{axes[2 * pair], axes[2 * pair + 1]};
  }

  double CrossingAt(int axis, int plane) const noexcept
  {
    return (plane - this->From[axis]) * this->Inverse[axis];
  }

  template <typename Predicate>
  int CellWhere(int axis, double t, int cells, const Predicate& isCrossed) const noexcept
  {
    const int step = this->Step[axis];
    const double place = step == 0 ? this->Origins[axis] : this->Coordinate(axis, t);
    // NaN, for huge t, becomes 0.
    int cell = place > 0.0 ? static_cast<int>(std::min<double>(place, cells - 1)) : 0;
    if (step == 0)
    {
      return cell;
    }
    while (isCrossed(this->ExitAt(axis, cell)) && cell + step >= 0 && cell + step < cells)
    {
      cell += step;
    }
    while (!isCrossed(this->EntryAt(axis, cell)) && cell - step >= 0 && cell - step < cells)
    {
      cell -= step;
    }
    return cell;
  }

  // Along i, j, k, and an axis without movement.
  alignas(16) double Origins[4] = {};
  alignas(16) double Directions[4] = {};
  alignas(16) double From[4] = {0.0, 0.0, 0.0, -std::numeric_limits<double>::infinity()};
  alignas(16) double Inverse[4] = {0.0, 0.0, 0.0, std::numeric_limits<double>::infinity()};
  alignas(16) double Steps[4] = {};
  alignas(16) double Aheads[4] = {};
  int Step[3];
  int Ahead[3]; ///< from a cell to the plane across which the ray leaves it
};
} // namespace palpate
