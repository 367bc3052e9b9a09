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

// Of a file that is moved.
std::string MovedKey(std::string key, const SceneMove& move, const SceneStamps& stamps)
{
  return move.IsSet() ? SceneKey(key, "moved", move.File, StampIn(stamps, move.File), move.Fixed,
                                 StampIn(stamps, move.Fixed))
                      : key;
}

// What was read from a file, where it belongs.
template <typename T>
T Placed(T read, const SceneMove& move, const std::filesystem::path& file)
{
  return move.IsSet() ? T(Moved(ReadMove(move, file), std::move(read))) : read;
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
                     LeftHandedAxes leftHanded, const SceneStamps& stamps, const SceneMove& move)
{
  const VolumeChoice choice{series, leftHanded};
  const std::string key =
      SceneKey("volume", file, StampIn(stamps, file), series, static_cast<int>(leftHanded));
  return ReadingNode(
      SceneStep::Volume, file, MovedKey(key, move, stamps),
      [file, choice, move]
      { return std::make_shared<const Volume>(Placed(ReadVolume(file, choice), move, file)); });
}

SceneNode SegmentationNode(const std::filesystem::path& file, LeftHandedAxes leftHanded,
                           const SceneStamps& stamps, const SceneMove& move)
{
  const std::string key =
      SceneKey("segmentation", file, StampIn(stamps, file), static_cast<int>(leftHanded));
  return ReadingNode(SceneStep::Segmentation, file, MovedKey(key, move, stamps),
                     [file, leftHanded, move]
                     {
                       return std::make_shared<const Segmentation>(
                           Placed(ReadSegmentation(file, leftHanded), move, file));
                     });
}

SceneNode ModelNode(const std::filesystem::path& file, const SceneStamps& stamps,
                    const SceneMove& move)
{
  return ReadingNode(SceneStep::Model, file,
                     MovedKey(SceneKey("model", file, StampIn(stamps, file)), move, stamps),
                     [file, move]
                     {
                       FitResult result;
                       result.Input = file;
                       result.CaseName = CaseNameOf(file);
                       result.State = FitResult::Outcome::Fitted;
                       ModelDocument document = ReadModel(file);
                       if (move.IsSet() && document.Elasticity != nullptr)
                       {
                         Refuse(file, "yields, so it cannot be moved by a transform",
                                "soften it again after palpate convert --transform");
                       }
                       result.Model = Placed(std::move(document.Surface), move, file);
                       result.Elasticity = std::move(document.Elasticity);
                       result.Tissue = TissueOf(document.Provenance);
                       constexpr int Frequency = 20;
                       result.ModelSurface = DrawModel(result.Model, Frequency);
                       return std::make_shared<const FitResult>(std::move(result));
                     });
}

SceneNode SurfaceNode(const std::filesystem::path& file, const SceneStamps& stamps,
                      const SceneMove& move)
{
  return ReadingNode(SceneStep::Surface, file,
                     MovedKey(SceneKey("surface", file, StampIn(stamps, file)), move, stamps),
                     [file, move]
                     {
                       FitSurface surface;
                       surface.Found.Input = file;
                       surface.Found.CaseName = CaseNameOf(file);
                       surface.Found.Surface = Placed(ReadSurface(file), move, file);
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
