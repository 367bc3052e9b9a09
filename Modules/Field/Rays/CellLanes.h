#pragma once

#include "LaneArithmetic.h"
#include "RayKernel.h"

// Compiled for AVX2 alone: see RayKernel.h.

namespace palpate::rays
{
/// Several rays, each in its own trilinear cell: the operations of TrilinearCell,
/// BernsteinCrossings, one by one, for materials with one condition and rays that
/// cross the boundary once.
template <typename Set>
struct CellLanes : LaneArithmetic<Set>
{
  using Base = LaneArithmetic<Set>;
  using Base::Absolute;
  using Base::All;
  using Base::Lanes;
  using Base::Largest;
  using Base::Mean;
  using typename Base::Integers;
  using typename Base::Mask;
  using typename Base::Vector;
  static constexpr int Side = (1 << BrickShift) + 1; // nodes of a brick along an axis

  Vector Nodes[8]; ///< margin of the condition
  Vector Polynomial[4];
  Mask IsInside;   ///< at the cell's entry
  Mask IsCrossed;  ///< once
  Mask IsManyfold; ///< perhaps crossed more than once: not solved here
  Vector Parameter;

  // Two neighbours along i for each lane, adjacent in memory.
  template <typename T>
  static inline __attribute__((always_inline)) void LoadTwo(const T* const* nodes, int offset,
                                                            Vector& first, Vector& second)
  {
    if constexpr (sizeof(T) == 2)
    {
      const auto both = Base::template Each<Integers>(
          [&](int lane)
          {
            int two = 0;
            __builtin_memcpy(&two, nodes[lane] + offset, sizeof(two));
            return two;
          });
      constexpr bool isSigned = T(-1) < T(0);
      const Integers low = isSigned ? both << 16 >> 16 : both & 0xFFFF;
      const Integers high = isSigned ? both >> 16 : both >> 16 & 0xFFFF;
      first = Base::Real(low);
      second = Base::Real(high);
    }
    else
    {
      first = Base::template Each<Vector>([&](int lane)
                                          { return static_cast<double>(nodes[lane][offset]); });
      second = Base::template Each<Vector>(
          [&](int lane) { return static_cast<double>(nodes[lane][offset + 1]); });
    }
  }

  template <typename T>
  inline __attribute__((always_inline)) void LoadAs(const T*, const void* const* first)
  {
    const T* nodes[Lanes];
    for (int lane = 0; lane < Lanes; ++lane)
    {
      nodes[lane] = static_cast<const T*>(first[lane]);
    }
    for (int row = 0; row < 4; ++row)
    {
      LoadTwo(nodes, (row & 1) * Side + (row >> 1) * Side * Side, this->Nodes[2 * row],
              this->Nodes[2 * row + 1]);
    }
  }

  // Calls `use` with a null pointer to the C++ type of a stored type's index.
  template <typename Use>
  static inline __attribute__((always_inline)) auto AsType(int type, const Use& use)
  {
    switch (type)
    {
    case 0:
      return use(static_cast<const signed char*>(nullptr));
    case 1:
      return use(static_cast<const unsigned char*>(nullptr));
    case 2:
      return use(static_cast<const short*>(nullptr));
    case 3:
      return use(static_cast<const unsigned short*>(nullptr));
    case 4:
      return use(static_cast<const float*>(nullptr));
    default:
      return use(static_cast<const double*>(nullptr));
    }
  }

  /// Margin of the condition at each cell's first node; in a cell without a surface its sign is
  /// that of the whole cell.
  static inline __attribute__((always_inline)) Vector
  FirstNode(int type, const void* const* first, const Vector& iso, const Vector& sign)
  {
    const auto node = [&](auto* as)
    {
      using T = decltype(as);
      return Base::template Each<Vector>(
          [&](int lane) { return static_cast<double>(*static_cast<T>(first[lane])); });
    };
    return sign * (AsType(type, node) - iso);
  }

  /// `first`: each cell's first node, of one type.
  inline __attribute__((always_inline)) void Load(int type, const void* const* first,
                                                  const Vector& iso, const Vector& sign)
  {
    AsType(type, [&](auto* as) { this->LoadAs(as, first); });
    for (Vector& node : this->Nodes)
    {
      node = sign * (node - iso);
    }
  }

  /// The value along the segments from `from` to `to`, as TrilinearCell::Restrict.
  inline __attribute__((always_inline)) void Restrict(const Vector* from, const Vector* to)
  {
    Vector near[4];
    Vector far[4];
    for (int r = 0; r < 4; ++r)
    {
      near[r] = Mean(this->Nodes[2 * r], this->Nodes[2 * r + 1], from[0]);
      far[r] = Mean(this->Nodes[2 * r], this->Nodes[2 * r + 1], to[0]);
    }
    const Vector nearNear[2] = {Mean(near[0], near[1], from[1]), Mean(near[2], near[3], from[1])};
    const Vector nearFar[2] = {Mean(near[0], near[1], to[1]), Mean(near[2], near[3], to[1])};
    const Vector farNear[2] = {Mean(far[0], far[1], from[1]), Mean(far[2], far[3], from[1])};
    const Vector farFar[2] = {Mean(far[0], far[1], to[1]), Mean(far[2], far[3], to[1])};
    constexpr double Third = 1.0 / 3.0;
    this->Polynomial[0] = Mean(nearNear[0], nearNear[1], from[2]);
    this->Polynomial[1] =
        Third * (Mean(nearNear[0], nearNear[1], to[2]) + Mean(nearFar[0], nearFar[1], from[2]) +
                 Mean(farNear[0], farNear[1], from[2]));
    this->Polynomial[2] =
        Third * (Mean(nearFar[0], nearFar[1], to[2]) + Mean(farNear[0], farNear[1], to[2]) +
                 Mean(farFar[0], farFar[1], from[2]));
    this->Polynomial[3] = Mean(farFar[0], farFar[1], to[2]);
  }

  inline __attribute__((always_inline)) void CountCrossings()
  {
    Mask changes{};
    for (int n = 0; n < 3; ++n)
    {
      changes += (this->Polynomial[n] >= 0.0) ^ (this->Polynomial[n + 1] >= 0.0);
    }
    this->IsInside = this->Polynomial[0] >= 0.0;
    this->IsCrossed = changes == -1;
    this->IsManyfold = changes < -1;
  }

  inline __attribute__((always_inline)) Vector Evaluate(const Vector& u, Vector& slope) const
  {
    const Vector v = 1.0 - u;
    Vector row[4] = {this->Polynomial[0], this->Polynomial[1], this->Polynomial[2],
                     this->Polynomial[3]};
    for (int length = 3; length > 1; --length)
    {
      for (int n = 0; n < length; ++n)
      {
        row[n] = row[n] * v + row[n + 1] * u;
      }
    }
    slope = 3.0 * (row[1] - row[0]);
    return row[0] * v + row[1] * u;
  }
  inline __attribute__((always_inline)) Vector LargestBend() const
  {
    Vector largest{};
    for (int n = 0; n < 2; ++n)
    {
      const Vector bend =
          this->Polynomial[n] - 2.0 * this->Polynomial[n + 1] + this->Polynomial[n + 2];
      largest = Largest(largest, Absolute(bend));
    }
    return 6.0 * largest;
  }

  /// BernsteinCrossings::Solve where the boundary is crossed once.
  inline __attribute__((always_inline)) void Solve()
  {
    constexpr int MostSteps = 60;
    constexpr double Resolution = 1e-16;
    const Vector first = this->Polynomial[0];
    const Vector last = this->Polynomial[3];
    const Mask isAtStart = (first == 0.0) & (this->Polynomial[1] < 0.0);
    const Mask isAtEnd = ~isAtStart & (last == 0.0) & (this->Polynomial[2] < 0.0);
    const Vector chord = first / (first - last);
    const Mask isBetween = (chord > 0.0) & (chord < 1.0);
    Vector u = isBetween ? chord : All(0.5);
    Vector error = All(1.0);
    Vector low{};
    Vector high = All(1.0);
    const Vector bend = this->LargestBend();
    Mask isOpen = this->IsCrossed & ~isAtStart & ~isAtEnd;
    for (int n = 0; n < MostSteps && Base::IsAny(isOpen); ++n)
    {
      Vector slope{};
      const Vector value = this->Evaluate(u, slope);
      const Mask isLow = ~((value >= 0.0) ^ this->IsInside);
      low = isLow ? u : low;
      high = isLow ? high : u;
      const Vector next = u - value / slope;
      const Mask isNewton = ~((slope < 0.0) ^ this->IsInside) & (next >= low) & (next <= high);
      const Vector newtonError = bend * (next - u) * (next - u) / Absolute(slope);
      const Vector newError = isNewton ? newtonError : high - low;
      const Vector newPlace = isNewton ? next : 0.5 * (low + high);
      error = isOpen ? newError : error;
      u = isOpen ? newPlace : u;
      isOpen &= error > Resolution;
    }
    this->Parameter = isAtStart ? Vector{} : isAtEnd ? All(1.0) : u;
  }

  /// TrilinearCell::Gradient, per voxel.
  inline __attribute__((always_inline)) void Gradient(const Vector* u, Vector* gradient) const
  {
    Vector rows[4];
    Vector slopes[4];
    for (int r = 0; r < 4; ++r)
    {
      rows[r] = Mean(this->Nodes[2 * r], this->Nodes[2 * r + 1], u[0]);
      slopes[r] = this->Nodes[2 * r + 1] - this->Nodes[2 * r];
    }
    gradient[0] = Mean(Mean(slopes[0], slopes[1], u[1]), Mean(slopes[2], slopes[3], u[1]), u[2]);
    gradient[1] = Mean(rows[1] - rows[0], rows[3] - rows[2], u[2]);
    gradient[2] = Mean(rows[2], rows[3], u[1]) - Mean(rows[0], rows[1], u[1]);
  }
};
} // namespace palpate::rays
