#include "DrilledVolume.h"

#include "CellVolume.h"
#include "SurfaceCells.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double UnitsOfCell = 4294967296.0; // 2^32
} // namespace

DrilledVolume::DrilledVolume(const EditedField& field, int material)
    : Number(material), Material(field.Newest().Material(material)),
      Layout(field.Newest().Layout()), CellVolume(field.Newest().Grid().Spacing().prod())
{
  for (std::vector<double>& nodes : this->Nodes)
  {
    nodes.resize(this->Layout.NodesOfBrick());
  }
}

void DrilledVolume::Forget(std::size_t brick)
{
  Part& part = this->Parts[brick];
  if (!part.IsStale)
  {
    part.IsStale = true;
    this->Stale.push_back(brick);
  }
}

double DrilledVolume::Removed(const EditedField& field)
{
  for (const std::size_t brick : this->Stale)
  {
    Part& part = this->Parts[brick];
    if (part.Original == NotKnown)
    {
      part.Original = this->InsideOf(field.Records(), brick, field.OriginalOf(brick));
    }
    const std::int64_t now = this->InsideOf(field.Records(), brick, field.RecordOf(brick));
    this->Total += part.Original - now - part.Removed;
    part.Removed = part.Original - now;
    part.IsStale = false;
  }
  this->Stale.clear();
  return static_cast<double>(this->Total) / UnitsOfCell * this->CellVolume;
}

std::int64_t DrilledVolume::InsideOf(const RecordLayout& records, std::size_t brick,
                                     const std::byte* record)
{
  const bool hasSurface = Contains(records.MaterialsOf(record), this->Number);
  if (!hasSurface && !Contains(records.InsideOf(record), this->Number))
  {
    return 0;
  }
  const auto columns = static_cast<std::size_t>(this->Layout.Bricks[0]);
  const auto rows = static_cast<std::size_t>(this->Layout.Bricks[1]);
  const CellSet inGrid = CellsInGrid(this->Layout, {static_cast<int>(brick % columns),
                                                    static_cast<int>(brick / columns % rows),
                                                    static_cast<int>(brick / columns / rows)});
  if (!hasSurface)
  {
    std::int64_t cells = 0;
    for (std::size_t word = 0; word < CellSet::WordCount; ++word)
    {
      cells += __builtin_popcountll(inGrid.Words[word]);
    }
    return cells * static_cast<std::int64_t>(UnitsOfCell);
  }
  this->LoadNodes(records, record);
  return this->InsideOfCells(inGrid);
}

void DrilledVolume::LoadNodes(const RecordLayout& records, const std::byte* record)
{
  for (int c = 0; c < this->Material.ConditionCount; ++c)
  {
    const FieldCondition& condition = this->Material.Conditions[c];
    std::vector<double>& nodes = this->Nodes[c];
    VisitScalars(record + records.ChannelAt(condition.Channel),
                 records.Types()[static_cast<std::size_t>(condition.Channel)],
                 [&nodes](const auto* from)
                 {
                   std::transform(from, from + nodes.size(), nodes.begin(),
                                  [](auto node) { return static_cast<double>(node); });
                 });
    condition.Relate(nodes.data(), static_cast<int>(nodes.size()));
  }
}

std::int64_t DrilledVolume::InsideOfCells(const CellSet& inGrid) const
{
  const int mask = this->Layout.Cells - 1;
  std::int64_t units = 0;
  for (int cell = 0; cell < 1 << (3 * this->Layout.Shift); ++cell)
  {
    if ((inGrid.Words[static_cast<std::size_t>(cell) >> 6] >> (cell & 63) & 1u) != 0)
    {
      units += this->UnitsInside(cell & mask, cell >> this->Layout.Shift & mask,
                                 cell >> (2 * this->Layout.Shift));
    }
  }
  return units;
}

std::int64_t DrilledVolume::UnitsInside(int i, int j, int k) const
{
  CellCorners corners[FieldMaterial::MostConditions];
  for (int c = 0; c < this->Material.ConditionCount; ++c)
  {
    for (int n = 0; n < 8; ++n)
    {
      const int node =
          ((k + (n >> 2)) * this->Layout.Side + j + (n >> 1 & 1)) * this->Layout.Side + i + (n & 1);
      corners[c][static_cast<std::size_t>(n)] = this->Nodes[c][static_cast<std::size_t>(node)];
    }
  }
  const auto count = static_cast<std::size_t>(this->Material.ConditionCount);
  return std::llround(UnitsOfCell * InsidePartOfCell(corners, count));
}
} // namespace palpate
