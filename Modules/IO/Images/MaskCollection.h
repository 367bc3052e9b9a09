#pragma once

#include "PalpateIOModule.h"
#include "SegmentLayers.h"
#include "Segmentation.h"

#include <filesystem>
#include <optional>
#include <string>

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
  /// there are several. Throws InputError if it lies on another grid than the first one.
  void Add(const Segmentation& segmentation, const std::string& name);

  /// Throws InputError if none was added.
  Segmentation Result();

private:
  Segmentation All;
  std::optional<ImageGrid> Grid;
  std::optional<SegmentLayers> Layers;
};
} // namespace palpate
