#include "KuhnComponents.h"

#include <algorithm>
#include <numeric>

namespace palpate
{
KuhnComponents::KuhnComponents(const ShapeGrid& grid, const std::vector<unsigned char>& inside)
    : RowLength(static_cast<std::size_t>(grid.Size[0]))
{
  this->FindRuns(inside);
  this->Parents.resize(this->Runs.size());
  std::iota(this->Parents.begin(), this->Parents.end(), 0);
  const auto rows = static_cast<std::size_t>(grid.Size[1]);
  for (std::size_t row = 0; row + 1 < this->RowStarts.size(); ++row)
  {
    const bool hasRow = row % rows + 1 < rows;
    const bool hasSlice = row + rows + 1 < this->RowStarts.size();
    if (hasRow)
    {
      this->JoinRows(row, row + 1);
    }
    if (hasSlice)
    {
      this->JoinRows(row, row + rows);
    }
    if (hasRow && hasSlice)
    {
      this->JoinRows(row, row + rows + 1);
    }
  }
  this->Number();
}

void KuhnComponents::FindRuns(const std::vector<unsigned char>& inside)
{
  for (std::size_t first = 0; first < inside.size(); first += this->RowLength)
  {
    const unsigned char* row = &inside[first];
    const unsigned char* end = row + this->RowLength;
    for (const unsigned char* from = row; from != end;)
    {
      const unsigned char* to = std::find(from, end, *from != 0 ? 0 : 1);
      this->Runs.push_back(
          {static_cast<int>(from - row), static_cast<int>(to - row), *from != 0, 0});
      from = to;
    }
    this->RowStarts.push_back(this->Runs.size());
  }
}

int KuhnComponents::Root(int run)
{
  const auto parent = [this](int of) -> int&
  { return this->Parents[static_cast<std::size_t>(of)]; };
  while (parent(run) != run)
  {
    parent(run) = parent(parent(run));
    run = parent(run);
  }
  return run;
}

// A node's neighbours in a following row have the same index along i or the next.
void KuhnComponents::JoinRows(std::size_t row, std::size_t next)
{
  std::size_t a = this->RowStarts[row];
  std::size_t b = this->RowStarts[next];
  while (a < this->RowStarts[row + 1] && b < this->RowStarts[next + 1])
  {
    const NodeRun& from = this->Runs[a];
    const NodeRun& to = this->Runs[b];
    if (from.IsInside == to.IsInside && to.First <= from.End && to.End > from.First)
    {
      const int roots[2] = {this->Root(static_cast<int>(a)), this->Root(static_cast<int>(b))};
      this->Parents[static_cast<std::size_t>(std::max(roots[0], roots[1]))] =
          std::min(roots[0], roots[1]);
    }
    // A run also meets the one that begins where it ends.
    (from.End < to.End ? a : b) += 1;
  }
}

void KuhnComponents::Number()
{
  for (std::size_t run = 0; run < this->Runs.size(); ++run)
  {
    const auto root = static_cast<std::size_t>(this->Root(static_cast<int>(run)));
    NodeRun& nodes = this->Runs[run];
    if (root == run)
    {
      nodes.Component = this->Count();
      this->NodeCounts.push_back(0);
      this->Inside.push_back(nodes.IsInside ? 1 : 0);
    }
    nodes.Component = this->Runs[root].Component;
    this->NodeCounts[static_cast<std::size_t>(nodes.Component)] += nodes.End - nodes.First;
  }
}

int KuhnComponents::At(std::size_t offset) const
{
  const std::size_t row = offset / this->RowLength;
  const auto i = static_cast<int>(offset % this->RowLength);
  const auto first = this->Runs.begin() + static_cast<std::ptrdiff_t>(this->RowStarts[row]);
  const auto last = this->Runs.begin() + static_cast<std::ptrdiff_t>(this->RowStarts[row + 1]);
  return std::upper_bound(first, last, i, [](int at, const NodeRun& run) { return at < run.End; })
      ->Component;
}
} // namespace palpate
