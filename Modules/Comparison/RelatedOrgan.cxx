#include "RelatedOrgan.h"

#include "DistanceSamples.h"
#include "ImageIndexToWorld.h"
#include "InputError.h"
#include "LabelMask.h"
#include "LocalThickness.h"
#include "MeshDistances.h"
#include "Units.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
std::string NameOfOrgan(const ComparedFile& file, const Segment& structure)
{
  const std::filesystem::path& path = file.Path();
  const bool isNumbered = file.Labels() != nullptr && file.Labels()->Segments.size() > 1;
  if (!structure.Name.empty() && structure.Label != 0)
  {
    return structure.Name;
  }
  // A model that `fit` wrote is named after its folder.
  const std::string name = NameOfCompared(path) == "model" && path.has_parent_path()
                               ? std::filesystem::absolute(path).parent_path().filename().string()
                               : NameOfCompared(path);
  return isNumbered ? name + " " + std::to_string(structure.Label) : name;
}

// Of a mask's shape; its steps where it is too thin for that.
ComparedBody BodyOfMask(const VoxelMask& mask, const IndexToWorld& toWorld, MaskMesh mesh,
                        RelatedOrgan& organ)
{
  ComparedBody body;
  Status status = mesh == MaskMesh::Ibsi ? ComparedBody::OfMask(mask, toWorld, body)
                                         : ComparedBody::OfMaskShape(mask, toWorld, body);
  if (!status.IsOk() && mesh == MaskMesh::SubVoxel)
  {
    organ.Notes.push_back(status.Message() + ": measured with the steps of its voxels");
    status = ComparedBody::OfMask(mask, toWorld, body);
  }
  if (!status.IsOk())
  {
    throw InputError(status.Message());
  }
  return body;
}

RelatedOrgan::Thickness Summary(const IndexedMesh& mesh, const std::vector<double>& thickness)
{
  const std::vector<double> areas = PointAreas(mesh);
  std::vector<WeightedValue> values;
  double sum = 0.0;
  double whole = 0.0;
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    values.push_back({thickness[i], areas[i]});
    sum += areas[i] * thickness[i];
    whole += areas[i];
  }
  return {sum / whole, WeightedQuantile(values, 0.95 * whole),
          WeightedQuantile(values, 0.5 * whole), WeightedQuantile(values, 0.05 * whole)};
}

ComparedBody BodyOf(const ComparedFile& file, const Segment& structure, MaskMesh mesh,
                    RelatedOrgan& organ)
{
  const Segmentation* labels = file.Labels();
  if (labels == nullptr)
  {
    return file.Body(structure);
  }
  vtkImageData* layer = labels->Layers[static_cast<std::size_t>(structure.Layer)];
  LabelMask label = CopyLabelMask(layer, structure.Value, 1);
  if (label.TouchesBorder)
  {
    organ.IsCut = true;
    organ.Notes.emplace_back("is cut by the border of the image: its volume is a part of the "
                             "organ's");
  }
  return BodyOfMask(label.Mask, IndexToWorldOf(layer), mesh, organ);
}

void Describe(RelatedOrgan& organ)
{
  const ComparedBody& body = organ.Body->Body();
  if (const Status status = organ.Body->Features(organ.Features); !status.IsOk())
  {
    throw InputError(status.Message());
  }
  if (body.Mask() != nullptr)
  {
    organ.Milliliters = body.Volume() / CubicMillimetersPerMilliliter;
  }
  const ThicknessSettings thickness = body.Mask() != nullptr
                                          ? ThicknessSettings::OfVoxels(body.Mask()->ToWorld.Axes)
                                          : ThicknessSettings();
  organ.ThicknessMap = LocalThicknessOf(organ.Body->Samples(), thickness);
  organ.Thick = Summary(organ.Body->Samples(), organ.ThicknessMap);
}

// The triangles beyond the centres of an image's border voxels.
double CutAreaOf(const IndexedMesh& mesh, const IndexToWorld& toWorld, const int size[3])
{
  const Matrix3 toIndex = toWorld.Axes.inverse();
  double area = 0.0;
  for (const std::array<int, 3>& corners : mesh.Triangles)
  {
    Vector3 least = Vector3::Constant(std::numeric_limits<double>::infinity());
    Vector3 largest = -least;
    for (const int corner : corners)
    {
      const Vector3 index = toIndex * (mesh.Points[corner] - toWorld.Origin);
      least = least.cwiseMin(index);
      largest = largest.cwiseMax(index);
    }
    const Vector3 last = Vector3(size[0], size[1], size[2]) - Vector3::Ones();
    if (largest.minCoeff() < 0.0 || (least - last).maxCoeff() > 0.0)
    {
      const Vector3& a = mesh.Points[corners[0]];
      area += 0.5 * (mesh.Points[corners[1]] - a).cross(mesh.Points[corners[2]] - a).norm();
    }
  }
  return area;
}

// `make` throws InputError.
template <typename MakeBody>
void Measure(const MakeBody& make, SpreadOf spread, RelatedOrgan& organ)
{
  try
  {
    RelatedBody body;
    if (const Status status = RelatedBody::Make(make(), spread, body); !status.IsOk())
    {
      throw InputError(status.Message());
    }
    organ.Body = std::make_shared<const RelatedBody>(std::move(body));
    Describe(organ);
  }
  catch (const InputError& error)
  {
    organ.Message = error.what();
    organ.Body = nullptr;
  }
}
} // namespace

RelatedOrgan MeasureOrgan(const ComparedFile& file, const Segment& structure, MaskMesh mesh)
{
  RelatedOrgan organ;
  organ.File = file.Path();
  organ.Structure = structure;
  organ.Kind = file.Kind();
  organ.Name = NameOfOrgan(file, structure);
  Measure([&] { return BodyOf(file, structure, mesh, organ); },
          mesh == MaskMesh::Ibsi ? SpreadOf::VoxelCenters : SpreadOf::Inside, organ);
  if (organ.IsMeasured() && organ.IsCut)
  {
    vtkImageData* layer = file.Labels()->Layers[static_cast<std::size_t>(structure.Layer)];
    organ.CutArea = CutAreaOf(organ.Body->Samples(), IndexToWorldOf(layer), layer->GetDimensions());
  }
  return organ;
}

RelatedOrgan MeasureOrgan(const NamedSurface& surface)
{
  RelatedOrgan organ;
  organ.Name = surface.Name;
  organ.Kind = "surface";
  organ.Structure.Color = surface.Color;
  Measure(
      [&]
      {
        ComparedBody body;
        if (const Status status = ComparedBody::OfMesh(surface.Mesh, body); !status.IsOk())
        {
          throw InputError(status.Message());
        }
        return body;
      },
      SpreadOf::Inside, organ);
  return organ;
}
} // namespace palpate
