#include "CorrectionFiles.h"

#include "CorrectionFile.h"
#include "EarlierFiles.h"
#include "InputError.h"
#include "JsonSchema.h"
#include "MeshConversion.h"
#include "ModelFile.h"
#include "OutputFolder.h"
#include "Refusal.h"
#include "SegmentationWriter.h"
#include "SurfaceFile.h"
#include "WholeFile.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

namespace palpate
{
namespace
{
using CorrectionObject = nlohmann::ordered_json;

constexpr const char* CorrectedModelFile = "model.json";
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

void WriteChanges(const Segment& structure, const VoxelMask& start, const VoxelMask& result,
                  NeighborPolicy neighbors, Segmentation& all)
{
  bool overlaps = false;
  const StructureVoxels before(all, structure);
  ForEachChange(start, result,
                [&](const std::array<int, 3>& index, bool isAdded)
                { overlaps = overlaps || (isAdded && before.IsOthers(index)); });
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

} // namespace

CorrectedOrgan CorrectedOrgan::OfMask(const Segmentation& start, const Segment& structure,
                                      const std::vector<CorrectionStep>& steps,
                                      NeighborPolicy neighbors)
{
  const std::shared_ptr<const Segmentation> lent(std::shared_ptr<void>(), &start);
  CorrectedShape shape = CorrectedShape::OfMask(lent, structure, neighbors);
  const VoxelMask before = shape.ResultMask();
  shape.Do(steps);
  CorrectedOrgan organ{shape.Change(), CopyOf(start), {}, steps};
  WriteChanges(structure, before, shape.ResultMask(), neighbors, *organ.Mask);
  return organ;
}

CorrectedOrgan CorrectedOrgan::OfModel(const ModelDocument& start,
                                       const std::vector<CorrectionStep>& steps)
{
  CorrectedShape shape = CorrectedShape::OfModel(start);
  shape.Do(steps);
  CorrectedOrgan organ{shape.Change(), {}, start, steps};
  organ.Model->Elasticity = nullptr; // of another shape
  organ.Model->Surface = shape.ResultModel();
  return organ;
}

MaskCorrection::Barrier OtherVoxels(const Segmentation& segmentation, const Segment& structure)
{
  return [voxels = StructureVoxels(segmentation, structure)](const std::array<int, 3>& index)
  { return voxels.IsOthers(index); };
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

std::string CorrectedFileOf(const CorrectedOrgan& organ, const CorrectionInputs& inputs)
{
  if (organ.Model)
  {
    return CorrectedModelFile;
  }
  const bool isLayered = organ.Mask->Layers.size() > 1 || IsSlicerSegmentation(inputs.File);
  return isLayered ? CorrectedLayersFile : CorrectedMaskFile;
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
  const std::vector<std::string> results{CorrectedModelFile, CorrectedMaskFile,
                                         CorrectedLayersFile};
  for (const std::string& result : results)
  {
    RequireOtherFile(folder / result, inputs.File);
  }
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
          WriteModel(stage / CorrectedModelFile, document);
          return;
        }
        WriteSegmentation(stage / CorrectedFileOf(organ, inputs), *organ.Mask);
      },
      results);
}
} // namespace palpate
