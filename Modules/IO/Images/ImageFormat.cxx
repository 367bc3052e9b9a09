#include "ImageFormat.h"

#include "FileKind.h"
#include "ForeignFile.h"
#include "GiplFormat.h"
#include "MetaImageFormat.h"
#include "MghFormat.h"
#include "NiftiFormat.h"
#include "NrrdFormat.h"
#include "Refusal.h"
#include "SurfaceFile.h"

namespace palpate
{
FormatList<ImageFormat>& ImageFormats()
{
  static FormatList<ImageFormat> formats({NiftiFormat(), NiftiPairFormat(), NrrdFormat(),
                                          MetaImageFormat(), MghFormat(), GiplFormat()});
  return formats;
}

const ImageFormat& ImageFormatOf(const std::filesystem::path& file)
{
  if (const ImageFormat* const format = ImageFormats().Reader(file))
  {
    return *format;
  }
  // Legacy VTK files have images too, which are refused as such.
  if (SurfaceFormats().Reader(file) != nullptr && EndingOf(file, {".vtk"}).empty())
  {
    Refuse(file, "is a surface, not an image",
           "use voxels here, and surfaces with commands that take them");
  }
  std::string known;
  for (const ImageFormat& format : ImageFormats())
  {
    known += format.Name + " (" + ListOfEndings(format.ReadEndings) + "), ";
  }
  RefuseContent(file, "is not in a known image format",
                "use " + known + "DICOM, or of surfaces " +
                    ListOfEndings(SurfaceFormats().ReadEndings()));
}

std::unique_ptr<ImageFile> OpenImage(const std::filesystem::path& file, ShearedAxes sheared)
{
  std::unique_ptr<ImageFile> image = ImageFormatOf(file).Open(file);
  image->CheckVolume(sheared);
  return image;
}

std::vector<std::string> ReadableImageEndings()
{
  std::vector<std::string> endings = ImageFormats().ReadEndings();
  endings.insert(endings.end(), DicomEndings.begin(), DicomEndings.end());
  return endings;
}

std::string ImageNameOf(const std::filesystem::path& file)
{
  std::string name = file.filename().string();
  name.erase(name.size() - EndingOf(file, ReadableImageEndings()).size());
  return name;
}
} // namespace palpate
