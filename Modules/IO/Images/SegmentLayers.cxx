#include "SegmentLayers.h"

#include "AvailableMemory.h"
#include "DecimalText.h"
#include "LabelValues.h"
#include "Refusal.h"

#include "vtkSetGet.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr std::size_t MostLayers = 1024;

template <typename T>
bool IsFree(const T* layer, const std::vector<VoxelRun>& runs)
{
  return std::all_of(runs.begin(), runs.end(),
                     [layer](const VoxelRun& run)
                     {
                       const T* first = layer + run.First;
                       return std::all_of(first, first + run.Count,
                                          [](T value) { return value == T(0); });
                     });
}

template <typename T>
void Fill(T* layer, const std::vector<VoxelRun>& runs, int label)
{
  for (const VoxelRun& run : runs)
  {
    std::fill_n(layer + run.First, run.Count, static_cast<T>(label));
  }
}

template <typename T>
void CountShared(const T* layer, const std::vector<VoxelRun>& runs,
                 std::map<int, std::int64_t>& shared)
{
  for (const VoxelRun& run : runs)
  {
    const T* const end = layer + run.First + run.Count;
    for (const T* voxel = layer + run.First; voxel != end;)
    {
      const T label = *voxel;
      const T* const first = voxel;
      voxel = std::find_if(first, end, [label](T value) { return value != label; });
      if (label != T(0))
      {
        shared[static_cast<int>(label)] += voxel - first;
      }
    }
  }
}

bool TryFill(vtkDataArray* layer, const std::vector<VoxelRun>& runs, int label)
{
  bool isFree = false;
  void* data = layer->GetVoidPointer(0);
  switch (layer->GetDataType())
  {
    vtkTemplateMacro(isFree = IsFree(static_cast<const VTK_TT*>(data), runs);
                     if (isFree) Fill(static_cast<VTK_TT*>(data), runs, label));
  }
  return isFree;
}
} // namespace

SegmentLayers::SegmentLayers(const std::filesystem::path& file, const ImageGrid& grid,
                             int largestLabel, double mostBytes)
    : File(file), Grid(grid), Type(LabelType(largestLabel)), MostBytes(mostBytes)
{
  this->AddLayer();
}

void SegmentLayers::AddLayer()
{
  auto layer = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(this->Type));
  const double bytes = static_cast<double>(this->Grid.VoxelCount()) * layer->GetDataTypeSize();
  const double layers = static_cast<double>(this->Layers.size() + 1);
  if (layers > MostLayers || !(layers * bytes <= this->MostBytes))
  {
    Refuse(this->File,
           "has " + SignificantText(layers) + " overlapping layers of " +
               std::to_string(this->Grid.Size[0]) + " x " + std::to_string(this->Grid.Size[1]) +
               " x " + std::to_string(this->Grid.Size[2]) + " voxels, most of them without data",
           "export fewer segments at a time");
  }
  CheckMemory(this->File, bytes);
  layer->SetNumberOfTuples(this->Grid.VoxelCount());
  layer->Fill(0.0);
  this->Layers.push_back(layer);
}

void SegmentLayers::Widen(int label)
{
  this->Type = LabelType(label);
  for (vtkSmartPointer<vtkDataArray>& layer : this->Layers)
  {
    auto wide = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(this->Type));
    CheckMemory(this->File,
                static_cast<double>(layer->GetNumberOfTuples()) * wide->GetDataTypeSize());
    wide->DeepCopy(layer);
    layer = wide;
  }
}

int SegmentLayers::Add(int label, const std::vector<VoxelRun>& runs)
{
  if (label > this->Layers.front()->GetDataTypeMax())
  {
    this->Widen(label);
  }
  std::size_t place = 0;
  while (!TryFill(this->Layers[place], runs, label))
  {
    if (++place == this->Layers.size())
    {
      this->AddLayer();
    }
  }
  return static_cast<int>(place);
}

std::map<int, std::int64_t> SegmentLayers::Shared(const std::vector<VoxelRun>& runs) const
{
  std::map<int, std::int64_t> shared;
  for (const auto& layer : this->Layers)
  {
    const void* data = layer->GetVoidPointer(0);
    switch (layer->GetDataType())
    {
      vtkTemplateMacro(CountShared(static_cast<const VTK_TT*>(data), runs, shared));
    }
  }
  return shared;
}

std::vector<vtkSmartPointer<vtkImageData>> SegmentLayers::Images() const
{
  std::vector<vtkSmartPointer<vtkImageData>> images;
  for (const auto& layer : this->Layers)
  {
    images.push_back(MakeImage(this->Grid, layer));
  }
  return images;
}
} // namespace palpate
