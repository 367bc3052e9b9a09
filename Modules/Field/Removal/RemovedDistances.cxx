#include "RemovedDistances.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr int Side = RemovedDistances::Side;

std::size_t NodeNumber(int i, int j, int k)
{
  return static_cast<std::size_t>((k * Side + j) * Side + i);
}

// Blocks that a box meets, in whole blocks along each axis, cut to the grid.
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

RemovedDistances::RemovedDistances(const FieldGrid& grid, double band) : Frame(grid), Limit(band)
{
  std::size_t count = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->PageCounts[axis] = (grid.Size()[axis] - 1) / (Side * PageSide) + 1;
    count *= static_cast<std::size_t>(this->PageCounts[axis]);
  }
  this->Pages.resize(count);
}

std::shared_ptr<const RemovedDistances> RemovedDistances::None(const FieldGrid& grid, double band)
{
  return std::shared_ptr<const RemovedDistances>(new RemovedDistances(grid, band));
}

std::size_t RemovedDistances::PageNumber(const Corner& corner) const noexcept
{
  constexpr int Nodes = Side * PageSide;
  const int page =
      (corner[2] / Nodes * this->PageCounts[1] + corner[1] / Nodes) * this->PageCounts[0] +
      corner[0] / Nodes;
  return static_cast<std::size_t>(page);
}

std::size_t RemovedDistances::BlockNumber(const Corner& corner) noexcept
{
  const auto place = [](int node) { return node / Side % PageSide; };
  return static_cast<std::size_t>((place(corner[2]) * PageSide + place(corner[1])) * PageSide +
                                  place(corner[0]));
}

RemovedDistances::Corner RemovedDistances::CornerOf(std::size_t page,
                                                    std::size_t block) const noexcept
{
  Corner corner{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto pages = static_cast<std::size_t>(this->PageCounts[axis]);
    corner[axis] = Side * static_cast<int>(page % pages * PageSide + block % std::size_t{PageSide});
    page /= pages;
    block /= PageSide;
  }
  return corner;
}

const RemovedDistances::Block* RemovedDistances::Find(const Corner& corner) const noexcept
{
  const Page* page = this->Pages[this->PageNumber(corner)].get();
  return page != nullptr ? page->Blocks[BlockNumber(corner)].get() : nullptr;
}

const float* RemovedDistances::BlockAt(const Corner& corner) const noexcept
{
  const Block* block = this->Find(corner);
  return block != nullptr ? block->Distances.data() : nullptr;
}

float RemovedDistances::At(int i, int j, int k) const noexcept
{
  const float* block = this->BlockAt({i, j, k});
  return block != nullptr ? block[NodeNumber(i % Side, j % Side, k % Side)]
                          : static_cast<float>(this->Limit);
}

// Nothing where the sweep changes nothing there.
std::shared_ptr<const RemovedDistances::Block>
RemovedDistances::CutBlock(const Corner& corner, const CutSweep& sweep) const
{
  const Block* before = this->Find(corner);
  const double most = before != nullptr ? before->Most : this->Limit;
  constexpr double Middle = 0.5 * (Side - 1);
  const Vector3 first(corner[0], corner[1], corner[2]);
  const Vector3 half = Middle * this->Frame.Spacing();
  const Vector3 middle = this->Frame.PointWorld(first + Vector3::Constant(Middle));
  // A distance changes by no more than the way.
  if (sweep.Distance(middle) - half.norm() >= most || most <= -this->Limit)
  {
    return nullptr;
  }
  auto after = std::make_shared<Block>();
  before != nullptr ? after->Distances = before->Distances
                    : (after->Distances.fill(static_cast<float>(this->Limit)), after->Distances);
  bool isChanged = false;
  for (int k = 0; k < Side; ++k)
  {
    for (int j = 0; j < Side; ++j)
    {
      for (int i = 0; i < Side; ++i)
      {
        const double distance = sweep.Distance(this->Frame.PointWorld(first + Vector3(i, j, k)));
        float& kept = after->Distances[NodeNumber(i, j, k)];
        const auto held = static_cast<float>(std::max(distance, -this->Limit));
        isChanged = isChanged || held < kept;
        kept = std::min(kept, held);
      }
    }
  }
  after->Most = *std::max_element(after->Distances.begin(), after->Distances.end());
  return isChanged ? after : nullptr;
}

std::shared_ptr<const RemovedDistances>
RemovedDistances::Cut(const std::shared_ptr<const RemovedDistances>& before, const CutSweep& sweep,
                      std::vector<Corner>& changed)
{
  changed.clear();
  const BlockRange range = RangeOf(before->Frame, sweep.BoundsWorld(), before->Limit);
  std::shared_ptr<RemovedDistances> after;
  std::vector<std::shared_ptr<Page>> pages(before->Pages.size()); // that are new
  for (int k = range.First[2]; k <= range.Last[2]; ++k)
  {
    for (int j = range.First[1]; j <= range.Last[1]; ++j)
    {
      for (int i = range.First[0]; i <= range.Last[0]; ++i)
      {
        const Corner corner{Side * i, Side * j, Side * k};
        auto block = before->CutBlock(corner, sweep);
        if (block == nullptr)
        {
          continue;
        }
        if (after == nullptr)
        {
          after = std::shared_ptr<RemovedDistances>(new RemovedDistances(*before));
        }
        const std::size_t number = before->PageNumber(corner);
        if (pages[number] == nullptr)
        {
          const auto& page = before->Pages[number];
          pages[number] =
              page != nullptr ? std::make_shared<Page>(*page) : std::make_shared<Page>();
          after->Pages[number] = pages[number];
        }
        pages[number]->Blocks[BlockNumber(corner)] = std::move(block);
        changed.push_back(corner);
      }
    }
  }
  return after != nullptr ? after : before;
}

template <typename Visit>
void RemovedDistances::ForEachDifference(const RemovedDistances& other, const Visit& visit) const
{
  for (std::size_t p = 0; p < this->Pages.size(); ++p)
  {
    const Page* mine = this->Pages[p].get();
    const Page* theirs = other.Pages[p].get();
    if (mine == theirs)
    {
      continue;
    }
    for (std::size_t b = 0; b < std::tuple_size_v<decltype(Page::Blocks)>; ++b)
    {
      const Block* one = mine != nullptr ? mine->Blocks[b].get() : nullptr;
      const Block* two = theirs != nullptr ? theirs->Blocks[b].get() : nullptr;
      if (one != two)
      {
        visit(this->CornerOf(p, b), one);
      }
    }
  }
}

std::vector<RemovedDistances::Corner> RemovedDistances::Difference(const RemovedDistances& a,
                                                                   const RemovedDistances& b)
{
  std::vector<Corner> corners;
  a.ForEachDifference(b, [&](const Corner& corner, const Block*) { corners.push_back(corner); });
  return corners;
}

std::size_t RemovedDistances::BytesBeside(const RemovedDistances* other) const noexcept
{
  std::size_t bytes = sizeof(*this) + this->Pages.size() * sizeof(this->Pages[0]);
  for (std::size_t p = 0; p < this->Pages.size(); ++p)
  {
    const Page* page = this->Pages[p].get();
    const Page* theirs = other != nullptr ? other->Pages[p].get() : nullptr;
    if (page == nullptr || page == theirs)
    {
      continue;
    }
    bytes += sizeof(Page);
    for (std::size_t b = 0; b < page->Blocks.size(); ++b)
    {
      const Block* block = page->Blocks[b].get();
      const bool isShared = theirs != nullptr && theirs->Blocks[b].get() == block;
      bytes += block != nullptr && !isShared ? sizeof(Block) : 0;
    }
  }
  return bytes;
}
} // namespace palpate
