#include "ForeignFile.h"

#include "FileEnding.h"
#include "Refusal.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>
#include <string_view>
#include <zlib.h>

namespace palpate
{
namespace
{
constexpr std::size_t HeadBytes = 512; // up to where a tar archive and a legacy VTK file say so
constexpr const char* ToImage = "convert it to NIfTI-1 (.nii.gz), NRRD or MetaImage";
constexpr const char* ToSurface = "use voxels here, and surfaces with commands that take them";

// The start of a file's content.
struct Head
{
  explicit Head(const std::filesystem::path& file) : Bytes(HeadBytes, '\0')
  {
    // gzread passes files that are not compressed through as they are.
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> stream(gzopen(file.c_str(), "rb"), gzclose);
    const int got = stream ? gzread(stream.get(), this->Bytes.data(), HeadBytes) : 0;
    this->IsCompressed = stream && gzdirect(stream.get()) == 0;
    this->Bytes.resize(static_cast<std::size_t>(std::max(0, got)));
  }

  bool Has(std::size_t offset, std::string_view mark) const
  {
    return this->Bytes.size() >= offset + mark.size() &&
           std::string_view(this->Bytes).substr(offset, mark.size()) == mark;
  }

  bool StartsWith(std::string_view mark) const { return this->Has(0, mark); }

  std::string Bytes;
  bool IsCompressed = false;
};

using std::string_view_literals::operator""sv;

// The word after the first `key`, in capitals; empty if there is none.
std::string WordAfter(const Head& head, std::string_view key)
{
  const std::size_t at = head.Bytes.find(key);
  std::string word;
  for (std::size_t i = at + key.size(); at != std::string::npos && i < head.Bytes.size(); ++i)
  {
    const auto letter = static_cast<unsigned char>(head.Bytes[i]);
    if (std::isalpha(letter) == 0 && letter != '_')
    {
      break;
    }
    word += static_cast<char>(std::toupper(letter));
  }
  return word;
}

ForeignFile LegacyVtk(const Head& head)
{
  const std::string kind = WordAfter(head, "DATASET ");
  const std::string name = "is a legacy VTK file" + (kind.empty() ? "" : " (" + kind + ")");
  if (kind == "POLYDATA")
  {
    return {name + ", a surface", "save it as .vtp for commands that take surfaces"};
  }
  if (kind == "STRUCTURED_POINTS")
  {
    return {name + ", an image that does not state its orientation in the patient", ToImage};
  }
  return {name, "save an image as NIfTI-1, NRRD or MetaImage, and a surface as .vtp"};
}

ForeignFile XmlVtk(const Head& head)
{
  const std::string kind = WordAfter(head, "type=\"");
  return kind == "POLYDATA" ? ForeignFile{"is a VTK surface, not an image", ToSurface}
                            : ForeignFile{"is a VTK file (" + kind + ")", ToImage};
}

// Whether the ending is one of these, " .a .b ".
bool EndsAs(const std::string& ending, std::string_view endings)
{
  return !ending.empty() && endings.find(" " + ending + " ") != std::string_view::npos;
}

std::optional<ForeignFile> NiftiOrAnalyze(const Head& head, const std::string& ending)
{
  if (head.Has(344, "ni1"sv))
  {
    return ForeignFile{"is the header of a NIfTI pair (.hdr and .img), which is not supported",
                       "convert the pair to one file (.nii.gz)"};
  }
  if (head.Has(344, "n+1"sv) && !EndsAs(ending, " .nii .nii.gz "))
  {
    return ForeignFile{"is a NIfTI file by content but not by name",
                       std::string("rename it to end in ") +
                           (head.IsCompressed ? ".nii.gz" : ".nii")};
  }
  // The header's own size, 348, in either byte order; an Analyze header has no mark of its own.
  const bool isAnalyze = head.Bytes.size() >= 348 && head.Has(344, "\0\0\0\0"sv) &&
                         (head.StartsWith("\x5C\x01\0\0"sv) || head.StartsWith("\0\0\x01\x5C"sv));
  if (isAnalyze)
  {
    return ForeignFile{
        "is an Analyze 7.5 header, which does not state its image's orientation in the patient",
        "convert header and .img to NIfTI-1 (.nii.gz) and check left and right"};
  }
  return std::nullopt;
}

struct Mark
{
  std::size_t Offset;
  std::string_view Bytes;
  const char* Is;
  const char* Remedy;
  std::string_view Own = {}; // endings that match the content: not a foreign file
};

constexpr const char* ToVolume = "use the volume that it was made from";
constexpr const char* Unpack = "unpack it and use the image in it";

constexpr std::array<Mark, 15> Marks{{
    {0, "NRRD000"sv, "is an NRRD file by content but not by name", "rename it to end in .nrrd",
     " .nrrd .seg.nrrd .nhdr "sv},
    {0, "ObjectType"sv, "is a MetaImage by content but not by name",
     "rename it to end in .mha, or .mhd if its voxels are in another file", " .mha .mhd "sv},
    {128, "DICM"sv, "is a DICOM file by content but not by name", "rename it to end in .dcm",
     " .dcm .ima "sv},
    {0, "<!DOCTYPE html"sv, "is a web page", "download the file itself"},
    {0, "<!doctype html"sv, "is a web page", "download the file itself"},
    {0, "<html"sv, "is a web page", "download the file itself"},
    {0, "PK\x03\x04"sv, "is a ZIP archive", Unpack},
    {257, "ustar"sv, "is a tar archive", Unpack},
    {0, "\x89PNG"sv, "is a PNG image", ToVolume},
    {0, "\xFF\xD8\xFF"sv, "is a JPEG image", ToVolume},
    {0, "II*\0"sv, "is a TIFF image", ToVolume},
    {0, "MM\0*"sv, "is a TIFF image", ToVolume},
    {0, "\x89HDF"sv, "is an HDF5 file, perhaps MINC", ToImage},
    {0, "CDF\x01"sv, "is a NetCDF file, perhaps MINC", ToImage},
    {0, "%PDF"sv, "is a PDF document", ToVolume},
}};

std::optional<ForeignFile> ByContent(const Head& head, const std::string& ending)
{
  if (head.StartsWith("# vtk DataFile"sv))
  {
    return LegacyVtk(head);
  }
  if (head.Bytes.find("<VTKFile") != std::string::npos)
  {
    return XmlVtk(head);
  }
  for (const Mark& mark : Marks)
  {
    if (head.Has(mark.Offset, mark.Bytes) && !EndsAs(ending, mark.Own))
    {
      return ForeignFile{mark.Is, mark.Remedy};
    }
  }
  return NiftiOrAnalyze(head, ending);
}

struct Ending
{
  const char* Name;
  const char* Is;
  const char* Remedy;
};

constexpr std::array<Ending, 10> Endings{{
    {".hdr", "is a header whose image is in an .img file, which is not supported", ToImage},
    {".img", "has the voxels of a pair (.hdr and .img), which is not supported",
     "convert the pair to one NIfTI file (.nii.gz)"},
    {".mgz", "is a FreeSurfer volume, which is not supported",
     "convert it (mri_convert) to .nii.gz"},
    {".mgh", "is a FreeSurfer volume, which is not supported",
     "convert it (mri_convert) to .nii.gz"},
    {".mnc", "is a MINC file, which is not supported", ToImage},
    {".raw", "has voxels without a header", "specify its header (.mhd or .nhdr)"},
    {".zraw", "has voxels without a header", "specify its header (.mhd)"},
    {".gii", "is a GIFTI surface, not an image", ToSurface},
    {".json", "is a JSON file, not an image", "specify an image file"},
    {".csv", "is a table, not an image", "specify an image file"},
}};

std::optional<ForeignFile> ByEnding(const std::string& ending)
{
  const auto* found = std::find_if(Endings.begin(), Endings.end(),
                                   [&](const Ending& one) { return ending == one.Name; });
  return found == Endings.end() ? std::nullopt
                                : std::optional<ForeignFile>({found->Is, found->Remedy});
}
} // namespace

std::optional<ForeignFile> RecognizeForeignFile(const std::filesystem::path& file)
{
  const Head head(file);
  const std::string ending = FileEnding(file);
  std::optional<ForeignFile> found = ByContent(head, ending);
  const bool isOwnNifti = head.Has(344, "n+1"sv);
  if (found && head.IsCompressed && !isOwnNifti)
  {
    found->Is = "is a gzip file, and its content " + found->Is;
    found->Remedy = "unpack it (gunzip); then " + found->Remedy;
  }
  found = found ? found : ByEnding(ending);
  if (!found && head.IsCompressed && ending != ".nii.gz")
  {
    found = ForeignFile{"is a gzip file whose content is not a known image",
                        "unpack it (gunzip) and use an image"};
  }
  return found;
}

void RefuseContent(const std::filesystem::path& file, const std::string& fact,
                   const std::string& remedy)
{
  const std::optional<ForeignFile> known = RecognizeForeignFile(file);
  Refuse(file, known ? known->Is : fact, known ? known->Remedy : remedy);
}
} // namespace palpate
