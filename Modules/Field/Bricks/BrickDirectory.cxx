#include "BrickDirectory.h"

#include <algorithm>
#include <cstddef>

namespace palpate
{
namespace
{
constexpr std::uint32_t FarthestLeap = 255;

// The chessboard distance in two sweeps (Rosenfeld and Pfaltz, J. ACM 13, 1966): the forward sweep
// uses the 13 neighbours visited before, the backward sweep the other 13.
class ChessboardSweep
{
public:
  ChessboardSweep(const BrickLayout& layout, std::vector<BrickDirectory::Entry>& entries)
      : Layout(layout), Entries(entries)
  {
  }

  void Run(bool isForward)
  {
    const std::size_t count = this->Entries.size();
    for (std::size_t n = 0; n < count; ++n)
    {
      this->Visit(isForward ? n : count - 1 - n, isForward);
    }
  }

private:
  void Visit(std::size_t brick, bool isForward)
  {
    const auto columns = static_cast<std::size_t>(this->Layout.Bricks[0]);
    const auto rows = static_cast<std::size_t>(this->Layout.Bricks[1]);
    const int i = static_cast<int>(brick % columns);
    const int j = static_cast<int>(brick / columns % rows);
    const int k = static_cast<int>(brick / columns / rows);
    std::uint32_t& leap = this->Entries[brick].Leap;
    for (int neighbour = 0; neighbour < 13 && leap > 0; ++neighbour)
    {
      const int sign = isForward ? 1 : -1;
      const int di = sign * (neighbour % 3 - 1);
      const int dj = sign * (neighbour / 3 % 3 - 1);
      const int dk = sign * (neighbour / 9 - 1);
      if (this->Has(i + di, j + dj, k + dk))
      {
        leap = std::min(leap, this->Entries[this->Layout.Number(i + di, j + dj, k + dk)].Leap + 1);
      }
    }
  }
  bool Has(int i, int j, int k) const
  {
    const std::array<int, 3>& bricks = this->Layout.Bricks;
    return i >= 0 && j >= 0 && k >= 0 && i < bricks[0] && j < bricks[1] && k < bricks[2];
  }

  const BrickLayout& Layout;
  std::vector<BrickDirectory::Entry>& Entries;
};
} // namespace

void BrickDirectory::AddSurface(std::size_t brick, const SurfaceBrick& surface)
{
  this->Entries[brick] = {static_cast<std::uint32_t>(this->Surfaces.size()), 0};
  this->Surfaces.insert(this->Surfaces.end(), surface.Cells.Words.begin(),
                        surface.Cells.Words.end());
  this->Surfaces.push_back(surface.Sets());
  this->SurfaceWords = this->Surfaces.data();
}

void BrickDirectory::FindLeaps(const BrickLayout& layout)
{
  for (Entry& entry : this->Entries)
  {
    entry.Leap = entry.Leap == 0 ? 0 : FarthestLeap;
  }
  ChessboardSweep sweep(layout, this->Entries);
  sweep.Run(true);
  sweep.Run(false);
  if (!this->Surfaces.empty())
  {
    this->Surfaces.shrink_to_fit();
    this->SurfaceWords = this->Surfaces.data();
  }
}
} // namespace palpate
