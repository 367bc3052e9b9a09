#include "DrilledBrick.h"

#include <algorithm>

namespace palpate
{
DrilledBrick::DrilledBrick(const ScalarField& field, const RecordLayout& records,
                           const DrilledMaterial& drilled)
    : Layout(field.Layout()), Records(records), Drilled(drilled),
      Type(records.Types()[static_cast<std::size_t>(drilled.Condition.Channel)]),
      Found(Layout.NodesOfBrick(), Layout.NodesOfBrick()), Nodes(Layout.NodesOfBrick())
{
  for (int material = 0; material < field.MaterialCount(); ++material)
  {
    this->Materials.push_back(field.Material(material));
  }
}

NodeBox DrilledBrick::NodesOf(const std::array<int, 3>& brick) const noexcept
{
  NodeBox box;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    box.First[axis] = this->Layout.Cells * brick[axis];
    box.Last[axis] = std::min(box.First[axis] + this->Layout.Side, this->Layout.Nodes[axis]) - 1;
  }
  return box;
}

std::size_t DrilledBrick::RowOf(int j, int k) const noexcept
{
  const int mask = this->Layout.Cells;
  const int row = (k - mask * this->Brick[2]) * this->Layout.Side + j - mask * this->Brick[1];
  return static_cast<std::size_t>(row * this->Layout.Side + this->Box.First[0] -
                                  mask * this->Brick[0]);
}

bool DrilledBrick::FindNodes(const std::array<int, 3>& brick, const NodeBox& box,
                             const DistanceBox& distances, const std::byte* original,
                             const std::byte* record)
{
  this->Brick = brick;
  this->Box = box;
  const std::size_t at = this->Records.ChannelAt(this->Drilled.Condition.Channel);
  return this->Type == ScalarType::Float32
             ? this->FindNodesOf(distances, reinterpret_cast<const float*>(original + at),
                                 reinterpret_cast<const float*>(record + at))
             : this->FindNodesOf(distances, reinterpret_cast<const double*>(original + at),
                                 reinterpret_cast<const double*>(record + at));
}

template <typename T>
bool DrilledBrick::FindNodesOf(const DistanceBox& distances, const T* original, const T* record)
{
  const int count = this->Box.Last[0] - this->Box.First[0] + 1;
  const NodeCut cut = this->Drilled.Cut;
  T* found = std::get<std::vector<T>>(this->Found).data();
  bool isChanged = false;
  for (int k = this->Box.First[2]; k <= this->Box.Last[2]; ++k)
  {
    for (int j = this->Box.First[1]; j <= this->Box.Last[1]; ++j)
    {
      const float* distance = distances.Row(this->Box.First[0], j, k);
      const std::size_t row = this->RowOf(j, k);
      const T* before = original + row;
      const T* now = record + row;
      int differing = 0;
      for (int i = 0; i < count; ++i)
      {
        const T value = cut.Apply(before[i], static_cast<T>(distance[i]));
        differing |= static_cast<int>(value != now[i]);
        found[i] = value;
      }
      isChanged = isChanged || differing != 0;
      found += count;
    }
  }
  return isChanged;
}

void DrilledBrick::Write(std::byte* record)
{
  const std::size_t at = this->Records.ChannelAt(this->Drilled.Condition.Channel);
  this->Type == ScalarType::Float32 ? this->WriteNodesOf(reinterpret_cast<float*>(record + at))
                                    : this->WriteNodesOf(reinterpret_cast<double*>(record + at));
  this->WriteSurface(record);
}

template <typename T>
void DrilledBrick::WriteNodesOf(T* nodes) const
{
  const int count = this->Box.Last[0] - this->Box.First[0] + 1;
  const T* found = std::get<std::vector<T>>(this->Found).data();
  for (int k = this->Box.First[2]; k <= this->Box.Last[2]; ++k)
  {
    for (int j = this->Box.First[1]; j <= this->Box.Last[1]; ++j)
    {
      std::copy_n(found, count, nodes + this->RowOf(j, k));
      found += count;
    }
  }
}

ConditionCells DrilledBrick::CellsOf(const FieldCondition& condition, const std::byte* record)
{
  const std::byte* block = record + this->Records.ChannelAt(condition.Channel);
  VisitScalars(block, this->Records.Types()[static_cast<std::size_t>(condition.Channel)],
               [this](const auto* nodes)
               {
                 std::transform(nodes, nodes + this->Nodes.size(), this->Nodes.begin(),
                                [](auto node) { return static_cast<double>(node); });
               });
  return ClassifyCells(this->Nodes.data(), this->Layout, condition);
}

// Materials that have no surface here and are not drilled are unchanged.
void DrilledBrick::WriteSurface(std::byte* record)
{
  const MaterialSet passed = this->Records.MaterialsOf(record);
  const CellSet inGrid = CellsInGrid(this->Layout, this->Brick);
  SurfaceBrick surface;
  surface.Cells.Fill(false);
  surface.Inside = this->Records.InsideOf(record) & ~OnlyMaterial(this->Drilled.Material);
  for (int m = 0; m < static_cast<int>(this->Materials.size()); ++m)
  {
    if (m != this->Drilled.Material && !Contains(passed, m))
    {
      continue;
    }
    const FieldMaterial& material = this->Materials[static_cast<std::size_t>(m)];
    ConditionCells cells = this->CellsOf(material.Conditions[0], record);
    for (int c = 1; c < material.ConditionCount; ++c)
    {
      cells.Restrict(this->CellsOf(material.Conditions[c], record));
    }
    AddMaterial(m, cells, inGrid, surface);
  }
  this->Records.SetSurface(surface, record);
}
} // namespace palpate
