#include "CorrectionFiles.h"

#include "BodyOverlap.h"
#include "ComparedBody.h"
#include "CorrectedMask.h"
#include "CorrectionFile.h"
#include "ImageIndexToWorld.h"
#include "InputError.h"
#include "JsonSchema.h"
#include "LabelMask.h"
#include "MaskEdits.h"
#include "MeshConversion.h"
#include "MeshDistances.h"
#include "ModelCorrection.h"
#include "ModelFile.h"
#include "OutputFolder.h"
#include "Refusal.h"
#include "SegmentationWriter.h"
#include "SurfaceFile.h"
#include "Units.h"
#include "WholeFile.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace palpate
{
namespace
{
using CorrectionObject = nlohmann::ordered_json;

constexpr int PulledFrequency = 24; // 5,762 points that can be pulled
constexpr const char* CorrectedMaskFile = "mask.nii.gz";
constexpr const char* CorrectedLayersFile = "mask.seg.nrrd";

std::array<int, 3> SizeOf(vtkImageData* image)
{
  std::array<int, 3> size{};
  image->GetDimensions(size.data());
  return size;
}

// The layers of a segmentation that have a structure's grid, and where in them it is.
class StructureVoxels
{
public:
  StructureVoxels(const Segmentation& segmentation, const Segment& structure)
      : Own(structure), Size(SizeOf(segmentation.Layers[LayerOf(structure)]))
  {
    for (const auto& layer : segmentation.Layers)
    {
      this->Values.push_back(SizeOf(layer) == this->Size ? layer->GetPointData()->GetScalars()
                                                         : nullptr);
    }
  }

  static std::size_t LayerOf(const Segment& structure)
  {
    return static_cast<std::size_t>(structure.Layer);
  }
  vtkIdType NumberOf(const std::array<int, 3>& index) const
  {
    return (static_cast<vtkIdType>(index[2]) * this->Size[1] + index[1]) * this->Size[0] + index[0];
  }
  bool IsOthers(const std::array<int, 3>& index) const
  {
    const vtkIdType at = this->NumberOf(index);
    for (std::size_t layer = 0; layer < this->Values.size(); ++layer)
    {
      const double value =
          this->Values[layer] != nullptr ? this->Values[layer]->GetComponent(at, 0) : 0.0;
      if (value != 0.0 && !(layer == LayerOf(this->Own) && value == this->Own.Value))
      {
        return true;
      }
    }
    return false;
  }
  void Clear(const std::array<int, 3>& index)
  {
    this->Values[LayerOf(this->Own)]->SetComponent(this->NumberOf(index), 0, 0.0);
  }
  // Takes the voxel from all others.
  void Take(const std::array<int, 3>& index)
  {
    for (vtkDataArray* values : this->Values)
    {
      if (values != nullptr)
      {
        values->SetComponent(this->NumberOf(index), 0, 0.0);
      }
    }
    this->Set(index);
  }
  void Set(const std::array<int, 3>& index)
  {
    this->Values[LayerOf(this->Own)]->SetComponent(this->NumberOf(index), 0, this->Own.Value);
  }

private:
  Segment Own;
  std::array<int, 3> Size;
  std::vector<vtkDataArray*> Values;
};

Segmentation CopyOf(const Segmentation& segmentation)
{
  Segmentation copy = segmentation;
  for (auto& layer : copy.Layers)
  {
    vtkNew<vtkImageData> own;
    own->DeepCopy(layer);
    layer = own;
  }
  return copy;
}

// Moves a structure to a layer of its own.
Segment MoveToOwnLayer(const Segment& structure, Segmentation& segmentation)
{
  vtkNew<vtkImageData> layer;
  layer->DeepCopy(segmentation.Layers[StructureVoxels::LayerOf(structure)]);
  vtkDataArray* const there =
      segmentation.Layers[StructureVoxels::LayerOf(structure)]->GetPointData()->GetScalars();
  vtkDataArray* const here = layer->GetPointData()->GetScalars();
  for (vtkIdType at = 0; at < here->GetNumberOfTuples(); ++at)
  {
    const bool isOwn = here->GetComponent(at, 0) == structure.Value;
    here->SetComponent(at, 0, isOwn ? structure.Value : 0.0);
    there->SetComponent(at, 0, isOwn ? 0.0 : there->GetComponent(at, 0));
  }
  Segment moved = structure;
  moved.Layer = static_cast<int>(segmentation.Layers.size());
  segmentation.Layers.emplace_back(layer);
  std::replace_if(
      segmentation.Segments.begin(), segmentation.Segments.end(),
      [&](const Segment& one) { return one.Label == structure.Label; }, moved);
  return moved;
}

// Calls `visit` with each voxel of the image that is in one of two masks only, and whether it is in
// the second.
template <typename Visit>
void ForEachChange(const VoxelMask& start, const VoxelMask& result, const Visit& visit)
{
  for (int k = 0; k < result.Size[2]; ++k)
  {
    for (int j = 0; j < result.Size[1]; ++j)
    {
      for (int i = 0; i < result.Size[0]; ++i)
      {
        const std::array<int, 3> index{result.StartIndex[0] + i, result.StartIndex[1] + j,
                                       result.StartIndex[2] + k};
        const bool isInside = result.Inside[result.Offset(i, j, k)] != 0;
        if (isInside != HasVoxel(start, index))
        {
          visit(index, isInside);
        }
      }
    }
  }
}

void WriteChanges(const Segment& structure, const VoxelMask& start, const VoxelMask& result,
                  NeighborPolicy neighbors, CorrectedOrgan& organ)
{
  Segmentation& all = *organ.Mask;
  bool overlaps = false;
  const StructureVoxels before(all, structure);
  ForEachChange(start, result,
                [&](const std::array<int, 3>& index, bool isAdded)
                {
                  (isAdded ? organ.AddedVoxels : organ.RemovedVoxels) += 1;
                  overlaps = overlaps || (isAdded && before.IsOthers(index));
                });
  const bool isShared = neighbors == NeighborPolicy::Overlap;
  StructureVoxels voxels(all, isShared && overlaps ? MoveToOwnLayer(structure, all) : structure);
  ForEachChange(start, result,
                [&](const std::array<int, 3>& index, bool isAdded)
                {
                  if (!isAdded)
                  {
                    voxels.Clear(index);
                  }
                  else if (isShared)
                  {
                    voxels.Set(index);
                  }
                  else
                  {
                    voxels.Take(index);
                  }
                });
}

std::string StepName(std::size_t number)
{
  return "step " + std::to_string(number + 1);
}

// Mean without sign over the area of a surface.
double MeanOver(const IndexedMesh& mesh, const std::vector<double>& distances)
{
  const std::vector<double> areas = PointAreas(mesh);
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t n = 0; n < areas.size(); ++n)
  {
    sum += areas[n] * std::abs(distances[n]);
    area += areas[n];
  }
  return area > 0.0 ? sum / area : 0.0;
}

double LargestOf(const std::vector<double>& distances)
{
  double largest = 0.0;
  for (const double distance : distances)
  {
    largest = std::max(largest, std::abs(distance));
  }
  return largest;
}

void Measure(const ComparedBody& start, const ComparedBody& result, CorrectedOrgan& organ)
{
  organ.Surface = result.Surface();
  RequireInput(start.DistancesOf(organ.Surface.Points, {}, organ.Distances), "the change");
  std::vector<double> back;
  RequireInput(result.DistancesOf(start.Surface().Points, {}, back), "the change");
  organ.MeanDistance = MeanOver(organ.Surface, organ.Distances);
  organ.LargestDistance = std::max(LargestOf(organ.Distances), LargestOf(back));
  BodyOverlap overlap;
  RequireInput(FindBodyOverlap(start, result, overlap), "the change");
  organ.Dice = overlap.Dice();
  organ.StartMilliliters = start.Volume() / CubicMillimetersPerMilliliter;
  organ.Milliliters = result.Volume() / CubicMillimetersPerMilliliter;
}

ComparedBody BodyOfMask(const VoxelMask& mask, const IndexToWorld& toWorld)
{
  ComparedBody body;
  if (!ComparedBody::OfMaskShape(mask, toWorld, body).IsOk())
  {
    RequireInput(ComparedBody::OfMask(mask, toWorld, body), "the mask");
  }
  return body;
}
} // namespace

CorrectedOrgan CorrectedOrgan::OfMask(const Segmentation& start, const Segment& structure,
                                      const std::vector<CorrectionStep>& steps,
                                      NeighborPolicy neighbors)
{
  vtkImageData* const image = start.Layers[StructureVoxels::LayerOf(structure)];
  const IndexToWorld toWorld = IndexToWorldOf(image);
  const VoxelMask mask = CopyLabelMask(image, structure.Value, 1).Mask;
  MaskCorrection::Barrier barrier;
  if (neighbors == NeighborPolicy::Stop)
  {
    barrier = [voxels = StructureVoxels(start, structure)](const std::array<int, 3>& index)
    { return voxels.IsOthers(index); };
  }
  CorrectedMask corrected(mask, toWorld, SizeOf(image), barrier);
  for (std::size_t n = 0; n < steps.size(); ++n)
  {
    RequireInput(corrected.Apply(steps[n]), StepName(n));
  }
  CorrectedOrgan organ;
  organ.Steps = steps;
  organ.Mask = CopyOf(start);
  WriteChanges(structure, mask, corrected.Mask(), neighbors, organ);
  Measure(BodyOfMask(mask, toWorld), BodyOfMask(corrected.Mask(), toWorld), organ);
  return organ;
}

CorrectedOrgan CorrectedOrgan::OfModel(const ModelDocument& start,
                                       const std::vector<CorrectionStep>& steps)
{
  SurfaceCorrection correction = StartOfModel(start.Surface, PulledFrequency);
  for (std::size_t n = 0; n < steps.size(); ++n)
  {
    const auto* pull = std::get_if<SurfacePull>(&steps[n]);
    if (pull == nullptr)
    {
      throw InputError(StepName(n) +
                       " is an edit of voxels; a model can be pulled, or give a mask");
    }
    RequireInput(correction.Pull(*pull), StepName(n));
  }
  CorrectedOrgan organ;
  organ.Steps = steps;
  organ.Model = start;
  organ.Model->Elasticity = nullptr; // of another shape
  RequireInput(ModelCorrection::Apply(start.Surface, correction, organ.Model->Surface),
               "the model");
  ComparedBody before;
  ComparedBody after;
  RequireInput(ComparedBody::OfModel(start.Surface, before), "the model");
  RequireInput(ComparedBody::OfModel(organ.Model->Surface, after), "the corrected model");
  Measure(before, after, organ);
  return organ;
}

std::string CorrectionJson(const CorrectedOrgan& organ, const CorrectionInputs& inputs,
                           const std::string& folder)
{
  const char* const policies[] = {"stop", "overlap", "overwrite"};
  const bool isMask = inputs.Structure.has_value();
  const CorrectionObject none;
  const CorrectionObject json{
      {JsonSchemaKey, JsonSchemaVersion},
      {"input", inputs.File.string()},
      {"label", isMask ? CorrectionObject(inputs.Structure->Label) : none},
      {"name", isMask ? CorrectionObject(inputs.Structure->Name) : none},
      {"neighbours",
       isMask ? CorrectionObject(policies[static_cast<int>(inputs.Neighbors)]) : none},
      {"steps", CorrectionJson(organ.Steps)},
      {"dice", organ.Dice},
      {"volume_start_ml", organ.StartMilliliters},
      {"volume_ml", organ.Milliliters},
      {"distance_mean_mm", organ.MeanDistance},
      {"distance_max_mm", organ.LargestDistance},
      {"voxels_added", isMask ? CorrectionObject(organ.AddedVoxels) : none},
      {"voxels_removed", isMask ? CorrectionObject(organ.RemovedVoxels) : none},
      {"folder", folder.empty() ? none : CorrectionObject(folder)}};
  return json.dump(-1, ' ', false, CorrectionObject::error_handler_t::replace);
}

void WriteCorrectionFiles(const CorrectedOrgan& organ, const CorrectionInputs& inputs,
                          const std::filesystem::path& folder, const std::string& program)
{
  const vtkSmartPointer<vtkPolyData> surface = ToPolyData(organ.Surface);
  vtkNew<vtkFloatArray> distances;
  distances->SetName("SignedDistance");
  distances->SetNumberOfValues(static_cast<vtkIdType>(organ.Distances.size()));
  std::copy(organ.Distances.begin(), organ.Distances.end(), distances->GetPointer(0));
  surface->GetPointData()->AddArray(distances);
  WriteOutputSet(
      folder,
      [&](const std::filesystem::path& stage)
      {
        WriteCorrections(organ.Steps, stage / "corrections.json");
        WriteWholeFile(stage / "correction.json", CorrectionJson(organ, inputs, {}) + "\n");
        WriteSurface(stage / "change.vtp", surface);
        if (organ.Model)
        {
          ModelDocument document = *organ.Model;
          document.Provenance = {};
          document.Provenance.Program = program;
          document.Provenance.Input = inputs.File.filename().string();
          document.Provenance.Settings = {
              {"corrected by pulls", std::to_string(organ.Steps.size())}};
          WriteModel(stage / "model.json", document);
          return;
        }
        const bool isLayered = organ.Mask->Layers.size() > 1 || IsSlicerSegmentation(inputs.File);
        WriteSegmentation(stage / (isLayered ? CorrectedLayersFile : CorrectedMaskFile),
                          *organ.Mask);
      },
      {"model.json", CorrectedMaskFile, CorrectedLayersFile});
}
} // namespace palpate
