#pragma once

#include "ImageGrid.h"
#include "PalpateIOModule.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <vector>

namespace palpate
{
/// Consecutive voxels in memory order.
struct VoxelRun
{
  std::int64_t First;
  std::int64_t Count;
};

/// Label maps on one grid to which segments are added one by one, each to the first layer in which
/// it overlaps no earlier segment.
class PALPATEIO_EXPORT SegmentLayers
{
public:
  /// `largestLabel` determines the layers' scalar type, up to a larger one. `file` is for messages.
  /// Throws InputError if the first layer exceeds `mostBytes` bytes or does not fit into memory.
  SegmentLayers(const std::filesystem::path& file, const ImageGrid& grid, int largestLabel,
                double mostBytes);

  /// Adds the voxels of a segment; returns its layer. A label that the scalar type cannot hold
  /// changes that of all layers. Throws InputError if it needs another layer
  /// and all layers together would exceed `mostBytes`, not fit into memory, or be more than 1,024.
  int Add(int label, const std::vector<VoxelRun>& runs);
  /// Voxels that the runs share with each label added before.
  std::map<int, std::int64_t> Shared(const std::vector<VoxelRun>& runs) const;
  /// The layers as images; at least one.
  std::vector<vtkSmartPointer<vtkImageData>> Images() const;

private:
  void AddLayer();
  void Widen(int label);

  std::filesystem::path File;
  ImageGrid Grid;
  int Type;
  double MostBytes;
  std::vector<vtkSmartPointer<vtkDataArray>> Layers;
};
} // namespace palpate
