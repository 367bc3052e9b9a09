#include "TopologyRepair.h"

#include "FieldVolume.h"
#include "HandleRepair.h"
#include "KuhnComponents.h"
#include "KuhnNeighborhood.h"
#include "PartBridge.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
// Nodes of one place that change sides together.
struct ChangedPlace
{
  TopologyChange* Change;
  unsigned char Side; // 1: inside now
  NodeList Nodes;
};

// Centre and size of the box of a place's nodes.
void DescribePlace(const ShapeGrid& grid, const NodeList& nodes, TopologyChange& change)
{
  std::array<int, 3> first = grid.Index(nodes.front());
  std::array<int, 3> last = first;
  Vector3 sum = Vector3::Zero();
  for (const std::size_t node : nodes)
  {
    const std::array<int, 3> at = grid.Index(node);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      first[axis] = std::min(first[axis], at[axis]);
      last[axis] = std::max(last[axis], at[axis]);
      sum[static_cast<int>(axis)] += at[axis];
    }
  }
  change.LargestCentre = grid.Origin + grid.Spacing * sum / static_cast<double>(nodes.size());
  const Vector3 extent(last[0] - first[0] + 1, last[1] - first[1] + 1, last[2] - first[2] + 1);
  change.LargestExtent = extent.norm() * grid.Spacing;
}

class TopologyRepairer
{
public:
  TopologyRepairer(ShapeField& field, const TopologySettings& settings, TopologyReport& report)
      : Field(&field), Settings(settings), Report(&report), Inside(field.Values.size()),
        Marks(field.Values.size(), 0)
  {
    std::transform(field.Values.begin(), field.Values.end(), this->Inside.begin(),
                   [](float value) -> unsigned char { return value > 0.0f ? 1 : 0; });
  }

  Status Run()
  {
    KuhnComponents components(this->Field->Grid, this->Inside);
    Status status = this->KeepOnePart(components);
    if (!status.IsOk())
    {
      return status;
    }
    this->FillCavities();
    if (EulerCharacteristic(this->Field->Grid, this->Inside) != 1)
    {
      this->RemoveHandles();
    }
    this->ApplyChanges();
    return Status::Success();
  }

private:
  Status KeepOnePart(const KuhnComponents& components)
  {
    long long nodes = 0;
    int largest = -1;
    for (int part = 0; part < components.Count(); ++part)
    {
      if (components.IsInside(part))
      {
        nodes += components.Nodes(part);
        largest =
            largest < 0 || components.Nodes(part) > components.Nodes(largest) ? part : largest;
      }
    }
    this->Report->ObjectVolume = VolumeAbove(*this->Field, 0.0f);
    if (largest < 0)
    {
      return Status::Failure("is nowhere wide enough for a surface");
    }
    const double least = this->Settings.SmallPart * static_cast<double>(nodes);
    std::vector<unsigned char> isDropped(static_cast<std::size_t>(components.Count()), 0);
    int kept = 0;
    for (int part = 0; part < components.Count(); ++part)
    {
      if (components.IsInside(part))
      {
        const bool isSmall = part != largest && static_cast<double>(components.Nodes(part)) < least;
        isDropped[static_cast<std::size_t>(part)] = isSmall ? 1 : 0;
        kept += isSmall ? 0 : 1;
      }
    }
    this->SetParts(components, isDropped, 0, this->Report->DroppedParts);
    if (kept == 1)
    {
      return Status::Success();
    }
    return this->Settings.BridgeParts
               ? this->JoinParts(largest, components)
               : SeveralParts(kept, 100.0 * static_cast<double>(components.Nodes(largest)) /
                                        static_cast<double>(nodes));
  }

  static Status SeveralParts(int count, double percent)
  {
    char text[120];
    std::snprintf(text, sizeof(text),
                  "has %d separate parts; the largest has %.3g %% of its volume", count, percent);
    return Status::Failure(text);
  }

  // Puts whole components on the other side.
  void SetParts(const KuhnComponents& components, const std::vector<unsigned char>& isChosen,
                unsigned char side, TopologyChange& change)
  {
    std::vector<NodeList> places(isChosen.size());
    components.VisitRuns(
        [&](std::size_t first, int count, int part)
        {
          if (isChosen[static_cast<std::size_t>(part)] != 0)
          {
            NodeList& nodes = places[static_cast<std::size_t>(part)];
            nodes.resize(nodes.size() + static_cast<std::size_t>(count));
            std::iota(nodes.end() - count, nodes.end(), first);
          }
        });
    for (NodeList& nodes : places)
    {
      this->SetNodes(std::move(nodes), side, change);
    }
  }

  Status JoinParts(int largest, const KuhnComponents& components)
  {
    std::vector<unsigned char> marks = this->Inside;
    this->Mark(components, largest, marks);
    const ShapeGrid& grid = this->Field->Grid;
    BridgeSearch search(*this->Field, marks);
    for (PartBridge bridge = search.Next(); !bridge.Nodes.empty(); bridge = search.Next())
    {
      TopologyChange& change = this->Report->Bridges;
      const Vector3 from = grid.Point(grid.Index(bridge.From));
      const Vector3 to = grid.Point(grid.Index(bridge.To));
      if ((to - from).norm() > change.LargestExtent)
      {
        change.LargestExtent = (to - from).norm();
        change.LargestCentre = 0.5 * (from + to);
      }
      for (const std::size_t node : bridge.Nodes)
      {
        marks[node] = 2;
      }
      this->Mark(components, components.At(bridge.To), marks);
      this->SetNodes(std::move(bridge.Nodes), 1, change);
    }
    return Status::Success();
  }

  static void Mark(const KuhnComponents& components, int part, std::vector<unsigned char>& marks)
  {
    components.VisitRuns(
        [&](std::size_t first, int count, int of)
        {
          if (of == part)
          {
            std::fill_n(marks.begin() + static_cast<std::ptrdiff_t>(first), count,
                        static_cast<unsigned char>(2));
          }
        });
  }

  void FillCavities()
  {
    const KuhnComponents components(this->Field->Grid, this->Inside);
    std::vector<unsigned char> isCavity(static_cast<std::size_t>(components.Count()), 0);
    // Component 0 holds node 0, on the grid's border.
    for (int part = 1; part < components.Count(); ++part)
    {
      isCavity[static_cast<std::size_t>(part)] = components.IsInside(part) ? 0 : 1;
    }
    this->SetParts(components, isCavity, 1, this->Report->FilledCavities);
  }

  void RemoveHandles()
  {
    const HandleRepair repair = RepairHandles(*this->Field, this->Inside);
    for (NodeList& part : this->PartsOf(repair.Cut))
    {
      this->SetNodes(std::move(part), 0, this->Report->CutHandles);
    }
    for (NodeList& part : this->PartsOf(repair.Filled))
    {
      this->SetNodes(std::move(part), 1, this->Report->FilledHandles);
    }
  }

  std::vector<NodeList> PartsOf(const NodeList& nodes)
  {
    return ConnectedParts(nodes, OffsetsOf(this->Field->Grid), this->Marks);
  }

  void SetNodes(NodeList nodes, unsigned char side, TopologyChange& change)
  {
    for (const std::size_t node : nodes)
    {
      this->Inside[node] = side;
    }
    if (!nodes.empty())
    {
      this->Places.push_back({&change, side, std::move(nodes)});
    }
  }

  void ApplyChanges()
  {
    for (const ChangedPlace& place : this->Places)
    {
      const double before = VolumeAround(*this->Field, place.Nodes, this->Marks);
      this->MoveValues(place);
      const double after = VolumeAround(*this->Field, place.Nodes, this->Marks);
      const double volume = std::abs(after - before);
      TopologyChange& change = *place.Change;
      change.Count += 1;
      change.Volume += volume;
      if (volume > change.LargestVolume)
      {
        change.LargestVolume = volume;
        if (place.Change != &this->Report->Bridges)
        {
          DescribePlace(this->Field->Grid, place.Nodes, change);
        }
      }
    }
  }

  void MoveValues(const ChangedPlace& place)
  {
    const auto spacing = static_cast<float>(this->Field->Grid.Spacing);
    for (const std::size_t node : place.Nodes)
    {
      float& value = this->Field->Values[node];
      const float depth = std::clamp(std::abs(value), 0.1f * spacing, 0.2f * spacing);
      value = place.Side != 0 ? depth : -depth;
    }
  }

  ShapeField* Field;
  TopologySettings Settings;
  TopologyReport* Report;
  std::vector<unsigned char> Inside;
  std::vector<unsigned char> Marks; // all 0
  std::vector<ChangedPlace> Places; // in the order of their changes
};

bool IsValid(const TopologySettings& settings)
{
  return settings.SmallPart >= 0.0 && settings.SmallPart < 1.0;
}
} // namespace

Status RepairTopology(ShapeField& field, const TopologySettings& settings, TopologyReport& report)
{
  report = {};
  if (!IsValid(settings) || field.Values.size() != field.Grid.NodeCount())
  {
    return Status::Failure("The settings of a topology repair are out of range.");
  }
  return TopologyRepairer(field, settings, report).Run();
}
} // namespace palpate
