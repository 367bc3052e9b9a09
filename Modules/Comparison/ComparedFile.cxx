#include "ComparedFile.h"

#include "CaseText.h"
#include "FileFormat.h"
#include "FitStructure.h"
#include "ImageIndexToWorld.h"
#include "InputError.h"
#include "LabelMask.h"
#include "ModelFile.h"
#include "Refusal.h"
#include "SegmentationFile.h"
#include "SurfaceFile.h"

#include <utility>

namespace palpate
{
namespace
{
IndexedMesh MeshOf(const std::filesystem::path& path)
{
  TriangleMesh triangles = TrianglesOf(ReadSurface(path), path);
  return {std::move(triangles.PointsWorld), std::move(triangles.Triangles)};
}
} // namespace

std::string NameOfCompared(const std::filesystem::path& file)
{
  const std::string ending = EndingOf(file, ReadableModelEndings());
  const std::string name = file.filename().string();
  return ending.empty() ? CaseNameOf(file) : name.substr(0, name.size() - ending.size());
}

ComparedFile ComparedFile::Read(const std::filesystem::path& path, const VolumeChoice& choice)
{
  ComparedFile file;
  file.Source = path;
  if (IsModelFile(path))
  {
    file.Content = ReadModel(path).Surface;
  }
  else if (SurfaceFormats().Reader(path) != nullptr)
  {
    file.Content = MeshOf(path);
  }
  else
  {
    file.Content = ReadSegmentation(path, choice);
  }
  return file;
}

const char* ComparedFile::Kind() const
{
  constexpr const char* Kinds[] = {"segmentation", "surface", "model"};
  return Kinds[this->Content.index()];
}

std::vector<Segment> ComparedFile::Structures() const
{
  if (const Segmentation* labels = this->Labels())
  {
    return labels->Segments;
  }
  Segment whole;
  whole.Name = NameOfCompared(this->Source);
  return {whole};
}

std::vector<std::string> ComparedFile::Notes() const
{
  const Segmentation* labels = this->Labels();
  return labels != nullptr ? labels->Remarks() : std::vector<std::string>();
}

ComparedBody ComparedFile::Body(const Segment& structure, MaskBody ofMask) const
{
  ComparedBody body;
  Status status = Status::Success();
  if (const Segmentation* labels = this->Labels())
  {
    vtkImageData* layer = labels->Layers[static_cast<std::size_t>(structure.Layer)];
    const auto make = ofMask == MaskBody::Shape ? ComparedBody::OfMaskShape : ComparedBody::OfMask;
    status = make(CopyLabelMask(layer, structure.Value, 1).Mask, IndexToWorldOf(layer), body);
  }
  else if (const auto* mesh = std::get_if<IndexedMesh>(&this->Content))
  {
    status = ComparedBody::OfMesh(*mesh, body);
  }
  else
  {
    status = ComparedBody::OfModel(std::get<OrganModel>(this->Content), body);
  }
  if (!status.IsOk() && this->Labels() != nullptr)
  {
    throw InputError(CaseMessage(this->Source, structure, status.Message()));
  }
  if (!status.IsOk())
  {
    Refuse(this->Source, status.Message(), "compare another one");
  }
  return body;
}
} // namespace palpate
