#pragma once

#include "PalpateIOModule.h"
#include "SegmentLayers.h"
#include "Segmentation.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// Several segmentations on one grid, such as a folder with a mask of each organ, as one: labels
/// are numbered from 1 in the order in which they are added, and share layers as far as they do not
/// overlap.
class PALPATEIO_EXPORT MaskCollection
{
public:
  /// `source` is the folder, for messages.
  explicit MaskCollection(const std::filesystem::path& source);

  /// Adds the structures of a segmentation. One without a name gets `name`, with its number if
  /// there are several. A note that several have is kept once. Throws InputError if it lies on
  /// another grid than the first one.
  void Add(const Segmentation& segmentation, const std::string& name);

  /// Of structures that were added, those that overlap at all, with their Dice coefficient.
  struct Overlap
  {
    std::size_t First = 0; ///< index into Segmentation::Segments, as Second
    std::size_t Second = 0;
    double Dice = 0.0;
  };
  const std::vector<Overlap>& Overlaps() const { return this->Found; }
  /// Structures that were added.
  std::size_t Count() const { return this->All.Segments.size(); }

  /// Throws InputError if none was added.
  Segmentation Result();

private:
  void Compare(const std::vector<VoxelRun>& runs);

  Segmentation All;
  std::optional<ImageGrid> Grid;
  std::optional<SegmentLayers> Layers;
  std::vector<std::int64_t> Voxels; // of each segment
  std::vector<Overlap> Found;
};
} // namespace palpate
