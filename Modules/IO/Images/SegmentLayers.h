#pragma once

#include "ImageGrid.h"
#include "PalpateIOModule.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace palpate
{
/// Consecutive voxels, counted in the order of memory.
struct VoxelRun
{
  std::int64_t First;
  std::int64_t Count;
};

/// Label maps on one grid into which segments are laid one after the other: each into the first
/// layer where it overlaps none of those already there.
class PALPATEIO_EXPORT SegmentLayers
{
public:
  /// `largestLabel` decides the layers' scalar type. `file` is for messages. Throws InputError if
  /// the first layer has more than `mostBytes` bytes or does not fit into memory.
  SegmentLayers(const std::filesystem::path& file, const ImageGrid& grid, int largestLabel,
                double mostBytes);

  /// Adds the voxels of a segment; returns its layer. Throws InputError if it needs a further layer
  /// and all of them together exceed `mostBytes`, do not fit into memory, or are more than 1,024.
  int Add(int label, const std::vector<VoxelRun>& runs);
  /// The layers as images; at least one.
  std::vector<vtkSmartPointer<vtkImageData>> Images() const;

private:
  void AddLayer();

  std::filesystem::path File;
  ImageGrid Grid;
  int Type;
  double MostBytes;
  std::vector<vtkSmartPointer<vtkDataArray>> Layers;
};
} // namespace palpate
