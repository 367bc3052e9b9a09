#include "NiftiFormat.h"

#include "CaretLabels.h"
#include "HeaderBytes.h"
#include "ItkImageWriter.h"
#include "NiftiHeader.h"
#include "StoredImageFile.h"

#include <cstring>
#include <stdexcept>
#include <zlib.h>

namespace palpate
{
namespace
{
class NiftiFile : public StoredImageFile
{
public:
  NiftiFile(const std::filesystem::path& file, const NiftiHeader& header)
      : StoredImageFile(file, header.Voxels)
  {
    this->FileGrid.Size = header.Size;
    this->FileGrid.Spacing = header.Spacing;
    PlaceGrid(file, header.Orientation, this->FileGrid);
    this->HeaderNotes = OrientationNotes(header.Orientation, this->FileGrid);
    if (header.IsAnalyze)
    {
      this->FileGrid.IsOriented = false;
      this->HeaderNotes = {"Analyze files state no reliable orientation; the index axes were taken "
                           "as L, P, S, as ITK does: check left and right."};
    }
    this->HeaderLabels = header.Labels;
    this->HeaderNotes.insert(this->HeaderNotes.end(), header.Notes.begin(), header.Notes.end());
  }
};

template <bool IsPair>
std::unique_ptr<ImageFile> OpenNifti(const std::filesystem::path& file)
{
  return std::make_unique<NiftiFile>(file, ReadNiftiHeader(file, IsPair));
}

void WriteNifti(const std::filesystem::path& file, vtkImageData* image, vtkDataArray* voxels)
{
  WriteWithItk(ItkFormat::Nifti, file, image, voxels, !EndingOf(file, {".gz"}).empty());
}

// The extension of a header: its size, a multiple of 16, its code, its text, zeros.
std::string CaretExtension(const LabelTable& labels)
{
  constexpr std::size_t Unit = 16;
  const std::string text = CaretTextOf(labels);
  const std::int32_t head[2] = {
      static_cast<std::int32_t>((text.size() + sizeof head + Unit - 1) / Unit * Unit),
      CaretExtensionCode};
  std::string bytes(reinterpret_cast<const char*>(head), sizeof head);
  bytes += text;
  bytes.resize(static_cast<std::size_t>(head[0]), '\0');
  return bytes;
}

// ITK writes a header without extensions, which stays but for the place of the voxels.
void AddNiftiLabels(const std::filesystem::path& file, vtkDataArray* voxels,
                    const LabelTable& labels)
{
  constexpr std::size_t MarkPlace = 348;
  constexpr std::size_t OffsetPlace = 108;
  const std::string extension = CaretExtension(labels);
  const HeaderBytes written(file, MarkPlace + 4);
  std::string header = written.TextAt(0, written.Size());
  header.resize(MarkPlace + 4, '\0');
  const auto offset = static_cast<float>(header.size() + extension.size());
  std::memcpy(&header[OffsetPlace], &offset, sizeof offset);
  header[MarkPlace] = 1;
  const char* mode = written.IsCompressed() ? "wb6" : "wbT";
  std::unique_ptr<gzFile_s, int (*)(gzFile_s*)> stream(gzopen(file.c_str(), mode), gzclose);
  const auto count = static_cast<std::size_t>(voxels->GetNumberOfValues());
  const auto size = static_cast<std::size_t>(voxels->GetDataTypeSize());
  header += extension;
  if (!stream || gzfwrite(header.data(), header.size(), 1, stream.get()) != 1 ||
      gzfwrite(voxels->GetVoidPointer(0), size, count, stream.get()) != count ||
      gzclose(stream.release()) != Z_OK)
  {
    throw std::runtime_error("writing stopped early");
  }
}
} // namespace

ImageFormat NiftiFormat()
{
  return {{"NIfTI", {".nii", ".nii.gz"}, {".nii", ".nii.gz"}},
          &OpenNifti<false>,
          &WriteNifti,
          false,
          &AddNiftiLabels};
}

ImageFormat NiftiPairFormat()
{
  return {{"NIfTI or Analyze pair", {".hdr", ".hdr.gz"}, {}}, &OpenNifti<true>, nullptr};
}
} // namespace palpate
