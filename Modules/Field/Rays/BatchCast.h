#pragma once

#include "CellLanes.h"
#include "LaneArithmetic.h"
#include "RayKernel.h"
#include "RayLanes.h"

// Compiled for AVX2 alone: see RayKernel.h.

namespace palpate::rays
{
/// First hits of a batch, as many rays at a time as there are lanes: advances them, and searches
/// for hits in the cells that they reach. Rare cases are left to RayTraversal.
template <typename Set>
class BatchCast
{
public:
  static void Run(const Field& field, int count, Batch& batch)
  {
    for (int first = 0; first < count; first += Lanes)
    {
      BatchCast(field, first, batch).Run();
    }
  }

private:
  using Rays = RayLanes<Set>;
  using Cells = CellLanes<Set>;
  using Mask = typename Rays::Mask;
  using Vector = typename Rays::Vector;
  static constexpr int Lanes = Rays::Lanes;

  BatchCast(const Field& field, int first, Batch& batch) : Of(field), First(first), Answers(batch)
  {
  }

  inline __attribute__((always_inline)) void Run()
  {
    Rays rays;
    this->IsLeft = rays.Enter(this->Of, this->First, this->Answers);
    this->IsFound = Mask{};
    unsigned* startsInside = this->Answers.StartsInside + this->First;
    for (int lane = 0; lane < Lanes; ++lane)
    {
      startsInside[lane] = 0;
      this->Answers.Answer[this->First + lane] =
          this->IsLeft[lane] != 0 ? Outcome::Unstarted : Outcome::Missed;
    }
    Mask isOpen = rays.IsArrived;
    const Mask isStarted = isOpen;
    for (;;)
    {
      rays.Move(this->Of, startsInside);
      isOpen &= rays.IsUnderway();
      if (!Rays::IsAny(isOpen))
      {
        break;
      }
      Mask isPassing = this->Examine(rays, isOpen);
      isOpen &= ~this->IsFound & ~this->IsLeft;
      rays.IsFirst &= ~isPassing;
      rays.IsWalking = isPassing;
      rays.Walk(this->Of);
    }
    for (int lane = 0; lane < Lanes; ++lane)
    {
      const bool isAtEnd = rays.T[lane] >= rays.GridEnd[lane] && this->IsFound[lane] == 0;
      if (isStarted[lane] != 0 && startsInside[lane] != 0 &&
          (rays.StartsOutside[lane] != 0 || isAtEnd))
      {
        this->Answers.Answer[this->First + lane] = Outcome::Unstarted; // it meets the border
      }
    }
  }

  // The cells that are examined together, lane by lane.
  struct Candidates
  {
    const void* Nodes[Lanes];
    double Iso[Lanes];
    double Sign[Lanes];
    int Material[Lanes];
    int Type;
  };

  // Whether a cell is solved here, with the type of these candidates. Sets `isHard` if it is not
  // solved here.
  inline __attribute__((always_inline)) bool Find(long surfaceAt, long brick, int bit, int lane,
                                                  Candidates& candidates, bool& isHard) const
  {
    constexpr int Side = Cells::Side;
    const unsigned char* surface = this->Of.Surfaces + surfaceAt;
    const unsigned wanted =
        Rays::template Read<unsigned>(surface + Rays::MaterialsAt) & this->Of.Wanted;
    const int number = __builtin_ctz(wanted);
    const Material& material = this->Of.Materials[number];
    isHard = (wanted & (wanted - 1)) != 0 || !material.IsSimple;
    if (isHard || (candidates.Type >= 0 && candidates.Type != material.Type))
    {
      return false;
    }
    constexpr unsigned long Bytes[] = {1, 1, 2, 2, 4, 8};
    constexpr int Low = (1 << BrickShift) - 1;
    const int node =
        ((bit >> (2 * BrickShift)) * Side + (bit >> BrickShift & Low)) * Side + (bit & Low);
    const unsigned long offset =
        material.Codes[brick] * material.Stride + static_cast<unsigned long>(node);
    candidates.Type = material.Type;
    candidates.Nodes[lane] =
        static_cast<const unsigned char*>(material.Blocks) + offset * Bytes[material.Type];
    candidates.Iso[lane] = material.Iso;
    candidates.Sign[lane] = material.Sign;
    candidates.Material[lane] = number;
    return true;
  }

  void Leave(const Rays& rays, int lane)
  {
    const int ray = this->First + lane;
    this->Answers.Answer[ray] = rays.IsFirst[lane] != 0 ? Outcome::Unstarted : Outcome::Underway;
    this->Answers.T[ray] = rays.T[lane];
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Answers.Cell[ray][axis] = static_cast<int>(rays.Cell(axis)[lane]);
    }
  }

  // Examines the cells of the waiting lanes. Returns the lanes without a hit, which continue.
  inline __attribute__((always_inline)) Mask Examine(const Rays& rays, const Mask& isCandidate)
  {
    Vector corner[3];
    rays.GetCorners(corner);
    const Mask brick = Rays::CellsTimesBrick(this->Of, corner, isCandidate) >> BrickShift;
    Candidates candidates;
    candidates.Type = -1;
    const void* any = nullptr;
    Mask isIn{};
    Mask isLeft{};
    Mask isPassing{};
    for (int lane = 0; lane < Lanes; ++lane)
    {
      bool isHard = false;
      candidates.Nodes[lane] = any;
      candidates.Iso[lane] = 0.0;
      candidates.Sign[lane] = 1.0;
      candidates.Material[lane] = 0;
      if (isCandidate[lane] != 0)
      {
        const int bit = static_cast<int>(rays.Bit[lane]);
        isIn[lane] =
            this->Find(rays.Surface[lane], brick[lane], bit, lane, candidates, isHard) ? -1 : 0;
        isLeft[lane] = isHard ? -1 : 0;
        any = candidates.Nodes[lane];
      }
    }
    if (any != nullptr)
    {
      for (const void*& nodes : candidates.Nodes)
      {
        nodes = nodes == nullptr ? any : nodes;
      }
      const Mask isFree =
          rays.IsFirst & ~Rays::IsAtSurface(this->Of, rays.Surface & isCandidate, rays.Bit);
      isPassing = Rays::IsAny(isIn & ~isFree) ? this->Solve(rays, candidates, isIn, isLeft)
                                              : this->Start(candidates, isIn);
    }
    for (int lane = 0; lane < Lanes; ++lane)
    {
      if (isLeft[lane] != 0)
      {
        this->Leave(rays, lane);
      }
    }
    this->IsLeft |= isLeft;
    return isPassing;
  }

  static inline __attribute__((always_inline)) Vector IsoOf(const Candidates& candidates)
  {
    return Rays::template Each<Vector>([&](int lane) { return candidates.Iso[lane]; });
  }
  static inline __attribute__((always_inline)) Vector SignOf(const Candidates& candidates)
  {
    return Rays::template Each<Vector>([&](int lane) { return candidates.Sign[lane]; });
  }

  // First cells without a surface: all nodes agree on whether the ray starts inside.
  inline __attribute__((always_inline)) Mask Start(const Candidates& candidates, const Mask& isIn)
  {
    const Vector node =
        Cells::FirstNode(candidates.Type, candidates.Nodes, IsoOf(candidates), SignOf(candidates));
    this->TellStart(candidates, isIn & (node >= 0.0));
    return isIn;
  }
  inline __attribute__((always_inline)) void TellStart(const Candidates& candidates,
                                                       const Mask& isInside)
  {
    for (int lane = 0; lane < Lanes; ++lane)
    {
      this->Answers.StartsInside[this->First + lane] |=
          isInside[lane] != 0 ? 1u << candidates.Material[lane] : 0;
    }
  }

  inline __attribute__((always_inline)) Mask Solve(const Rays& rays, const Candidates& candidates,
                                                   const Mask& isIn, Mask& isLeft)
  {
    Cells cells;
    cells.Load(candidates.Type, candidates.Nodes, IsoOf(candidates), SignOf(candidates));
    const Vector exit = this->Restrict(rays, cells);
    cells.CountCrossings();
    Mask isFound{};
    Mask isInside = cells.IsInside;
    Vector t{};
    if (Rays::IsAny(isIn & cells.IsCrossed))
    {
      cells.IsCrossed &= isIn;
      cells.Solve();
      const Vector at = rays.T + cells.Parameter * (exit - rays.T);
      t = at < exit ? at : exit;
      isFound = isIn & cells.IsCrossed & (t >= rays.TMin) & (t <= rays.TMax);
      isInside ^= cells.IsCrossed & (t < rays.TMin);
    }
    isLeft |= isIn & cells.IsManyfold;
    this->TellStart(candidates, isIn & rays.IsFirst & isInside);
    isFound &= ~isLeft;
    const Mask isPassing = isIn & ~isFound & ~isLeft;
    if (Rays::IsAny(isFound))
    {
      this->Describe(rays, cells, candidates, t, isInside, isFound);
    }
    this->IsFound |= isFound;
    return isPassing;
  }

  // CellSegment; returns when the ray leaves the cell.
  inline __attribute__((always_inline)) Vector Restrict(const Rays& rays, Cells& cells) const
  {
    Vector exits[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      exits[axis] = rays.Crossing(axis, rays.Plane[axis]);
    }
    const Vector exit = Rays::Least(Rays::Least(exits[0], exits[1]), exits[2]);
    Vector from[3];
    Vector to[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector ahead = rays.Ahead[axis];
      const Vector before = 1.0 - ahead;
      const Vector low = rays.Cell(axis);
      from[axis] = rays.Crossing(axis, low + before) == rays.T
                       ? before
                       : Within(rays.Coordinate(axis, rays.T) - low);
      to[axis] = exits[axis] == exit ? ahead : Within(rays.Coordinate(axis, exit) - low);
    }
    cells.Restrict(from, to);
    return exit;
  }
  static inline __attribute__((always_inline)) Vector Within(const Vector& u)
  {
    const Vector atMost = u < 1.0 ? u : Rays::All(1.0);
    return atMost > 0.0 ? atMost : Vector{};
  }

  // RayTraversal::Describe.
  inline __attribute__((always_inline)) void Describe(const Rays& rays, const Cells& cells,
                                                      const Candidates& candidates, const Vector& t,
                                                      const Mask& isInside, const Mask& isFound)
  {
    Vector u[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      u[axis] = Within(rays.Coordinate(axis, t) - rays.Cell(axis));
    }
    Vector gradient[3];
    cells.Gradient(u, gradient);
    for (int lane = 0; lane < Lanes; ++lane)
    {
      if (isFound[lane] == 0)
      {
        continue;
      }
      const int ray = this->First + lane;
      this->Answers.Answer[ray] = Outcome::Surface;
      this->Answers.T[ray] = t[lane];
      this->Answers.Material[ray] = candidates.Material[lane];
      this->Answers.IsEntering[ray] = isInside[lane] == 0;
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Answers.Gradient[ray][axis] = gradient[axis][lane];
      }
    }
  }

  const Field& Of;
  int First; ///< ray of the batch
  Batch& Answers;
  Mask IsFound; ///< has its hit
  Mask IsLeft;  ///< left to RayTraversal
};
} // namespace palpate::rays
