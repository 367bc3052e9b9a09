#include "SurfaceFile.h"

#include "AlgorithmErrors.h"
#include "BoundedPolyDataReader.h"
#include "CNumericLocale.h"
#include "ForeignFile.h"
#include "GiftiReader.h"
#include "GltfReader.h"
#include "InputError.h"
#include "LegacyVtkReader.h"
#include "MeshFormats.h"
#include "MeshGifti.h"
#include "MeshGltf.h"
#include "ObjReader.h"
#include "PlyReader.h"
#include "QuietStandardStreams.h"
#include "Refusal.h"
#include "StlText.h"
#include "SurfaceSpace.h"
#include "TriangleMesh.h"
#include "WholeFile.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkSTLReader.h"
#include "vtkStringArray.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtksys/SystemTools.hxx"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>
#include <sstream>
#include <utility>

namespace palpate
{
namespace
{
// More than any surface that fits into memory; a wrong file must not fill the memory.
constexpr std::uintmax_t MaximumBytes = std::uintmax_t{4} << 30;

std::string PolyDataToVtp(vtkPolyData* surface, const std::filesystem::path& path)
{
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(surface);
  // In a copy of the field data, so that the caller's data set is unchanged.
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
  writer->SetCompressionLevel(1); // half of the default's time for 3 % more bytes
  writer->WriteToOutputStringOn();
  if (writer->Write() == 0 || errors.Raised())
  {
    Refuse(path, "cannot be written: " + errors.Message(), "choose another format");
  }
  return writer->GetOutputString();
}

std::string SurfaceToVtp(const TriangleMesh&, vtkPolyData* surface,
                         const std::filesystem::path& path)
{
  return PolyDataToVtp(surface, path);
}

// VTK's reader trusts the triangle count of a binary file and silently accepts fewer. It takes a
// file for text if it has few bytes that are not ASCII.
void CheckBinaryStl(const std::filesystem::path& path, const std::string& bytes)
{
  constexpr std::uint64_t OneTriangle = 134;
  const bool isText =
      vtksys::SystemTools::DetectFileType(path.c_str()) == vtksys::SystemTools::FileTypeText;
  if (isText || bytes.size() < std::max(BinaryStlBytes(bytes), OneTriangle))
  {
    Refuse(path, "is not a complete STL file (it may be truncated)", "write the file again");
  }
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
    // The readers' helper objects print directly, so an observer does not catch it.
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

vtkSmartPointer<vtkPolyData> ReadVtpInLps(const std::filesystem::path& path)
{
  CNumericLocale::RequireOfStreams(path);
  const vtkSmartPointer<vtkPolyData> surface = ReadVtp(path);
  return TurnedToLps(TakeSpaceOfFields(path, surface), surface);
}

vtkSmartPointer<vtkPolyData> ReadStl(const std::filesystem::path& path)
{
  const std::string bytes = ReadWholeFile(path, MaximumBytes);
  if (IsStlText(bytes))
  {
    return TurnedToLps(SpaceOfComments(path, bytes.substr(0, bytes.find('\n'))),
                       PolyDataOf(MeshFromStlText(bytes, path.string())));
  }
  CheckBinaryStl(path, bytes);
  return TurnedToLps(SpaceOfComments(path, bytes.substr(0, 80)),
                     ReadWith(vtkNew<vtkSTLReader>().Get(), path));
}

vtkSmartPointer<vtkPolyData> ReadPly(const std::filesystem::path& path)
{
  const std::string bytes = ReadWholeFile(path, MaximumBytes);
  const std::string header = bytes.substr(0, bytes.find("end_header"));
  return TurnedToLps(SpaceOfComments(path, header), PolyDataOf(MeshFromPly(bytes, path.string())));
}

vtkSmartPointer<vtkPolyData> ReadObj(const std::filesystem::path& path)
{
  const std::string text = ReadWholeFile(path, MaximumBytes);
  return TurnedToLps(SpaceOfComments(path, ObjComments(text)), SurfaceFromObj(text, path.string()));
}

vtkSmartPointer<vtkPolyData> ReadLegacyVtk(const std::filesystem::path& path)
{
  const std::string bytes = ReadWholeFile(path, MaximumBytes);
  return TurnedToLps(SpaceOfComments(path, TitleOfLegacyVtk(bytes)),
                     SurfaceFromLegacyVtk(bytes, path.string()));
}

vtkSmartPointer<vtkPolyData> ReadGifti(const std::filesystem::path& path)
{
  const std::string text = ReadWholeFile(path, MaximumBytes);
  return TurnedToLps(SurfaceSpace::Ras, PolyDataOf(MeshFromGifti(text, path.string())));
}

vtkSmartPointer<vtkPolyData> ReadGltf(const std::filesystem::path& path)
{
  return PolyDataOf(MeshFromGltf(ReadWholeFile(path, MaximumBytes), path.string()));
}

// STL, glTF, X3D and GIfTI hold single precision, in which a small surface far from the origin
// loses its shape.
void RequireSinglePrecision(const TriangleMesh& mesh, const std::filesystem::path& path)
{
  constexpr double CoarsestStep = 1e-3; // of the surface's size
  Eigen::AlignedBox3d box;
  for (const Vector3& point : mesh.PointsWorld)
  {
    box.extend(point);
  }
  const double farthest = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
  const bool isKept =
      farthest <= std::numeric_limits<float>::max() &&
      farthest * std::numeric_limits<float>::epsilon() <= CoarsestStep * box.sizes().norm();
  if (!mesh.SinglePrecision && !isKept)
  {
    Refuse(path,
           "holds single precision, in which a surface so far from the origin loses its shape",
           "use .vtp or .ply");
  }
}

using MeshWriter = std::string (*)(const TriangleMesh&);

template <MeshWriter Write>
std::string WriteMesh(const TriangleMesh& mesh, vtkPolyData*, const std::filesystem::path&)
{
  return Write(mesh);
}

template <MeshWriter Write>
std::string WriteSingle(const TriangleMesh& mesh, vtkPolyData*, const std::filesystem::path& path)
{
  RequireSinglePrecision(mesh, path);
  return Write(mesh);
}
std::string WriteGifti(const TriangleMesh& mesh, vtkPolyData*, const std::filesystem::path& path)
{
  if (EndingOf(path, {".shape.gii"}).empty())
  {
    RequireSinglePrecision(mesh, path);
    return MeshToGifti(mesh);
  }
  if (mesh.Values.empty())
  {
    Refuse(path, "cannot be written: the surface has no values at its points",
           "write the surface itself (.surf.gii)");
  }
  return ValuesToGifti(mesh);
}
} // namespace

FormatList<SurfaceFormat>& SurfaceFormats()
{
  static FormatList<SurfaceFormat> formats(
      {{{"VTK", {".vtp"}, {".vtp"}}, &ReadVtpInLps, &SurfaceToVtp},
       {{"STL", {".stl"}, {".stl"}}, &ReadStl, &WriteSingle<&MeshToStl>},
       {{"PLY", {".ply"}, {".ply"}}, &ReadPly, &WriteMesh<&MeshToPly>},
       {{"OBJ", {".obj"}, {".obj"}}, &ReadObj, &WriteMesh<&MeshToObj>},
       {{"legacy VTK", {".vtk"}, {}}, &ReadLegacyVtk, nullptr},
       {{"GIfTI", {".gii", ".surf.gii"}, {".surf.gii", ".shape.gii"}}, &ReadGifti, &WriteGifti},
       {{"glTF", {".gltf"}, {".gltf"}}, &ReadGltf, &WriteSingle<&MeshToGltf>},
       {{"binary glTF", {".glb"}, {".glb"}}, &ReadGltf, &WriteSingle<&MeshToGlb>},
       {{"X3D", {}, {".x3d"}}, nullptr, &WriteSingle<&MeshToX3d>}});
  return formats;
}

bool IsSurfaceFile(const std::filesystem::path& path)
{
  return SurfaceFormats().Reader(path) != nullptr || SurfaceFormats().Writer(path) != nullptr;
}

void WriteSurface(const std::filesystem::path& path, vtkPolyData* surface)
{
  const SurfaceFormat* const format = SurfaceFormats().Writer(path);
  if (format == nullptr)
  {
    Refuse(path, "does not have the ending of a surface file",
           "use " + ListOfEndings(SurfaceFormats().WrittenEndings()));
  }
  const TriangleMesh mesh = TrianglesOf(surface, path);
  WriteWholeFile(path, format->Write(mesh, surface, path));
}

void WriteLines(const std::filesystem::path& path, vtkPolyData* lines)
{
  WriteWholeFile(path, PolyDataToVtp(lines, path));
}

vtkSmartPointer<vtkPolyData> ReadSurface(const std::filesystem::path& path)
{
  // Gives better messages about the path itself than the readers do.
  InputFileSize(path);
  const SurfaceFormat* const format = SurfaceFormats().Reader(path);
  if (format == nullptr)
  {
    RefuseContent(path, "does not have the ending of a readable surface format",
                  "use " + ListOfEndings(SurfaceFormats().ReadEndings()));
  }
  vtkSmartPointer<vtkPolyData> surface = format->Read(path);
  TrianglesOf(surface, path);
  return surface;
}
} // namespace palpate
