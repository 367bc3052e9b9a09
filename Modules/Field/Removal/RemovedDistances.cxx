#include "RemovedDistances.h"

#include <algorithm>

namespace palpate
{
namespace
{
std::size_t NodeNumber(int i, int j, int k)
{
  constexpr int Side = RemovedDistances::Side;
  return static_cast<std::size_t>((k * Side + j) * Side + i);
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

bool RemovedDistances::IsLike(const RemovedDistances& other) const noexcept
{
  const FieldGrid& grid = other.Frame;
  return this->Limit == other.Limit && this->Frame.Size() == grid.Size() &&
         this->Frame.OriginWorld() == grid.OriginWorld() &&
         this->Frame.Spacing() == grid.Spacing() && this->Frame.Direction() == grid.Direction();
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

RemovedDistances::Block* RemovedDistances::Find(const Corner& corner) const noexcept
{
  Page* page = this->Pages[this->PageNumber(corner)].get();
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

std::vector<RemovedDistances::Corner> RemovedDistances::Difference(const RemovedDistances& a,
                                                                   const RemovedDistances& b)
{
  std::vector<Corner> corners;
  for (std::size_t p = 0; p < a.Pages.size(); ++p)
  {
    const Page* first = a.Pages[p].get();
    const Page* second = b.Pages[p].get();
    for (std::size_t n = 0; first != second && n < std::tuple_size_v<decltype(Page::Blocks)>; ++n)
    {
      const Block* one = first != nullptr ? first->Blocks[n].get() : nullptr;
      const Block* two = second != nullptr ? second->Blocks[n].get() : nullptr;
      if (one != two)
      {
        corners.push_back(a.CornerOf(p, n));
      }
    }
  }
  return corners;
}

std::vector<RemovedDistances::Corner> RemovedDistances::Corners() const
{
  return Difference(*this, *None(this->Frame, this->Limit));
}

std::size_t RemovedDistances::BytesNotIn(const RemovedDistances* other) const noexcept
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
