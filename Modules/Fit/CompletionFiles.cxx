#include "CompletionFiles.h"

#include "DecimalText.h"
#include "ImageIndexToWorld.h"
#include "ImageWriter.h"
#include "InputError.h"
#include "JsonNumbers.h"
#include "JsonSchema.h"
#include "MeshConversion.h"
#include "MeshVoxels.h"
#include "ModelFile.h"
#include "ModelMeasures.h"
#include "ModelSurface.h"
#include "NormalDisplacement.h"
#include "OutputFolder.h"
#include "Refusal.h"
#include "SurfaceFile.h"
#include "Units.h"
#include "WholeFile.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

namespace palpate
{
namespace
{
using CompletionObject = nlohmann::ordered_json;

constexpr int MaskFrequency = 60; // chords within 0.01 mm of an organ

vtkSmartPointer<vtkImageData> MaskOn(vtkImageData* grid, const OrganModel& model)
{
  const IndexToWorld toWorld = IndexToWorldOf(grid);
  VoxelCenters centers{toWorld.Origin, toWorld.Axes, {}};
  std::copy_n(grid->GetDimensions(), 3, centers.Size.begin());
  std::vector<std::uint8_t> inside;
  RequireInput(FindInside(ToIndexedMesh(DrawModel(model, MaskFrequency)), centers, true, inside),
               "the mask");
  if (std::find(inside.begin(), inside.end(), 1) == inside.end())
  {
    throw InputError("no voxel of the image of --grid lies in the organ; give the image on which "
                     "it was touched");
  }
  vtkNew<vtkUnsignedCharArray> values;
  values->SetNumberOfTuples(static_cast<vtkIdType>(inside.size()));
  std::copy(inside.begin(), inside.end(), values->GetPointer(0));
  auto mask = vtkSmartPointer<vtkImageData>::New();
  mask->CopyStructure(grid);
  mask->GetPointData()->SetScalars(values);
  return mask;
}

ModelDocument DocumentOf(const CompletedOrgan& organ, const CompletionInputs& inputs,
                         const std::string& program)
{
  ModelDocument document;
  document.Surface = organ.Found.Model;
  document.Provenance.Program = program;
  document.Provenance.Input = inputs.Points.filename().string();
  document.Provenance.Settings = {{"completed from touches", std::to_string(organ.Touches)},
                                  {"sigma_mm", ExactText(inputs.Sigma)},
                                  {"prior cases", std::to_string(organ.Found.PriorCases)}};
  return document;
}
} // namespace

CompletedOrgan CompletedOrgan::Of(OrganCompletion completion, std::size_t touches)
{
  CompletedOrgan organ;
  organ.Found = std::move(completion);
  organ.Touches = touches;
  const auto* radial = std::get_if<RadialModel>(&organ.Found.Model);
  organ.Milliliters =
      (radial != nullptr ? VolumeOf(*radial) : std::get<SurfaceModel>(organ.Found.Model).Volume()) /
      CubicMillimetersPerMilliliter;
  organ.LargestDeviation = organ.Found.Deviations.maxCoeff();
  const std::vector<double> areas = FindNormalDisplacement(organ.Found.Model, Frequency).Areas;
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t n = 0; n < areas.size(); ++n)
  {
    const double deviation = organ.Found.Deviations[static_cast<Eigen::Index>(n)];
    sum += areas[n] * deviation * deviation;
    area += areas[n];
  }
  organ.MeanDeviation = std::sqrt(sum / area);
  return organ;
}

std::string CompletionJson(const CompletedOrgan& organ, const CompletionInputs& inputs,
                           const std::string& folder)
{
  const auto pathOrNull = [](const std::string& path)
  { return path.empty() ? CompletionObject() : CompletionObject(path); };
  CompletionObject next = CompletionObject::array();
  for (const Vector3& place : organ.Found.Next)
  {
    next.push_back(PointJson(place));
  }
  const bool isRadial = std::holds_alternative<RadialModel>(organ.Found.Model);
  const CompletionObject json{{JsonSchemaKey, JsonSchemaVersion},
                              {"points", pathOrNull(inputs.Points.string())},
                              {"touches", organ.Touches},
                              {"prior", pathOrNull(inputs.Prior.string())},
                              {"known", pathOrNull(inputs.Known.string())},
                              {"model", isRadial ? "radial" : "surface"},
                              {"prior_cases", organ.Found.PriorCases},
                              {"sigma_mm", inputs.Sigma},
                              {"distance_rms_mm", organ.Found.Distance},
                              {"distance_limit_mm", organ.Found.LargestDistance},
                              {"center_mm", PointJson(CenterOf(organ.Found.Model))},
                              {"volume_ml", organ.Milliliters},
                              {"deviation_rms_mm", organ.MeanDeviation},
                              {"deviation_max_mm", organ.LargestDeviation},
                              {"next_mm", next},
                              {"folder", pathOrNull(folder)}};
  return json.dump(-1, ' ', false, CompletionObject::error_handler_t::replace);
}

void WriteCompletionFiles(const CompletedOrgan& organ, const CompletionInputs& inputs,
                          const std::filesystem::path& folder, const std::string& program)
{
  const vtkSmartPointer<vtkPolyData> surface =
      DrawModel(organ.Found.Model, CompletedOrgan::Frequency);
  vtkNew<vtkFloatArray> deviations;
  deviations->SetName("StandardDeviation");
  deviations->SetNumberOfValues(static_cast<vtkIdType>(organ.Found.Deviations.size()));
  std::copy(organ.Found.Deviations.begin(), organ.Found.Deviations.end(),
            deviations->GetPointer(0));
  surface->GetPointData()->AddArray(deviations);
  WriteOutputSet(folder,
                 [&](const std::filesystem::path& stage)
                 {
                   WriteModel(stage / "model.json", DocumentOf(organ, inputs, program));
                   WriteSurface(stage / "model.vtp", surface);
                   WriteWholeFile(stage / "completion.json",
                                  CompletionJson(organ, inputs, {}) + "\n");
                   if (inputs.Grid != nullptr)
                   {
                     WriteImage(stage / "mask.nii.gz", MaskOn(inputs.Grid, organ.Found.Model));
                   }
                 },
                 {"mask.nii.gz"});
}
} // namespace palpate
