#include "RemovalStroke.h"

#include "SphereRows.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr int Side = RemovedDistances::Side;

using Row = std::array<float, Side>;

// Rows of a block as a tool's sweep has them: of any tool, and of a ball.
class AnyRows
{
public:
  AnyRows(const CutSweep& sweep, const FieldGrid& grid) : Sweep(sweep), Grid(grid) {}

  void Begin(const RemovedDistances::Corner& corner)
  {
    this->First = Vector3(corner[0], corner[1], corner[2]);
  }
  bool Distances(int j, int k, Row& distances) const
  {
    for (int i = 0; i < Side; ++i)
    {
      const Vector3 point = this->Grid.PointWorld(this->First + Vector3(i, j, k));
      distances[static_cast<std::size_t>(i)] = static_cast<float>(this->Sweep.Distance(point));
    }
    return true;
  }

private:
  const CutSweep& Sweep;
  const FieldGrid& Grid;
  Vector3 First = Vector3::Zero();
};

class BallRows
{
public:
  BallRows(const CutSweep& sweep, const FieldGrid& grid, bool goesOn)
      : Rows(grid, sweep.FromWorld(), sweep.WayWorld(), sweep.Radius()), GoesOn(goesOn)
  {
    static_assert(SphereRows::Count == Side);
  }

  void Begin(const RemovedDistances::Corner& corner) { this->Rows.Begin(corner); }
  // False where nothing is nearer than before.
  bool Distances(int j, int k, Row& distances) const
  {
    if (this->GoesOn && this->Rows.IsBehind(j, k))
    {
      return false;
    }
    this->Rows.Distances(j, k, distances);
    return true;
  }

private:
  SphereRows Rows;
  bool GoesOn;
};

// Holds distances within the limit; answers whether any is less than what is kept.
bool Clip(Row& distances, float limit, const float* kept)
{
  unsigned isAny = 0;
  for (std::size_t n = 0; n < Side; ++n)
  {
    const float d = distances[n] > -limit ? distances[n] : -limit;
    distances[n] = d;
    isAny |= static_cast<unsigned>(d < kept[n]);
  }
  return isAny != 0;
}

struct Stretch
{
  int First;
  int Last;
};

// From the first to the last of `count` nodes that are nearer than what is kept.
Stretch LowerNodes(const Row& distances, const float* kept, int count)
{
  const auto isLower = [&](int n)
  { return distances[static_cast<std::size_t>(n)] < kept[static_cast<std::size_t>(n)]; };
  Stretch lower{0, count - 1};
  while (lower.First < count && !isLower(lower.First))
  {
    ++lower.First;
  }
  while (lower.Last > lower.First && !isLower(lower.Last))
  {
    --lower.Last;
  }
  return lower;
}

void Lower(const Row& distances, int count, float* kept)
{
  for (int n = 0; n < count; ++n)
  {
    kept[n] = std::min(kept[n], distances[static_cast<std::size_t>(n)]);
  }
}

// Blocks along each axis that a box meets, cut to the grid.
struct BlockRange
{
  std::array<int, 3> First{};
  std::array<int, 3> Last{};
};

// Node indices of a box in the world, `around` more on each side.
BlockRange RangeOf(const FieldGrid& grid, const Eigen::AlignedBox3d& boxWorld, double around)
{
  Eigen::AlignedBox3d index;
  for (int n = 0; n < 8; ++n)
  {
    const auto corner = static_cast<Eigen::AlignedBox3d::CornerType>(n);
    index.extend(grid.PointIndex(boxWorld.corner(corner)));
  }
  BlockRange range;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<Eigen::Index>(axis);
    const double margin = around / grid.Spacing()[a];
    const double end = grid.Size()[axis] - 1;
    const double first = std::clamp(std::ceil(index.min()[a] - margin), 0.0, end + 1.0);
    const double last = std::clamp(std::floor(index.max()[a] + margin), -1.0, end);
    range.First[axis] = static_cast<int>(first) / Side;
    range.Last[axis] = first <= last ? static_cast<int>(last) / Side : range.First[axis] - 1;
  }
  return range;
}
} // namespace

RemovalStroke::RemovalStroke(std::shared_ptr<const RemovedDistances> before)
    : Start(std::move(before))
{
  this->Begin();
}

void RemovalStroke::Begin()
{
  this->Working = std::shared_ptr<RemovedDistances>(new RemovedDistances(*this->Start));
  this->Working->Depth = this->Start->Depth + 1;
  this->IsChanged = false;
}

std::shared_ptr<const RemovedDistances> RemovalStroke::Finish()
{
  if (this->IsChanged)
  {
    this->Start = std::move(this->Working);
    this->Begin();
  }
  return this->Start;
}

void RemovalStroke::Cut(const CutSweep& sweep, std::vector<NodeBox>& changed)
{
  changed.clear();
  if (!sweep.IsOfSphere())
  {
    AnyRows rows(sweep, this->Working->Frame);
    return this->CutWith(rows, sweep, changed);
  }
  // What lies behind a way that goes on is no nearer to it than to where it begins.
  const bool goesOn =
      this->Last.Radius == sweep.Radius() && this->Last.EndWorld == sweep.FromWorld();
  BallRows rows(sweep, this->Working->Frame, goesOn);
  this->CutWith(rows, sweep, changed);
  this->Last = {sweep.Radius(), sweep.FromWorld() + sweep.WayWorld()};
}

template <typename Rows>
void RemovalStroke::CutWith(Rows& rows, const CutSweep& sweep, std::vector<NodeBox>& changed)
{
  const BlockRange range = RangeOf(this->Working->Frame, sweep.BoundsWorld(), this->Working->Limit);
  for (int k = range.First[2]; k <= range.Last[2]; ++k)
  {
    for (int j = range.First[1]; j <= range.Last[1]; ++j)
    {
      for (int i = range.First[0]; i <= range.Last[0]; ++i)
      {
        const Corner corner{Side * i, Side * j, Side * k};
        NodeBox box;
        if (this->MayChange(corner, sweep, this->Working->Find(corner)) &&
            this->CutBlock(corner, rows, box))
        {
          changed.push_back(box);
          this->IsChanged = true;
        }
      }
    }
  }
}

// A distance changes by no more than the way.
bool RemovalStroke::MayChange(const Corner& corner, const CutSweep& sweep,
                              const Block* block) const noexcept
{
  const double limit = this->Working->Limit;
  const double most = block != nullptr ? block->Most : limit;
  if (most <= -limit)
  {
    return false;
  }
  constexpr double Half = 0.5 * (Side - 1);
  const FieldGrid& grid = this->Working->Frame;
  const Vector3 middle = Vector3(corner[0], corner[1], corner[2]) + Vector3::Constant(Half);
  const double reach = Half * grid.Spacing().norm();
  return sweep.Distance(grid.PointWorld(middle)) - reach < most;
}

template <typename Rows>
bool RemovalStroke::CutBlock(const Corner& corner, Rows& rows, NodeBox& changed)
{
  Block* block = this->Working->Find(corner);
  const auto limit = static_cast<float>(this->Working->Limit);
  Row untouched;
  untouched.fill(limit);
  const std::array<int, 3> inGrid = this->NodesInGrid(corner);
  NodeBox box{{Side, Side, Side}, {-1, -1, -1}};
  rows.Begin(corner);
  for (int k = 0; k < inGrid[2]; ++k)
  {
    for (int j = 0; j < inGrid[1]; ++j)
    {
      const auto row = static_cast<std::size_t>((k * Side + j) * Side);
      const float* kept = block != nullptr ? &block->Distances[row] : untouched.data();
      Row distances;
      if (!rows.Distances(j, k, distances) || !Clip(distances, limit, kept))
      {
        continue;
      }
      const Stretch lower = LowerNodes(distances, kept, inGrid[0]);
      if (lower.First <= lower.Last)
      {
        block = box.IsEmpty() ? &this->OwnBlock(corner) : block;
        Lower(distances, inGrid[0], &block->Distances[row]);
        box.Extend({{lower.First, j, k}, {lower.Last, j, k}});
      }
    }
  }
  if (box.IsEmpty())
  {
    return false;
  }
  block->Most = *std::max_element(block->Distances.begin(), block->Distances.end());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    changed.First[axis] = corner[axis] + box.First[axis];
    changed.Last[axis] = corner[axis] + box.Last[axis];
  }
  return true;
}

// Of a block, along each axis.
std::array<int, 3> RemovalStroke::NodesInGrid(const Corner& corner) const noexcept
{
  std::array<int, 3> nodes{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    nodes[axis] = std::min(Side, this->Working->Frame.Size()[axis] - corner[axis]);
  }
  return nodes;
}

bool RemovalStroke::Set(const Corner& corner, const Nodes& distances)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (corner[axis] < 0 || corner[axis] >= this->Working->Frame.Size()[axis] ||
        corner[axis] % Side != 0)
    {
      return false;
    }
  }
  if (this->Working->Find(corner) != nullptr)
  {
    return false;
  }
  Block& block = this->OwnBlock(corner);
  block.Distances = distances;
  block.Most = *std::max_element(distances.begin(), distances.end());
  this->IsChanged = true;
  return true;
}

// Nodes beyond the grid count as gone.
std::shared_ptr<RemovalStroke::Block> RemovalStroke::FreshBlock(const Corner& corner) const
{
  auto block = std::make_shared<Block>();
  const auto limit = static_cast<float>(this->Working->Limit);
  block->Distances.fill(-limit);
  const std::array<int, 3> inGrid = this->NodesInGrid(corner);
  for (int k = 0; k < inGrid[2]; ++k)
  {
    for (int j = 0; j < inGrid[1]; ++j)
    {
      std::fill_n(&block->Distances[static_cast<std::size_t>((k * Side + j) * Side)], inGrid[0],
                  limit);
    }
  }
  return block;
}

// To be written: of this stroke alone.
RemovalStroke::Block& RemovalStroke::OwnBlock(const Corner& corner)
{
  RemovedDistances& state = *this->Working;
  std::shared_ptr<RemovedDistances::Page>& page = state.Pages[state.PageNumber(corner)];
  if (page == nullptr || page->Depth != state.Depth)
  {
    page = page != nullptr ? std::make_shared<RemovedDistances::Page>(*page)
                           : std::make_shared<RemovedDistances::Page>();
    page->Depth = state.Depth;
  }
  std::shared_ptr<Block>& block = page->Blocks[RemovedDistances::BlockNumber(corner)];
  if (block == nullptr)
  {
    block = this->FreshBlock(corner);
  }
  else if (block->Depth != state.Depth)
  {
    block = std::make_shared<Block>(*block);
  }
  block->Depth = state.Depth;
  return *block;
}
} // namespace palpate
