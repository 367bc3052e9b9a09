#include "RelatedOrgan.h"

#include "DistanceSamples.h"
#include "ImageIndexToWorld.h"
#include "InputError.h"
#include "LabelMask.h"
#include "LocalThickness.h"
#include "MeshDistances.h"
#include "ScanBorder.h"
#include "Units.h"

#include <algorithm>
#include <array>
#include <cmath>
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
    if (std::isfinite(thickness[i]))
    {
      values.push_back({thickness[i], areas[i]});
      sum += areas[i] * thickness[i];
      whole += areas[i];
    }
  }
  if (!(whole > 0.0))
  {
    return {};
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
  if (label.TouchesBorder())
  {
    organ.IsCut = true;
    organ.Notes.emplace_back("is cut by the border of the image: its volume is a part of the "
                             "organ's");
  }
  return BodyOfMask(label.Mask, IndexToWorldOf(layer), mesh, organ);
}

void Describe(const OrganMeasures& measures, RelatedOrgan& organ)
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
  ThicknessSettings thickness = body.Mask() != nullptr
                                    ? ThicknessSettings::OfVoxels(body.Mask()->ToWorld.Axes)
                                    : ThicknessSettings();
  thickness.Rule = measures.Thickness;
  organ.ThicknessMap = LocalThicknessOf(organ.Body->Own(), thickness);
  organ.Thick = Summary(organ.Body->Own(), organ.ThicknessMap);
  if (measures.Calibre)
  {
    organ.TubeMessage = MeasureCalibre(organ.Body->Samples(), organ.Tube).Message();
  }
}

std::array<int, 3> ImageSizeOf(const ComparedFile& file, const Segment& structure)
{
  std::array<int, 3> size{};
  file.Labels()->Layers[static_cast<std::size_t>(structure.Layer)]->GetDimensions(size.data());
  return size;
}

// `make` makes its body; throws InputError.
template <typename MakeBody>
void Measure(const MakeBody& make, const OrganMeasures& measures, RelatedOrgan& organ)
{
  try
  {
    const SpreadOf spread =
        measures.Mesh == MaskMesh::Ibsi ? SpreadOf::VoxelCenters : SpreadOf::Inside;
    RelatedBody body;
    if (const Status status = make(spread, body); !status.IsOk())
    {
      throw InputError(status.Message());
    }
    organ.Body = std::make_shared<const RelatedBody>(std::move(body));
    Describe(measures, organ);
  }
  catch (const InputError& error)
  {
    organ.Message = error.what();
    organ.Body = nullptr;
  }
}
} // namespace

RelatedOrgan MeasureOrgan(const ComparedFile& file, const Segment& structure,
                          const OrganMeasures& measures)
{
  RelatedOrgan organ;
  organ.File = file.Path();
  organ.Structure = structure;
  organ.Kind = file.Kind();
  organ.Name = NameOfOrgan(file, structure);
  const auto make = [&](SpreadOf spread, RelatedBody& made)
  {
    ComparedBody body = BodyOf(file, structure, measures.Mesh, organ);
    if (!organ.IsCut)
    {
      return RelatedBody::Make(std::move(body), spread, made);
    }
    const std::array<int, 3> size = ImageSizeOf(file, structure);
    organ.CutArea = CutAreaOf(body.Surface(), *body.Mask(), size);
    return RelatedBody::Make(std::move(body), spread, made, measures.KeepCuts ? nullptr : &size);
  };
  Measure(make, measures, organ);
  return organ;
}

RelatedOrgan MeasureOrgan(const NamedSurface& surface, const OrganMeasures& measures)
{
  RelatedOrgan organ;
  organ.Name = surface.Name;
  organ.Kind = "surface";
  organ.Structure.Color = surface.Color;
  const auto make = [&](SpreadOf spread, RelatedBody& made)
  {
    ComparedBody body;
    Status status = ComparedBody::OfMesh(surface.Mesh, body);
    return status.IsOk() ? RelatedBody::Make(std::move(body), spread, made) : status;
  };
  Measure(make, measures, organ);
  return organ;
}
} // namespace palpate
