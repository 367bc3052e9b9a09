#include "InclusionShare.h"

#include "CaseText.h"
#include "DecimalText.h"
#include "ImageGrid.h"
#include "SphereQuadrature.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
// Visits the voxels of a box, the first index axis fastest.
template <typename Visit>
void ForEachVoxel(const std::array<int, 3>& first, const std::array<int, 3>& last,
                  const Visit& visit)
{
  for (int k = first[2]; k <= last[2]; ++k)
  {
    for (int j = first[1]; j <= last[1]; ++j)
    {
      for (int i = first[0]; i <= last[0]; ++i)
      {
        visit(std::array<int, 3>{i, j, k});
      }
    }
  }
}

// 1 in a structure, 0 outside: the box around it with a voxel of margin, since label maps are
// mostly background. Null without a voxel.
std::shared_ptr<const TissueMap::Samples> FractionOf(vtkImageData* layer, int value)
{
  const ImageGrid grid = GridOf(layer);
  vtkDataArray* voxels = layer->GetPointData()->GetScalars();
  const auto isInside = [&](const std::array<int, 3>& at)
  {
    const vtkIdType row = at[1] + static_cast<vtkIdType>(grid.Size[1]) * at[2];
    return voxels->GetComponent(at[0] + grid.Size[0] * row, 0) == value;
  };
  std::array<int, 3> first = grid.Size;
  std::array<int, 3> last{{-1, -1, -1}};
  ForEachVoxel({{0, 0, 0}}, {{grid.Size[0] - 1, grid.Size[1] - 1, grid.Size[2] - 1}},
               [&](const std::array<int, 3>& at)
               {
                 const std::size_t axes = isInside(at) ? 3 : 0;
                 for (std::size_t axis = 0; axis < axes; ++axis)
                 {
                   first[axis] = std::min(first[axis], std::max(0, at[axis] - 1));
                   last[axis] = std::max(last[axis], std::min(grid.Size[axis] - 1, at[axis] + 1));
                 }
               });
  if (last[0] < 0)
  {
    return nullptr;
  }
  auto samples = std::make_shared<TissueMap::Samples>();
  const FieldGrid whole(grid.Size, grid.OriginWorld, grid.Spacing, grid.Direction);
  samples->Grid = FieldGrid(
      {{last[0] - first[0] + 1, last[1] - first[1] + 1, last[2] - first[2] + 1}},
      whole.PointWorld(Vector3(first[0], first[1], first[2])), grid.Spacing, grid.Direction);
  samples->Values.reserve(samples->Grid.NodeCount());
  ForEachVoxel(first, last,
               [&](const std::array<int, 3>& at)
               { samples->Values.push_back(isInside(at) ? 1.0F : 0.0F); });
  return samples;
}

// Whether points lie in a model; most of them are decided without evaluating it.
class Inside
{
public:
  explicit Inside(const RadialModel& model) : Model(model)
  {
    constexpr double Margin = 0.2; // of what the directions miss
    for (const Vector3& direction : SphereQuadrature(model.Degree() + 10).Directions)
    {
      const double radius = model.Radius(direction);
      this->Least = std::min(this->Least, (1.0 - Margin) * radius);
      this->Most = std::max(this->Most, (1.0 + Margin) * radius);
    }
  }

  bool Has(const Vector3& pointWorld) const
  {
    const Vector3 arm = pointWorld - this->Model.CenterWorld();
    const double distance = arm.norm();
    return distance < this->Least ||
           (distance < this->Most && distance < this->Model.Radius(arm / distance));
  }

private:
  const RadialModel& Model;
  double Least = std::numeric_limits<double>::infinity(); // mm
  double Most = 0.0;                                      // mm
};

std::string NameOf(const Segmentation& read, const std::vector<Segment>& segments)
{
  const bool isOneOfSeveral = segments.size() == 1 && read.Segments.size() > 1;
  return CaseTitle(read.Source, isOneOfSeveral ? segments.front() : Segment());
}
} // namespace

std::string InclusionShare::Note(const std::string& organ) const
{
  constexpr double Enough = 0.5;
  if (!this->IsInside())
  {
    return this->Name + " lies outside of " + organ + " and changes nothing";
  }
  const double part = this->InsideMilliliters / this->Milliliters;
  return part >= Enough
             ? std::string()
             : "only " + SignificantText(100.0 * part, 2) + " % of " + this->Name + " lies in " +
                   organ + " (" + SignificantText(this->InsideMilliliters, 3) + " of " +
                   SignificantText(this->Milliliters, 3) + " ml)";
}

InclusionFractions FractionsOf(const Segmentation& read, const std::vector<Segment>& segments)
{
  InclusionFractions fractions;
  for (const Segment& segment : segments)
  {
    vtkImageData* layer = read.Layers[static_cast<std::size_t>(segment.Layer)];
    if (auto fraction = FractionOf(layer, segment.Value))
    {
      fractions.push_back(std::move(fraction));
    }
  }
  return fractions;
}

InclusionShare ShareOf(const RadialModel& model, const Segmentation& read,
                       const std::vector<Segment>& segments, const InclusionFractions& fractions)
{
  constexpr double PerMilliliter = 1e-3; // ml/mm^3
  const Inside inside(model);
  InclusionShare share;
  share.Name = NameOf(read, segments);
  for (const auto& fraction : fractions)
  {
    const FieldGrid& grid = fraction->Grid;
    const double voxel = PerMilliliter * grid.Spacing().prod();
    const std::array<int, 3>& size = grid.Size();
    std::size_t next = 0;
    ForEachVoxel({{0, 0, 0}}, {{size[0] - 1, size[1] - 1, size[2] - 1}},
                 [&](const std::array<int, 3>& at)
                 {
                   if (fraction->Values[next++] > 0.0F)
                   {
                     const bool isIn = inside.Has(grid.PointWorld(Vector3(at[0], at[1], at[2])));
                     share.Milliliters += voxel;
                     share.InsideMilliliters += isIn ? voxel : 0.0;
                   }
                 });
  }
  return share;
}
} // namespace palpate
