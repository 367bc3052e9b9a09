#include "SurfaceFile.h"

#include "AlgorithmErrors.h"
#include "BoundedPolyDataReader.h"
#include "CNumericLocale.h"
#include "FileEnding.h"
#include "ForeignFile.h"
#include "InputError.h"
#include "MeshFormats.h"
#include "MeshGltf.h"
#include "ObjReader.h"
#include "PlyReader.h"
#include "QuietStandardStreams.h"
#include "Refusal.h"
#include "SurfaceSpace.h"
#include "TriangleMesh.h"
#include "WholeFile.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkSTLReader.h"
#include "vtkStringArray.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <utility>

namespace palpate
{
namespace
{
// More than any surface that fits into memory here; a mistaken name must not fill the memory.
constexpr std::uintmax_t MaximumBytes = std::uintmax_t{4} << 30;

using MeshWriter = std::string (*)(const TriangleMesh&);

struct MeshFormat
{
  const char* Ending;
  MeshWriter Write;
};

constexpr std::array<MeshFormat, 6> MeshFormats{{{".stl", &MeshToStl},
                                                 {".ply", &MeshToPly},
                                                 {".obj", &MeshToObj},
                                                 {".gltf", &MeshToGltf},
                                                 {".glb", &MeshToGlb},
                                                 {".x3d", &MeshToX3d}}};

MeshWriter WriterOf(const std::string& ending)
{
  for (const MeshFormat& format : MeshFormats)
  {
    if (ending == format.Ending)
    {
      return format.Write;
    }
  }
  return nullptr;
}

std::string SurfaceToVtp(vtkPolyData* surface, const std::filesystem::path& path)
{
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(surface);
  // A field array of its own, so that the caller's data set stays as it is.
  vtkNew<vtkFieldData> fields;
  fields->ShallowCopy(surface->GetFieldData());
  vtkNew<vtkStringArray> frame;
  frame->SetName("Frame");
  frame->InsertNextValue("patient LPS, mm");
  fields->AddArray(frame);
  copy->SetFieldData(fields);
  vtkNew<vtkXMLPolyDataWriter> writer;
  const AlgorithmErrors errors(writer);
  writer->SetInputData(copy);
  writer->WriteToOutputStringOn();
  if (writer->Write() == 0 || errors.Raised())
  {
    Refuse(path, "cannot be written: " + errors.Message(), "choose another format");
  }
  return writer->GetOutputString();
}

// VTK's reader takes an STL file that is cut short without a word, and believes the count of what
// it takes for a binary one, by its share of letters that are none in ASCII. A binary one says how
// many triangles it has; a text one says where it ends. Returns its comment.
std::string CheckedStlComment(const std::filesystem::path& path)
{
  const std::string bytes = ReadWholeFile(path, MaximumBytes);
  constexpr std::size_t header = 80;
  std::uint64_t triangles = 0;
  for (std::size_t i = 4; i-- > 0 && bytes.size() >= header + 4;)
  {
    triangles = triangles << 8 | static_cast<unsigned char>(bytes[header + i]);
  }
  const bool isText =
      vtksys::SystemTools::DetectFileType(path.c_str()) == vtksys::SystemTools::FileTypeText;
  const bool isWhole =
      isText ? bytes.rfind("solid", 0) == 0 && bytes.find("endsolid") != std::string::npos
             : bytes.size() >= header + 4 + 50 * std::max<std::uint64_t>(triangles, 1);
  if (!isWhole)
  {
    Refuse(path, "is no whole STL file, perhaps cut short", "write the file again");
  }
  return bytes.substr(0, isText ? bytes.find('\n') : header);
}

// The comments before the first vertex.
std::string ObjComments(const std::string& text)
{
  std::istringstream lines(text);
  std::string comments;
  for (std::string line; std::getline(lines, line) && line.rfind("v ", 0) != 0;)
  {
    comments += line.rfind('#', 0) == 0 ? line + '\n' : std::string();
  }
  return comments;
}

vtkSmartPointer<vtkPolyData> TurnedToLps(SurfaceSpace space, vtkSmartPointer<vtkPolyData> surface)
{
  TurnToLps(space, surface);
  return surface;
}

template <typename Reader>
vtkSmartPointer<vtkPolyData> ReadWith(Reader* reader, const std::filesystem::path& path)
{
  const AlgorithmErrors errors(reader);
  reader->SetFileName(path.c_str());
  {
    // The readers' helper objects print, where no observer reaches.
    const QuietStandardStreams quiet;
    const CNumericLocale numbers;
    reader->Update();
  }
  if (errors.Raised())
  {
    Refuse(path, "cannot be read as a surface: " + errors.Message(), "write the file again");
  }
  return reader->GetOutput();
}

vtkSmartPointer<vtkPolyData> ReadVtp(const std::filesystem::path& path)
{
  vtkNew<BoundedPolyDataReader> reader;
  vtkSmartPointer<vtkPolyData> surface;
  try
  {
    surface = ReadWith(reader.Get(), path);
  }
  catch (const InputError&)
  {
    if (reader->Problem().empty())
    {
      throw;
    }
  }
  if (!reader->Problem().empty())
  {
    Refuse(path, "cannot be read as a surface: " + reader->Problem(), "write the file again");
  }
  return surface;
}

vtkSmartPointer<vtkPolyData> ReadByEnding(const std::filesystem::path& path)
{
  const std::string ending = FileEnding(path);
  if (ending == ".vtp")
  {
    CNumericLocale::RequireOfStreams(path);
    const vtkSmartPointer<vtkPolyData> surface = ReadVtp(path);
    return TurnedToLps(TakeSpaceOfFields(path, surface), surface);
  }
  if (ending == ".stl")
  {
    const SurfaceSpace space = SpaceOfComments(path, CheckedStlComment(path));
    return TurnedToLps(space, ReadWith(vtkNew<vtkSTLReader>().Get(), path));
  }
  if (ending == ".ply")
  {
    const std::string bytes = ReadWholeFile(path, MaximumBytes);
    const std::string header = bytes.substr(0, bytes.find("end_header"));
    return TurnedToLps(SpaceOfComments(path, header),
                       PolyDataOf(MeshFromPly(bytes, path.string())));
  }
  if (ending == ".obj")
  {
    const std::string text = ReadWholeFile(path, MaximumBytes);
    return TurnedToLps(SpaceOfComments(path, ObjComments(text)),
                       SurfaceFromObj(text, path.string()));
  }
  RefuseContent(path, "does not end as a surface that can be read", "use .vtp, .stl, .ply or .obj");
}
} // namespace

bool IsSurfaceFile(const std::filesystem::path& path)
{
  const std::string ending = FileEnding(path);
  return ending == ".vtp" || WriterOf(ending) != nullptr;
}

void WriteSurface(const std::filesystem::path& path, vtkPolyData* surface)
{
  const std::string ending = FileEnding(path);
  const MeshWriter write = WriterOf(ending);
  if (ending != ".vtp" && write == nullptr)
  {
    Refuse(path, "does not end as a surface file does",
           "use .vtp, .stl, .ply, .obj, .gltf, .glb or .x3d");
  }
  const TriangleMesh mesh = TrianglesOf(surface, path);
  WriteWholeFile(path, write == nullptr ? SurfaceToVtp(surface, path) : write(mesh));
}

vtkSmartPointer<vtkPolyData> ReadSurface(const std::filesystem::path& path)
{
  // Says what is wrong with the path itself better than the readers do.
  InputFileSize(path);
  vtkSmartPointer<vtkPolyData> surface = ReadByEnding(path);
  TrianglesOf(surface, path);
  return surface;
}
} // namespace palpate
