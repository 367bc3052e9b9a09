#include "ForbiddenStructure.h"

#include "FilterRun.h"
#include "NodeBox.h"
#include "OwnCopy.h"
#include "RemovalStroke.h"
#include "vtkSegmentationSurface.h"

#include "vtkBoundingBox.h"
#include "vtkImageData.h"
#include "vtkImplicitPolyDataDistance.h"
#include "vtkNew.h"

#include <algorithm>
#include <limits>

namespace palpate
{
namespace
{
constexpr int Side = RemovedDistances::Side;
using Corner = RemovedDistances::Corner;

// Makes the blocks of a protected region; only those near its surface are evaluated node by node.
class ProtectionMaker
{
public:
  ProtectionMaker(const ForbiddenStructure& structure, const RemovedDistances& like)
      : Structure(structure), Grid(like.Grid()), Band(like.Band()),
        Made(RemovedDistances::None(like.Grid(), like.Band()))
  {
  }

  std::shared_ptr<const RemovedDistances> Make(const ProgressFunction& progress)
  {
    const vtkBoundingBox bounds(this->Structure.Surface()->GetBounds());
    const Vector3 band = Vector3::Constant(this->Band);
    const auto [first, last] = NodesRound(
        this->Grid, {Vector3(bounds.GetMinPoint()) - band, Vector3(bounds.GetMaxPoint()) + band},
        0.0);
    const int begin = first[2] / Side * Side;
    for (int k = begin; k <= last[2]; k += Side)
    {
      ReportProgress(progress, static_cast<double>(k - begin) / (last[2] - begin + 1),
                     "protection");
      for (int j = first[1] / Side * Side; j <= last[1]; j += Side)
      {
        for (int i = first[0] / Side * Side; i <= last[0]; i += Side)
        {
          this->MakeBlock({i, j, k});
        }
      }
    }
    return this->Made.Finish();
  }

private:
  void MakeBlock(const Corner& corner)
  {
    const Vector3 first(corner[0], corner[1], corner[2]);
    const double reach = 0.5 * (Side - 1) * this->Grid.Spacing().norm();
    const double middle = this->Structure.Distance(
        this->Grid.PointWorld(first + Vector3::Constant(0.5 * (Side - 1))));
    if (middle - reach >= this->Band)
    {
      return;
    }
    RemovalStroke::Nodes distances;
    const bool isDeep = middle + reach <= -this->Band;
    for (std::size_t n = 0; n < distances.size(); ++n)
    {
      const auto number = static_cast<int>(n);
      const int layer = number / (Side * Side);
      const Vector3 node(number % Side, number / Side % Side, layer);
      const double distance =
          isDeep ? -this->Band : this->Structure.Distance(this->Grid.PointWorld(first + node));
      distances[n] = static_cast<float>(std::clamp(distance, -this->Band, this->Band));
    }
    this->Made.Set(corner, distances);
  }

  const ForbiddenStructure& Structure;
  const FieldGrid& Grid;
  double Band; // mm
  RemovalStroke Made;
};
} // namespace

ForbiddenStructure::ForbiddenStructure(vtkPolyData* surface)
    : Triangles(surface), Query(vtkSmartPointer<vtkImplicitPolyDataDistance>::New())
{
  this->Query->SetInput(surface);
}

ForbiddenStructure::~ForbiddenStructure() = default;

double ForbiddenStructure::Distance(const Vector3& pointWorld) const
{
  return this->Query->EvaluateFunction(pointWorld[0], pointWorld[1], pointWorld[2]);
}

double ForbiddenStructure::Distance(const ToolShape& tool, const ToolPose& pose) const
{
  if (tool.IsSphere())
  {
    return this->Distance(pose.PositionWorld) - tool.Radius();
  }
  double least = std::numeric_limits<double>::max();
  for (std::size_t n = 0; n < tool.Points().size(); ++n)
  {
    if (tool.BallAt(n).Cuts)
    {
      const Vector3 point = pose.PositionWorld + pose.Orientation * tool.Points()[n];
      least = std::min(least, this->Distance(point));
    }
  }
  return least;
}

vtkSmartPointer<vtkPolyData> MakeForbiddenSurface(const Segmentation& segmentation,
                                                  const Segment& segment,
                                                  const ProgressFunction& progress)
{
  vtkNew<vtkSegmentationSurface> surface;
  surface->SetInputData(
      OwnCopy(segmentation.Layers[static_cast<std::size_t>(segment.Layer)].Get()));
  surface->SetLabel(segment.Value);
  surface->SetComponent(0);
  RunFilter(surface, "surface", 0.0, 1.0, progress);
  return surface->GetOutput();
}

std::shared_ptr<const RemovedDistances> ProtectionOf(const ForbiddenStructure& structure,
                                                     const RemovedDistances& like,
                                                     const ProgressFunction& progress)
{
  return ProtectionMaker(structure, like).Make(progress);
}

std::shared_ptr<const RemovedDistances>
JoinProtections(const std::vector<std::shared_ptr<const RemovedDistances>>& parts)
{
  if (parts.size() == 1)
  {
    return parts.front();
  }
  RemovalStroke joined(RemovedDistances::None(parts.front()->Grid(), parts.front()->Band()));
  for (const auto& part : parts)
  {
    for (const Corner& corner : part->Corners())
    {
      RemovalStroke::Nodes nodes;
      nodes.fill(static_cast<float>(part->Band()));
      for (const auto& other : parts)
      {
        const float* block = other->BlockAt(corner);
        for (std::size_t n = 0; block != nullptr && n < nodes.size(); ++n)
        {
          nodes[n] = std::min(nodes[n], block[n]);
        }
      }
      joined.Set(corner, nodes); // once only: another part may have the block too
    }
  }
  return joined.Finish();
}
} // namespace palpate
