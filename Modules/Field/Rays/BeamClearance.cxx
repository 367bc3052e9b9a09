#include "BeamClearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();
// Voxels; far above the rounding of any ray's index, and negligible otherwise.
constexpr double Slack = 1e-6;

struct Box
{
  Vector3 Lower;
  Vector3 Upper;
};

// A box of a grid's cells, by their lowest nodes; the last ones included.
struct CellBox
{
  int First[3];
  int Last[3];

  bool IsIn(const BrickLayout& layout) const noexcept;
  // Whether no cell, all of which must be in the grid, may contain a surface or lies in a brick
  // that a material fills.
  bool IsFree(const ScalarField& field) const noexcept;
};

// Bits of the cells first..last of a row, repeated for a number of rows of a word.
std::uint64_t RowsBits(int first, int last, int rows) noexcept
{
  constexpr std::uint64_t EveryRow = 0x0101010101010101;
  constexpr int Cells = BrickLayout::Cells;
  const std::uint64_t row = (((std::uint64_t{1} << Cells) - 1) >> (Cells - 1 - (last - first)))
                            << first;
  return row * (EveryRow >> (64 - (rows << BrickLayout::Shift)));
}

// Whether the part of the box in a brick contains no surface and no material.
bool IsFreeBrick(const ScalarField& field, const CellBox& box, const int* brick) noexcept
{
  const BrickLayout& layout = field.Layout();
  const BrickDirectory::Entry& entry =
      field.Directory()[layout.Number(brick[0], brick[1], brick[2])];
  if (entry.Leap > 0)
  {
    return entry.Word == 0;
  }
  int first[3];
  int last[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const int corner = layout.Cells * brick[axis];
    first[axis] = std::max(box.First[axis] - corner, 0);
    last[axis] = std::min(box.Last[axis] - corner, layout.Cells - 1);
  }
  const StoredSurface surface = field.Directory().Surface(entry);
  const std::uint64_t bits = RowsBits(first[0], last[0], last[1] - first[1] + 1)
                             << (first[1] << layout.Shift);
  bool isFree = true;
  for (int k = first[2]; k <= last[2]; ++k)
  {
    isFree = isFree && (surface.CellWord(static_cast<std::size_t>(k)) & bits) == 0;
  }
  return isFree;
}
bool CellBox::IsIn(const BrickLayout& layout) const noexcept
{
  bool isIn = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    isIn = isIn && this->First[axis] >= 0 && this->Last[axis] <= layout.Nodes[a] - 2;
  }
  return isIn;
}

bool CellBox::IsFree(const ScalarField& field) const noexcept
{
  const int shift = field.Layout().Shift;
  bool isFree = true;
  int brick[3];
  for (brick[2] = this->First[2] >> shift; brick[2] <= this->Last[2] >> shift; ++brick[2])
  {
    for (brick[1] = this->First[1] >> shift; brick[1] <= this->Last[1] >> shift; ++brick[1])
    {
      for (brick[0] = this->First[0] >> shift; brick[0] <= this->Last[0] >> shift; ++brick[0])
      {
        isFree = isFree && IsFreeBrick(field, *this, brick);
      }
    }
  }
  return isFree;
}

// Until when the beam's box, from t on, stays within limits along an axis; before t if it does not
// at t.
double StaysUntil(const FieldBeam& beam, int axis, double lower, double upper, double t) noexcept
{
  const double middle = beam.Center.Origin[axis];
  const double place = middle + t * beam.Center.Direction[axis];
  const double half = beam.HalfSize[axis] + t * beam.Growth[axis] + Slack;
  if (place - half < lower || place + half > upper)
  {
    return -Infinite;
  }
  const double slope = beam.Center.Direction[axis];
  const double rise = slope + beam.Growth[axis];
  const double fall = slope - beam.Growth[axis];
  double until = Infinite;
  if (rise > 0.0)
  {
    until = (upper - Slack - middle - beam.HalfSize[axis]) / rise;
  }
  if (fall < 0.0)
  {
    until = std::min(until, (lower + Slack - middle + beam.HalfSize[axis]) / fall);
  }
  return until;
}

// When the beam's box first reaches the grid; infinite if never.
double Arrival(const FieldBeam& beam, const FieldGrid& grid, double t) noexcept
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double last = grid.Size()[static_cast<std::size_t>(axis)] - 1;
    const double half = beam.HalfSize[axis] + Slack;
    const double low = beam.Center.Origin[axis] - half;
    const double high = beam.Center.Origin[axis] + half;
    const double rise = beam.Center.Direction[axis] + beam.Growth[axis];
    const double fall = beam.Center.Direction[axis] - beam.Growth[axis];
    if (high + t * rise < 0.0)
    {
      t = rise > 0.0 ? -high / rise : Infinite;
    }
    else if (low + t * fall > last)
    {
      t = fall < 0.0 ? (last - low) / fall : Infinite;
    }
  }
  return t;
}

// Bricks along i, j, k; the last ones included.
struct BrickRange
{
  int First[3];
  int Last[3];
};

int BrickOf(double place, int cells, int count) noexcept
{
  return static_cast<int>(
      std::clamp(std::floor(place / cells), 0.0, static_cast<double>(count - 1)));
}

// The bricks that the beam's box overlaps at t; beyond the grid, the nearest ones.
BrickRange Reached(const FieldBeam& beam, const BrickLayout& layout, double t) noexcept
{
  BrickRange range;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int count = layout.Bricks[static_cast<std::size_t>(axis)];
    const double place = beam.Center.Origin[axis] + t * beam.Center.Direction[axis];
    // Slightly more than StaysUntil allows, so that every range extends beyond the last one.
    const double half = beam.HalfSize[axis] + t * beam.Growth[axis] + 2.0 * Slack;
    range.First[axis] = BrickOf(place - half, layout.Cells, count);
    range.Last[axis] = BrickOf(place + half, layout.Cells, count);
  }
  return range;
}

// No surface and no material, which may end at the grid's border.
bool IsEmpty(const BrickDirectory::Entry& entry) noexcept
{
  return entry.Leap > 0 && entry.Word == 0;
}

bool IsEmpty(const ScalarField& field, const BrickRange& range) noexcept
{
  // A wider beam should be subdivided instead.
  constexpr int MostBricks = 27;
  int bricks = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    bricks *= range.Last[axis] - range.First[axis] + 1;
  }
  bool isEmpty = bricks <= MostBricks;
  for (int k = range.First[2]; k <= range.Last[2] && isEmpty; ++k)
  {
    for (int j = range.First[1]; j <= range.Last[1] && isEmpty; ++j)
    {
      for (int i = range.First[0]; i <= range.Last[0] && isEmpty; ++i)
      {
        isEmpty = IsEmpty(field.Directory()[field.Layout().Number(i, j, k)]);
      }
    }
  }
  return isEmpty;
}

// A box of bricks, extended without limit beyond the grid, which is empty there.
Box BoxOf(const BrickRange& range, const BrickLayout& layout) noexcept
{
  Box box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int first = range.First[axis];
    const int end = range.Last[axis] + 1;
    const int count = layout.Bricks[static_cast<std::size_t>(axis)];
    box.Lower[axis] = first <= 0 ? -Infinite : static_cast<double>(layout.Cells * first);
    box.Upper[axis] = end >= count ? Infinite : static_cast<double>(layout.Cells * end);
  }
  return box;
}

double StaysUntil(const FieldBeam& beam, const Box& box, double t) noexcept
{
  return std::min({StaysUntil(beam, 0, box.Lower[0], box.Upper[0], t),
                   StaysUntil(beam, 1, box.Lower[1], box.Upper[1], t),
                   StaysUntil(beam, 2, box.Lower[2], box.Upper[2], t)});
}

// Until when the beam is known to meet nothing, by the leap of its centre's brick or by the bricks
// that it overlaps; not after t if it may meet something at once.
double EmptyUntil(const ScalarField& field, const FieldBeam& beam, double t) noexcept
{
  const BrickLayout& layout = field.Layout();
  const BrickRange reached = Reached(beam, layout, t);
  int middle[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    middle[axis] = (reached.First[axis] + reached.Last[axis]) / 2;
  }
  const BrickDirectory::Entry& entry =
      field.Directory()[layout.Number(middle[0], middle[1], middle[2])];
  if (!IsEmpty(entry))
  {
    return t;
  }
  const int leap = static_cast<int>(entry.Leap) - 1;
  BrickRange around;
  for (int axis = 0; axis < 3; ++axis)
  {
    around.First[axis] = middle[axis] - leap;
    around.Last[axis] = middle[axis] + leap;
  }
  const double byLeap = StaysUntil(beam, BoxOf(around, layout), t);
  return byLeap > t || !IsEmpty(field, reached) ? byLeap
                                                : StaysUntil(beam, BoxOf(reached, layout), t);
}

// Follows a beam through slabs of cells, along the axis on which it is fastest, oriented so that
// coordinates along it increase.
class SlabMarch
{
public:
  explicit SlabMarch(const FieldBeam& beam) noexcept : Beam(beam)
  {
    Eigen::Index fastest = 0;
    beam.Center.Direction.cwiseAbs().maxCoeff(&fastest);
    this->Axis = static_cast<int>(fastest);
    this->Rises = beam.Center.Direction[fastest] > 0.0;
    const double speed = std::abs(beam.Center.Direction[fastest]);
    const double middle = (this->Rises ? 1.0 : -1.0) * beam.Center.Origin[fastest];
    this->Front = middle + beam.HalfSize[fastest] + Slack;
    this->Back = middle - beam.HalfSize[fastest] - Slack;
    this->FrontSpeed = speed + beam.Growth[fastest];
    this->BackSpeed = speed - beam.Growth[fastest];
  }

  // Whether the beam leaves a slab at all.
  bool IsMoving() const noexcept { return this->BackSpeed > 0.0; }
  double BackAt(double t) const noexcept { return this->Back + t * this->BackSpeed; }
  double EntersAt(double slab) const noexcept { return (slab - this->Front) / this->FrontSpeed; }
  double LeavesAt(double slab) const noexcept
  {
    return (slab + 1.0 - this->Back) / this->BackSpeed;
  }

  // The cells of a slab that the beam overlaps between two times; false if they are too many or not
  // all in the grid.
  bool GetCells(const BrickLayout& layout, double slab, double t0, double t1,
                CellBox& box) const noexcept
  {
    // A wider beam should be subdivided instead.
    constexpr double MostCells = 16.0;
    bool isNarrow = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = std::min(this->EdgeAt(axis, -1.0, t0), this->EdgeAt(axis, -1.0, t1));
      const double high = std::max(this->EdgeAt(axis, 1.0, t0), this->EdgeAt(axis, 1.0, t1));
      // False for NaN.
      const bool isHere = low >= 0.0 && high - low <= MostCells &&
                          high < layout.Nodes[static_cast<std::size_t>(axis)] - 1;
      isNarrow = isNarrow && (isHere || axis == this->Axis);
      box.First[axis] = isHere ? static_cast<int>(low) : 0;
      box.Last[axis] = isHere ? static_cast<int>(high) : 0;
    }
    const double cell = this->Rises ? slab : -slab - 1.0;
    const int last = layout.Nodes[static_cast<std::size_t>(this->Axis)] - 2;
    box.First[this->Axis] = static_cast<int>(std::clamp(cell, -1.0, last + 1.0));
    box.Last[this->Axis] = box.First[this->Axis];
    return isNarrow && box.IsIn(layout);
  }

private:
  double EdgeAt(int axis, double side, double t) const noexcept
  {
    return this->Beam.Center.Origin[axis] + t * this->Beam.Center.Direction[axis] +
           side * (this->Beam.HalfSize[axis] + t * this->Beam.Growth[axis] + Slack);
  }

  const FieldBeam& Beam;
  int Axis;
  bool Rises;
  double Front; // of the beam, at t = 0
  double Back;
  double FrontSpeed;
  double BackSpeed;
};

// Until when the beam, of which no ray is in a material at t, overlaps only cells of the grid
// without a surface: until then it is in no material either. Not after t if it may meet one at
// once.
double FreeUntil(const ScalarField& field, const FieldBeam& beam, double t, double tMax) noexcept
{
  const int mostSlabs = 3 * field.Layout().Cells; // after these, bricks may be empty again
  const SlabMarch march(beam);
  if (!march.IsMoving())
  {
    return t;
  }
  double slab = std::floor(march.BackAt(t));
  double entry = t;
  for (int n = 0; n < mostSlabs && entry < tMax; ++n, slab += 1.0)
  {
    entry = std::max(t, march.EntersAt(slab));
    CellBox cells;
    if (!march.GetCells(field.Layout(), slab, entry, march.LeavesAt(slab), cells) ||
        !cells.IsFree(field))
    {
      return entry;
    }
  }
  return entry;
}
} // namespace

FieldBeam BeamOf(const FieldRay (&cornersIndex)[4]) noexcept
{
  FieldBeam beam;
  beam.Center.Origin.setZero();
  beam.Center.Direction.setZero();
  for (const FieldRay& corner : cornersIndex)
  {
    beam.Center.Origin += 0.25 * corner.Origin;
    beam.Center.Direction += 0.25 * corner.Direction;
  }
  for (const FieldRay& corner : cornersIndex)
  {
    beam.HalfSize = beam.HalfSize.cwiseMax((corner.Origin - beam.Center.Origin).cwiseAbs());
    beam.Growth = beam.Growth.cwiseMax((corner.Direction - beam.Center.Direction).cwiseAbs());
  }
  return beam;
}

double ClearUntil(const ScalarField& field, const FieldBeam& beamIndex, double tMin,
                  double tMax) noexcept
{
  double t = std::max(tMin, Arrival(beamIndex, field.Grid(), tMin));
  bool isInNoMaterial = false;
  while (t < tMax)
  {
    double until = EmptyUntil(field, beamIndex, t);
    if (!(until > t) && isInNoMaterial)
    {
      until = FreeUntil(field, beamIndex, t, tMax);
    }
    if (!(until > t))
    {
      return t;
    }
    isInNoMaterial = true;
    t = until;
  }
  return tMax;
}
} // namespace palpate
