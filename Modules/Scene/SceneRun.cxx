#include "SceneRun.h"

#include "CaseText.h"
#include "FitHints.h"
#include "InputError.h"
#include "SceneReading.h"
#include "StageClock.h"
#include "VoxelMinimum.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace palpate
{
namespace
{
// Kind of content that a file was read as.
const char* KindOf(SceneStep step)
{
  switch (step)
  {
  case SceneStep::Segmentation:
    return "a segmentation";
  case SceneStep::Model:
    return "a model";
  case SceneStep::Surface:
    return "a surface";
  case SceneStep::Tool:
    return "a tool";
  default:
    return "an image";
  }
}

// "head.nrrd, structure 2 of 5: liver", or the name of the file that is read.
std::string TitleOf(const SceneSettings& scene, const SceneNode& node)
{
  const SceneStructure* structure = FindStructure(scene, node.Id);
  if (structure == nullptr || !node.Reads.empty())
  {
    return node.Reads.filename().string();
  }
  const auto& all = scene.Structures;
  std::string title = structure->File.filename().string() + ", ";
  if (all.size() > 1)
  {
    title += "structure " + std::to_string(structure - all.data() + 1) + " of " +
             std::to_string(all.size()) + ": ";
  }
  return title + TitleOf(*structure);
}
} // namespace

std::shared_ptr<const Segmentation> SceneRun::SegmentationOf(const std::filesystem::path& file,
                                                             LeftHandedAxes leftHanded,
                                                             const ProgressFunction& progress)
{
  const SceneNode node = SegmentationNode(file, leftHanded, {});
  if (this->Find(node.Key) == nullptr)
  {
    this->Run(node, [&](double /*fraction*/, const std::string& stage)
              { return progress(0.0, file.filename().string() + ": " + stage); });
  }
  return ProductAs<Segmentation>(this->Find(node.Key));
}

void SceneRun::Make(const SceneSettings& scene, const ProgressFunction& progress)
{
  // Until no node is left: a failure may add others to the plan.
  for (bool ran = true; ran;)
  {
    ran = false;
    this->Plan.clear();
    PlanScene(
        scene, {}, [this](const std::string& key) { return this->Find(key); }, false, this->Plan);
    for (std::size_t n = 0; n < this->Plan.size(); ++n)
    {
      if (this->IsReady(this->Plan[n]))
      {
        this->RunNode(scene, n, progress);
        ran = true;
      }
    }
  }
  for (const SceneNode& node : this->Plan)
  {
    RequireMade(scene, node, this->Find(node.Key));
  }
}

const SceneProduct* SceneRun::ProductAt(SceneStep step, int id) const
{
  const auto found =
      std::find_if(this->Plan.begin(), this->Plan.end(),
                   [&](const SceneNode& node) { return node.Step == step && node.Id == id; });
  return found != this->Plan.end() ? this->Find(found->Key) : nullptr;
}

double SceneRun::SecondsOf(int id) const
{
  double sum = 0.0;
  for (const SceneNode& node : this->Plan)
  {
    const auto found = this->Seconds.find(node.Key);
    const bool isCounted = node.Id == id && node.Reads.empty() && found != this->Seconds.end();
    sum += isCounted ? found->second : 0.0;
  }
  return sum;
}

const SceneProduct* SceneRun::Find(const std::string& key) const
{
  const auto found = this->Products.find(key);
  return found != this->Products.end() ? &found->second : nullptr;
}

bool SceneRun::IsReady(const SceneNode& node) const
{
  const auto isMade = [this](const std::string& input)
  {
    const SceneProduct* product = this->Find(input);
    return product != nullptr && FailureOf(*product).empty();
  };
  return !node.Key.empty() && this->Find(node.Key) == nullptr &&
         std::all_of(node.Inputs.begin(), node.Inputs.end(), isMade);
}

void SceneRun::RunNode(const SceneSettings& scene, std::size_t number,
                       const ProgressFunction& progress)
{
  const auto count = static_cast<double>(this->Plan.size());
  const std::string title = TitleOf(scene, this->Plan[number]);
  this->Run(
      this->Plan[number], [&](double fraction, const std::string& stage)
      { return progress((static_cast<double>(number) + fraction) / count, title + ": " + stage); });
}

void SceneRun::Run(const SceneNode& node, const ProgressFunction& progress)
{
  std::vector<SceneProduct> inputs;
  for (const std::string& input : node.Inputs)
  {
    inputs.push_back(*this->Find(input));
  }
  std::vector<std::pair<std::string, double>> stages;
  StageClock clock(stages);
  SceneProduct product = node.Make(inputs, progress);
  clock.EndStage({});
  const double seconds = stages.front().second;
  if (!node.Reads.empty())
  {
    std::error_code isNoFile;
    const std::uintmax_t bytes = std::filesystem::file_size(node.Reads, isNoFile);
    this->Read.push_back({node.Reads, {KindOf(node.Step), isNoFile ? 0 : bytes, seconds, {}}});
  }
  this->Seconds[node.Key] = seconds;
  this->Products[node.Key] = std::move(product);
}

// A fit may refuse shapes that other representations accept.
void SceneRun::RequireMade(const SceneSettings& scene, const SceneNode& node,
                           const SceneProduct* product)
{
  if (product == nullptr || !node.Advice.empty() || FailureOf(*product).empty())
  {
    return;
  }
  const auto fit = ProductAs<FitResult>(product);
  const auto surface = ProductAs<FitSurface>(product);
  const auto samples = ProductAs<FitSamples>(product);
  const FitResult* found = fit       ? fit.get()
                           : surface ? &surface->Found
                           : samples ? &samples->Found
                                     : nullptr;
  if (found == nullptr)
  {
    throw InputError(FailureOf(*product));
  }
  const bool isRefused = found->State == FitResult::Outcome::Refused;
  const bool isBad = found->State == FitResult::Outcome::BadInput;
  const SceneStructure* structure = FindStructure(scene, node.Id);
  const bool isFit = structure->Representation == TouchRepresentation::Harmonics;
  throw InputError(WithHint(
      CaseMessage(structure->File, found->Structure, found->Message),
      isRefused && isFit ? "fit it with palpate fit and touch the model, or omit the representation"
      : isFit && !isBad  ? "omit the representation"
                         : ChooseAnother));
}
} // namespace palpate
