#pragma once

#include "DicomDataset.h"
#include "DicomPixelData.h"
#include "PalpateIOModule.h"
#include "SegmentLayers.h"
#include "SliceStack.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

namespace palpate
{
/// The frames of a DICOM segmentation object: planes, segment numbers (0 for a frame with several
/// segments) and pixels.
class PALPATEIO_EXPORT DicomSegmentationFrames
{
public:
  /// Throws InputError if the planes do not form a stack, if there are fewer pixels than the header
  /// declares, or if a frame has no item of its own. Time and memory are bounded by the file's
  /// pixels and items.
  /// `dataset` must outlive the object.
  DicomSegmentationFrames(const std::filesystem::path& file, const DicomDataset& dataset);
  DicomSegmentationFrames(const DicomSegmentationFrames&) = delete;
  DicomSegmentationFrames& operator=(const DicomSegmentationFrames&) = delete;

  /// Right-handed by construction: its third axis is the cross product of the others.
  const ImageGrid& Grid() const { return this->Stack.Grid; }
  /// On positions of frames that are not even.
  const std::vector<std::string>& Notes() const { return this->Stack.Notes; }
  std::size_t Count() const { return this->Planes.size(); }
  std::int64_t PixelCount() const
  {
    return static_cast<std::int64_t>(this->Planes.size()) * this->PixelsPerFrame;
  }
  int SegmentNumber(std::size_t frame) const { return this->SegmentNumbers[frame]; }
  /// Appends the runs of a frame's pixels that are at least `threshold` (> 0), as voxels of the
  /// grid.
  void AppendRuns(std::size_t frame, int threshold, std::vector<VoxelRun>& runs) const;
  /// Appends the runs of each value but 0 in a frame.
  void AppendRunsByValue(std::size_t frame, std::map<int, std::vector<VoxelRun>>& runs) const;

private:
  int Value(std::size_t frame, std::int64_t pixel) const;
  // The first non-zero pixel from `pixel` on, or the pixel count.
  std::int64_t SkipZeros(std::size_t frame, std::int64_t pixel) const;
  std::int64_t FirstVoxel(std::size_t frame) const
  {
    return static_cast<std::int64_t>(this->Stack.SliceOfPlane[frame]) * this->PixelsPerFrame;
  }
  void ReadPixels(const std::filesystem::path& file, const DicomDataset& dataset);
  void ReadPlanes(const std::filesystem::path& file, const DicomDataset& dataset);

  std::vector<StackedSlice> Planes;
  std::vector<int> SegmentNumbers;
  SliceStack Stack;
  StackedSlice Form; // columns and rows of every frame
  std::size_t FrameCount = 0;
  std::int64_t PixelsPerFrame = 0;
  int BitsPerPixel = 1;
  std::optional<DicomPixelData> PixelData;
  const std::uint8_t* Pixels = nullptr; // in PixelData
};
} // namespace palpate
