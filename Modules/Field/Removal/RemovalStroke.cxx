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

// Rows of a block for a tool's sweep: for any tool, and for a sphere.
class AnyRows
{
public:
  AnyRows(const CutSweep& sweep, const FieldGrid& grid) : Sweep(sweep), Grid(grid) {}

  void Begin(const RemovedDistances::Corner& corner)
  {
    this->First = Vector3(corner[0], corner[1], corner[2]);
  }
  unsigned Lower(int j, int k, float least, float* kept) const
  {
    unsigned lowered = 0;
    for (int i = 0; i < Side; ++i)
    {
      const Vector3 point = this->Grid.PointWorld(this->First + Vector3(i, j, k));
      const float distance = std::max(static_cast<float>(this->Sweep.Distance(point)), least);
      lowered |= static_cast<unsigned>(distance < kept[i]) << i;
      kept[i] = std::min(kept[i], distance);
    }
    return lowered;
  }

private:
  const CutSweep& Sweep;
  const FieldGrid& Grid;
  Vector3 First = Vector3::Zero();
};

class SphericalRows
{
public:
  SphericalRows(const CutSweep& sweep, const FieldGrid& grid, bool goesOn)
      : Rows(grid, sweep.FromWorld(), sweep.PathWorld(), sweep.Radius()), GoesOn(goesOn)
  {
    static_assert(SphereRows::Count == Side);
  }

  void Begin(const RemovedDistances::Corner& corner) { this->Rows.Begin(corner); }
  unsigned Lower(int j, int k, float least, float* kept) const
  {
    return this->GoesOn && this->Rows.IsBehind(j, k) ? 0 : this->Rows.Lower(j, k, least, kept);
  }

private:
  SphereRows Rows;
  bool GoesOn;
};

// Lowers distances outside the forbidden region; inside it, no lower than the depth in it.
template <typename Rows>
unsigned LowerUnlessForbidden(const float* forbidden, const Rows& rows, int j, int k, float least,
                              float* kept)
{
  Row before;
  std::copy_n(kept, Side, before.begin());
  unsigned lowered = rows.Lower(j, k, least, kept);
  for (std::size_t i = 0; lowered != 0 && i < before.size(); ++i)
  {
    kept[i] = std::min(std::max(kept[i], -forbidden[i]), before[i]);
    lowered &= kept[i] < before[i] ? ~0U : ~(1U << i);
  }
  return lowered;
}

// The largest of a block's distances; vectorises.
float MostOf(const RemovalStroke::Nodes& distances)
{
  Row most;
  std::copy_n(distances.begin(), Side, most.begin());
  for (std::size_t row = Side; row < distances.size(); row += Side)
  {
    for (std::size_t n = 0; n < Side; ++n)
    {
      most[n] = most[n] < distances[row + n] ? distances[row + n] : most[n];
    }
  }
  return *std::max_element(most.begin(), most.end());
}

// The blocks that intersect a box in the world, extended by `around` on each side and clipped to
// the grid; numbers of blocks.
NodeBox BlocksOf(const FieldGrid& grid, const Eigen::AlignedBox3d& boxWorld, double around)
{
  const Eigen::AlignedBox3d index = IndexBounds(grid, boxWorld);
  NodeBox range;
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

RemovalStroke::RemovalStroke(std::shared_ptr<const RemovedDistances> before,
                             std::shared_ptr<const RemovedDistances> forbidden)
    : Start(std::move(before)), Forbidden(std::move(forbidden))
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
  // If a path continues the last one, points behind its start are no closer to it than to the
  // start.
  const bool goesOn =
      this->Last.Radius == sweep.Radius() && this->Last.EndWorld == sweep.FromWorld();
  SphericalRows rows(sweep, this->Working->Frame, goesOn);
  this->CutWith(rows, sweep, changed);
  this->Last = {sweep.Radius(), sweep.FromWorld() + sweep.PathWorld()};
}

template <typename Rows>
void RemovalStroke::CutWith(Rows& rows, const CutSweep& sweep, std::vector<NodeBox>& changed)
{
  const NodeBox range = BlocksOf(this->Working->Frame, sweep.BoundsWorld(), this->Working->Limit);
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

// A distance changes by at most the length of the path.
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

// Lowers a copy, which replaces the block if any node of it was lowered.
template <typename Rows>
bool RemovalStroke::CutBlock(const Corner& corner, Rows& rows, NodeBox& changed)
{
  const Block* before = this->Working->Find(corner);
  Nodes distances;
  before != nullptr ? static_cast<void>(distances = before->Distances)
                    : this->FillUntouched(corner, distances);
  const auto least = static_cast<float>(-this->Working->Limit);
  const std::array<int, 3> inGrid = this->NodesInGrid(corner);
  NodeBox box{{Side, Side, Side}, {-1, -1, -1}};
  const float* forbidden = this->Forbidden != nullptr ? this->Forbidden->BlockAt(corner) : nullptr;
  rows.Begin(corner);
  for (int k = 0; k < inGrid[2]; ++k)
  {
    for (int j = 0; j < inGrid[1]; ++j)
    {
      const auto first = static_cast<std::size_t>((k * Side + j) * Side);
      float* row = &distances[first];
      const unsigned lowered =
          forbidden == nullptr ? rows.Lower(j, k, least, row)
                               : LowerUnlessForbidden(forbidden + first, rows, j, k, least, row);
      if (lowered != 0)
      {
        box.Extend({{__builtin_ctz(lowered), j, k}, {31 - __builtin_clz(lowered), j, k}});
      }
    }
  }
  if (box.IsEmpty())
  {
    return false;
  }
  Block& block = this->OwnBlock(corner);
  block.Distances = distances;
  block.Most = MostOf(distances);
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
  block.Most = MostOf(distances);
  this->IsChanged = true;
  return true;
}

std::shared_ptr<const RemovedDistances>
RemovalStroke::Without(const std::shared_ptr<const RemovedDistances>& forbidden,
                       const std::shared_ptr<const RemovedDistances>& removed)
{
  RemovalStroke without(RemovedDistances::None(removed->Grid(), removed->Band()));
  bool isDifferent = false;
  for (const Corner& corner : removed->Corners())
  {
    Nodes distances;
    std::copy_n(removed->BlockAt(corner), distances.size(), distances.begin());
    const float* nearby = forbidden->BlockAt(corner);
    for (std::size_t n = 0; nearby != nullptr && n < distances.size(); ++n)
    {
      isDifferent = isDifferent || distances[n] < -nearby[n];
      distances[n] = std::max(distances[n], -nearby[n]);
    }
    without.Set(corner, distances);
  }
  return isDifferent ? without.Finish() : removed;
}

// Nodes beyond the grid count as removed.
void RemovalStroke::FillUntouched(const Corner& corner, Nodes& distances) const
{
  const auto limit = static_cast<float>(this->Working->Limit);
  distances.fill(-limit);
  const std::array<int, 3> inGrid = this->NodesInGrid(corner);
  for (int k = 0; k < inGrid[2]; ++k)
  {
    for (int j = 0; j < inGrid[1]; ++j)
    {
      std::fill_n(&distances[static_cast<std::size_t>((k * Side + j) * Side)], inGrid[0], limit);
    }
  }
}

// A block owned by this stroke alone, to be filled.
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
  if (block == nullptr || block->Depth != state.Depth)
  {
    block = std::make_shared<Block>();
    block->Depth = state.Depth;
  }
  return *block;
}
} // namespace palpate
