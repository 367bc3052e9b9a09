#pragma once

#include "ImageFile.h"
#include "StoredVoxels.h"

namespace palpate
{
/// An image file whose voxels StoredVoxels reads. A format derives from it and sets the grid.
class StoredImageFile : public ImageFile
{
public:
  std::int64_t VolumeCount() const override { return this->Voxels.Layout().Volumes; }
  void ReadInto(void* buffer) override { this->Voxels.ReadInto(buffer, this->ChosenVolume); }

protected:
  /// Throws InputError if the file is too short.
  StoredImageFile(const std::filesystem::path& file, VoxelLayout layout)
      : ImageFile(file), Voxels(std::move(layout))
  {
    this->Voxels.CheckLength();
    this->Header.Components = 1;
    this->Header.VtkType = this->Voxels.ScalarType();
  }

private:
  StoredVoxels Voxels;
};
} // namespace palpate
