#include "ForeignFile.h"

#include "FileFormat.h"
#include "Refusal.h"

#include <array>
#include <fstream>

namespace palpate
{
namespace
{
struct ForeignFormat
{
  const char* Mark; // how files begin, or how their names end
  const char* Is;
  const char* Remedy;
};

constexpr const char* ToImage = "convert it to NIfTI-1 (.nii.gz), NRRD or MetaImage";
constexpr const char* ToVolume = "use the volume that it was made from";
constexpr const char* IsVoxels = "has voxels without a header";
constexpr const char* Unpack = "unpack it and use the image in it";

constexpr std::array<ForeignFormat, 17> Formats{{
    {"<!DOCTYPE html", "is a web page", "download the file itself"},
    {"<!doctype html", "is a web page", "download the file itself"},
    {"<html", "is a web page", "download the file itself"},
    {"PK\x03\x04", "is a ZIP archive", Unpack},
    {".tar", "is an archive", Unpack},
    {".tar.gz", "is an archive", Unpack},
    {".tgz", "is an archive", Unpack},
    {"\x89PNG", "is a PNG image", ToVolume},
    {"\xFF\xD8\xFF", "is a JPEG image", ToVolume},
    {".img", IsVoxels, "specify its header (.hdr)"},
    {".img.gz", IsVoxels, "specify its header (.hdr)"},
    {".mnc", "is a MINC file, which is not supported", ToImage},
    {".raw", IsVoxels, "specify its header (.mhd or .nhdr)"},
    {".zraw", IsVoxels, "specify its header (.mhd)"},
    {".vti", "is a VTK image, which is not supported", ToImage},
    {".vtk", "is a legacy VTK file, of which only surfaces are supported", ToImage},
    {".json", "is a JSON file, not an image", "specify an image file"},
}};
} // namespace

void RefuseContent(const std::filesystem::path& file, const std::string& fact,
                   const std::string& remedy)
{
  std::string start(16, '\0');
  std::ifstream(file, std::ios::binary).read(start.data(), 16);
  for (const ForeignFormat& format : Formats)
  {
    if (start.rfind(format.Mark, 0) == 0 || !EndingOf(file, {format.Mark}).empty())
    {
      Refuse(file, format.Is, format.Remedy);
    }
  }
  Refuse(file, fact, remedy);
}
} // namespace palpate
