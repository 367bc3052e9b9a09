#include "LabelCenters.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace palpate
{
namespace
{
// Voxels first to end - 1 of a row that have one value.
struct Run
{
  int First, End, Y, Z;

  int Length() const { return this->End - this->First; }
};

template <typename T, typename Visit>
void ForEachRun(vtkImageData* layer, const Visit& visit)
{
  std::array<int, 3> size{};
  layer->GetDimensions(size.data());
  const auto* row = static_cast<const T*>(layer->GetPointData()->GetScalars()->GetVoidPointer(0));
  for (int z = 0; z < size[2]; ++z)
  {
    for (int y = 0; y < size[1]; ++y, row += size[0])
    {
      for (int first = 0; first < size[0];)
      {
        const T* end = std::find_if(row + first, row + size[0],
                                    [value = row[first]](T other) { return other != value; });
        const Run run{first, static_cast<int>(end - row), y, z};
        if (row[first] != 0)
        {
          visit(static_cast<int>(row[first]), run);
        }
        first = run.End;
      }
    }
  }
}

struct Middle
{
  Vector3 Sum = Vector3::Zero(); ///< of the indices
  double Voxels = 0.0;
  Vector3 Nearest = Vector3::Zero(); ///< index of the voxel nearest to the centroid
  double Distance = std::numeric_limits<double>::infinity(); ///< squared, mm

  void Add(const Run& run)
  {
    const double count = run.Length();
    this->Sum += count * Vector3(0.5 * (run.First + run.End - 1), run.Y, run.Z);
    this->Voxels += count;
  }
  void Approach(const Run& run, const Vector3& spacing)
  {
    const Vector3 centroid = this->Sum / this->Voxels;
    const double x = std::clamp(std::round(centroid.x()), static_cast<double>(run.First),
                                static_cast<double>(run.End - 1));
    const Vector3 voxel(x, run.Y, run.Z);
    const double distance = (voxel - centroid).cwiseProduct(spacing).squaredNorm();
    if (distance < this->Distance)
    {
      this->Distance = distance;
      this->Nearest = voxel;
    }
  }
};

using Middles = std::unordered_map<int, Middle>; // by voxel value

template <typename T>
Middles MiddlesOf(vtkImageData* layer)
{
  Middles middles;
  const Vector3 spacing(layer->GetSpacing());
  ForEachRun<T>(layer, [&](int value, const Run& run) { middles[value].Add(run); });
  ForEachRun<T>(layer, [&](int value, const Run& run) { middles[value].Approach(run, spacing); });
  return middles;
}

Middles MiddlesOfLayer(vtkImageData* layer)
{
  switch (layer->GetScalarType())
  {
  case VTK_UNSIGNED_CHAR:
    return MiddlesOf<unsigned char>(layer);
  case VTK_UNSIGNED_SHORT:
    return MiddlesOf<unsigned short>(layer);
  default:
    return MiddlesOf<int>(layer);
  }
}

// Of a voxel, counted from the first one.
Vector3 ToWorld(vtkImageData* layer, const Vector3& voxel)
{
  const int* extent = layer->GetExtent();
  const Vector3 index = voxel + Vector3(extent[0], extent[2], extent[4]);
  Vector3 world;
  layer->TransformContinuousIndexToPhysicalPoint(index.data(), world.data());
  return world;
}
} // namespace

std::map<int, Vector3> LabelCenters(const Segmentation& segmentation)
{
  std::vector<Middles> layers;
  for (const auto& layer : segmentation.Layers)
  {
    layers.push_back(MiddlesOfLayer(layer));
  }
  std::map<int, Vector3> centers;
  for (const Segment& segment : segmentation.Segments)
  {
    const auto layer = static_cast<std::size_t>(segment.Layer);
    const auto found = layers.at(layer).find(segment.Value);
    if (found != layers[layer].end())
    {
      centers[segment.Label] = ToWorld(segmentation.Layers[layer], found->second.Nearest);
    }
  }
  return centers;
}
} // namespace palpate
