#include "NrrdFormat.h"

#include "ItkImageFile.h"
#include "ItkImageWriter.h"
#include "NrrdHeader.h"
#include "NrrdLimits.h"
#include "NrrdSpace.h"

namespace palpate
{
namespace
{
class NrrdFile : public ItkImageFile
{
public:
  explicit NrrdFile(const std::filesystem::path& file) : ItkImageFile(file)
  {
    CheckNrrdLimits(file);
    CheckNrrdHeader(file);
    const NrrdSpace space(file, ReadNrrdFields(file));
    this->OpenReader(ItkFormat::Nrrd, "NRRD");
    space.PlaceGrid(this->FileGrid);
    this->HeaderNotes = space.Notes();
  }

  void ReadInto(void* buffer) override
  {
    CheckNrrdData(this->File, static_cast<std::uint64_t>(this->DataBytes()));
    ItkImageFile::ReadInto(buffer);
  }

protected:
  void CheckLength() const override { CheckNrrdLength(this->File, this->DataBytes()); }
};

void WriteNrrd(const std::filesystem::path& file, vtkImageData* image, vtkDataArray* voxels)
{
  WriteWithItk(ItkFormat::Nrrd, file, image, voxels, true);
}
} // namespace

ImageFormat NrrdFormat()
{
  return {{"NRRD", {".nrrd", ".seg.nrrd", ".nhdr"}, {".nrrd"}},
          [](const std::filesystem::path& file) { return std::make_unique<NrrdFile>(file); },
          &WriteNrrd};
}
} // namespace palpate
