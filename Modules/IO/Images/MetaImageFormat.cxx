#include "MetaImageFormat.h"

#include "ItkImageFile.h"
#include "ItkImageWriter.h"
#include "MetaImageHeader.h"
#include "Refusal.h"

#include <algorithm>

namespace palpate
{
namespace
{
class MetaImageFile : public ItkImageFile
{
public:
  explicit MetaImageFile(const std::filesystem::path& file) : ItkImageFile(file)
  {
    const MetaImageFacts facts = CheckMetaImageHeader(file);
    this->OpenReader(ItkFormat::MetaImage, "MetaImage");
    // The values read must be those that were checked.
    const bool isSame =
        std::equal(facts.Size.begin(), facts.Size.end(), this->FileGrid.Size.begin()) &&
        this->Components() == 1 &&
        vtkDataArray::GetDataTypeSize(this->ScalarType()) == facts.VoxelBytes;
    if (!isSame)
    {
      Refuse(file, "has an ambiguous header", "copy or export it again");
    }
    this->HeaderNotes = facts.Notes;
    this->FileGrid.IsOriented = facts.IsOriented;
    this->FileGrid.Spacing *= facts.MillimetersPerUnit;
    this->FileGrid.OriginWorld *= facts.MillimetersPerUnit;
  }
};

void WriteMetaImage(const std::filesystem::path& file, vtkImageData* image, vtkDataArray* voxels)
{
  WriteWithItk(ItkFormat::MetaImage, file, image, voxels, true);
}
} // namespace

ImageFormat MetaImageFormat()
{
  return {{"MetaImage", {".mha", ".mhd"}, {".mha"}},
          [](const std::filesystem::path& file) { return std::make_unique<MetaImageFile>(file); },
          &WriteMetaImage,
          true};
}
} // namespace palpate
