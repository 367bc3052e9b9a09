#include "SceneReading.h"

#include "DecimalText.h"
#include "FitStructure.h"
#include "ModelFile.h"
#include "ModelSurface.h"
#include "Progress.h"
#include "Refusal.h"
#include "SegmentationFile.h"
#include "SofteningSettings.h"
#include "SurfaceFile.h"
#include "VolumeFile.h"

#include <algorithm>
#include <optional>

namespace palpate
{
namespace
{
std::string StampIn(const SceneStamps& stamps, const std::filesystem::path& file)
{
  const auto found = stamps.find(file);
  return found != stamps.end() ? found->second : std::string();
}

// Reading cannot be interrupted; it is not started if cancelled before.
template <typename Read>
SceneNode ReadingNode(SceneStep step, const std::filesystem::path& file, std::string key,
                      const Read& read)
{
  SceneNode node;
  node.Step = step;
  node.Key = std::move(key);
  node.Reads = file;
  node.Make = [read](const std::vector<SceneProduct>&,
                     const ProgressFunction& progress) -> SceneProduct
  {
    ReportProgress(progress, 0.0, "read");
    return read();
  };
  return node;
}

// "20 kPa" of a model that palpate soften made, and whether contrasts are exaggerated; empty if
// nothing is known.
std::string TissueOf(const ModelProvenance& provenance)
{
  std::string tissue;
  for (const auto& [name, text] : provenance.Settings)
  {
    const std::optional<double> number = ParseNumber(text);
    if (number && name == "tissue_kpa")
    {
      tissue += SignificantText(*number) + " kPa";
    }
    if (number && name == "exaggeration")
    {
      tissue += ExaggerationText(*number);
    }
  }
  return tissue;
}
} // namespace

SceneNode VolumeNode(const std::filesystem::path& file, const std::string& series,
                     LeftHandedAxes leftHanded, const SceneStamps& stamps)
{
  const VolumeChoice choice{series, leftHanded};
  return ReadingNode(
      SceneStep::Volume, file,
      SceneKey("volume", file, StampIn(stamps, file), series, static_cast<int>(leftHanded)),
      [file, choice] { return std::make_shared<const Volume>(ReadVolume(file, choice)); });
}

SceneNode SegmentationNode(const std::filesystem::path& file, LeftHandedAxes leftHanded,
                           const SceneStamps& stamps)
{
  return ReadingNode(
      SceneStep::Segmentation, file,
      SceneKey("segmentation", file, StampIn(stamps, file), static_cast<int>(leftHanded)),
      [file, leftHanded]
      { return std::make_shared<const Segmentation>(ReadSegmentation(file, leftHanded)); });
}

SceneNode ModelNode(const std::filesystem::path& file, const SceneStamps& stamps)
{
  return ReadingNode(SceneStep::Model, file, SceneKey("model", file, StampIn(stamps, file)),
                     [file]
                     {
                       FitResult result;
                       result.Input = file;
                       result.CaseName = CaseNameOf(file);
                       result.State = FitResult::Outcome::Fitted;
                       ModelDocument document = ReadModel(file);
                       result.Model = std::move(document.Surface);
                       result.Elasticity = std::move(document.Elasticity);
                       result.Tissue = TissueOf(document.Provenance);
                       constexpr int Frequency = 20;
                       result.ModelSurface = DrawModel(result.Model, Frequency);
                       return std::make_shared<const FitResult>(std::move(result));
                     });
}

SceneNode SurfaceNode(const std::filesystem::path& file, const SceneStamps& stamps)
{
  return ReadingNode(SceneStep::Surface, file, SceneKey("surface", file, StampIn(stamps, file)),
                     [file]
                     {
                       FitSurface surface;
                       surface.Found.Input = file;
                       surface.Found.CaseName = CaseNameOf(file);
                       surface.Found.Surface = ReadSurface(file);
                       return std::make_shared<const FitSurface>(std::move(surface));
                     });
}

SceneNode ToolNode(const SceneSettings& scene, const SceneStamps& stamps)
{
  const bool cuts = std::any_of(scene.Structures.begin(), scene.Structures.end(),
                                [](const SceneStructure& one) { return one.IsDrilled(); });
  const std::filesystem::path& file = scene.Tool.File;
  const int points = ShellPointsOf(scene.Tool);
  return ReadingNode(SceneStep::Tool, file,
                     SceneKey("tool", file, StampIn(stamps, file), points, cuts),
                     [file, points, cuts] { return SurfaceTool::Read(file, points, cuts); });
}
} // namespace palpate
