#include "TopologyRepair.h"

#include "HandleRepair.h"
#include "KuhnComponents.h"
#include "KuhnNeighborhood.h"
#include "PartBridge.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace palpate
{
namespace
{
// Where the nodes of a place are.
class Place
{
public:
  explicit Place(const ShapeGrid& grid) : Grid(&grid) {}

  void AddRun(std::size_t first, int count)
  {
    std::array<int, 3> low = this->Grid->Index(first);
    std::array<int, 3> high = low;
    high[0] += count - 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->First[axis] = std::min(this->First[axis], low[axis]);
      this->Last[axis] = std::max(this->Last[axis], high[axis]);
      this->Sum[static_cast<int>(axis)] += 0.5 * count * (low[axis] + high[axis]);
    }
    this->Nodes += count;
  }

  void AddTo(TopologyChange& change) const
  {
    const double volume = this->Nodes * this->Grid->CellVolume();
    change.Count += 1;
    change.Volume += volume;
    if (volume > change.LargestVolume)
    {
      change.LargestVolume = volume;
      change.LargestCentre = this->Grid->Origin + this->Grid->Spacing * this->Sum / this->Nodes;
      Vector3 extent;
      for (int axis = 0; axis < 3; ++axis)
      {
        const auto a = static_cast<std::size_t>(axis);
        extent[axis] = this->Last[a] - this->First[a] + 1;
      }
      change.LargestExtent = extent.norm() * this->Grid->Spacing;
    }
  }

private:
  const ShapeGrid* Grid;
  double Nodes = 0.0;
  Vector3 Sum{Vector3::Zero()};
  std::array<int, 3> First{std::numeric_limits<int>::max(), std::numeric_limits<int>::max(),
                           std::numeric_limits<int>::max()};
  std::array<int, 3> Last{-1, -1, -1};
};

class TopologyRepairer
{
public:
  TopologyRepairer(ShapeField& field, const TopologySettings& settings, TopologyReport& report)
      : Field(&field), Settings(settings), Report(&report), Inside(field.Values.size())
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
    this->Report->ObjectVolume = static_cast<double>(nodes) * this->Field->Grid.CellVolume();
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
    return this->Settings.BridgeParts ? this->JoinParts(largest, components)
                                      : this->SeveralParts(kept, components, largest);
  }

  Status SeveralParts(int count, const KuhnComponents& components, int largest) const
  {
    const double percent = 100.0 * static_cast<double>(components.Nodes(largest)) *
                           this->Field->Grid.CellVolume() / this->Report->ObjectVolume;
    char text[120];
    std::snprintf(text, sizeof(text),
                  "has %d separate parts; the largest has %.3g %% of its volume", count, percent);
    return Status::Failure(text);
  }

  // Puts whole components on the other side.
  void SetParts(const KuhnComponents& components, const std::vector<unsigned char>& isChosen,
                unsigned char side, TopologyChange& change)
  {
    std::vector<Place> places(isChosen.size(), Place(this->Field->Grid));
    components.VisitRuns(
        [&](std::size_t first, int count, int part)
        {
          if (isChosen[static_cast<std::size_t>(part)] != 0)
          {
            places[static_cast<std::size_t>(part)].AddRun(first, count);
            std::fill_n(this->Inside.begin() + static_cast<std::ptrdiff_t>(first), count, side);
          }
        });
    for (std::size_t part = 0; part < places.size(); ++part)
    {
      if (isChosen[part] != 0)
      {
        places[part].AddTo(change);
      }
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
      change.Count += 1;
      const double volume = static_cast<double>(bridge.Nodes.size()) * grid.CellVolume();
      change.Volume += volume;
      change.LargestVolume = std::max(change.LargestVolume, volume);
      if ((to - from).norm() > change.LargestExtent)
      {
        change.LargestExtent = (to - from).norm();
        change.LargestCentre = 0.5 * (from + to);
      }
      for (const std::size_t node : bridge.Nodes)
      {
        marks[node] = 2;
        this->Inside[node] = 1;
      }
      this->Mark(components, components.At(bridge.To), marks);
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
    const HandleRepair repair = RepairHandles(*this->Field, this->Inside, this->Settings.CutGap);
    this->SetNodes(repair.Cut, 0, this->Report->CutHandles);
    this->SetNodes(repair.Filled, 1, this->Report->FilledHandles);
  }

  void SetNodes(const NodeList& nodes, unsigned char side, TopologyChange& change)
  {
    std::vector<unsigned char> marks(this->Inside.size(), 0);
    for (const NodeList& part : ConnectedParts(nodes, OffsetsOf(this->Field->Grid), marks))
    {
      Place place(this->Field->Grid);
      for (const std::size_t node : part)
      {
        place.AddRun(node, 1);
        this->Inside[node] = side;
      }
      place.AddTo(change);
    }
  }

  void ApplyChanges()
  {
    const auto spacing = static_cast<float>(this->Field->Grid.Spacing);
    for (std::size_t node = 0; node < this->Inside.size(); ++node)
    {
      float& value = this->Field->Values[node];
      const bool isInside = this->Inside[node] != 0;
      if (isInside != (value > 0.0f))
      {
        const float depth = std::clamp(std::abs(value), 0.1f * spacing, 0.2f * spacing);
        value = isInside ? depth : -depth;
      }
    }
  }

  ShapeField* Field;
  TopologySettings Settings;
  TopologyReport* Report;
  std::vector<unsigned char> Inside;
};

bool IsValid(const TopologySettings& settings)
{
  return settings.SmallPart >= 0.0 && settings.SmallPart < 1.0 && settings.CutGap >= 0.0 &&
         std::isfinite(settings.CutGap);
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
