#include "SceneBuilder.h"

#include "CaseText.h"
#include "FilterRun.h"
#include "FitHints.h"
#include "FitStructure.h"
#include "InputError.h"
#include "ModelSurface.h"
#include "Refusal.h"
#include "SceneLabels.h"
#include "SceneReading.h"
#include "Servo.h"
#include "StageClock.h"
#include "VoxelMinimum.h"

#include <algorithm>
#include <map>
#include <set>
#include <system_error>
#include <utility>

namespace palpate
{
namespace
{
constexpr const char* NeitherReason = "the scene wants it neither displayed nor touched";
constexpr const char* UnseenReason = "the scene does not want it displayed";
constexpr const char* UntouchedReason = "the scene does not want it touched";
constexpr const char* NobodyLooks = "nothing is displayed here";

std::size_t BytesOf(vtkPolyData& surface)
{
  constexpr std::size_t Kibi = 1024;
  return Kibi * surface.GetActualMemorySize();
}

// In words, what a file was read as.
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

class Builder
{
public:
  Builder(const SceneSettings& settings, bool isSeen, const ProgressFunction& progress)
      : Asked(settings), IsSeen(isSeen), Progress(progress)
  {
  }

  BuiltScene Build()
  {
    this->Made.Settings = ResolveLabels(this->Asked, this->IsSeen,
                                        [this](const std::filesystem::path& file)
                                        { return this->SegmentationOf(file); });
    this->Planned = this->Seen();
    this->RunPlan();
    this->Made.Contacts = ContactsOf(this->Planned, [this](SceneStep step, int id)
                                     { return this->ProductAt(step, id); });
    const TouchScene touch = MakeTouchScene(this->Made.Settings, this->Made.Contacts, {});
    std::size_t contact = 0;
    for (std::size_t s = 0; s < this->Made.Settings.Structures.size(); ++s)
    {
      const SceneStructure& structure = this->Made.Settings.Structures[s];
      this->Collect(structure, structure.IsTouchable ? &touch.Structures[contact] : nullptr,
                    structure.IsTouchable ? &this->Made.Contacts[contact] : nullptr);
      contact += structure.IsTouchable ? 1 : 0;
    }
    this->AccountForFiles();
    return std::move(this->Made);
  }

private:
  // Where nobody looks nothing is made to be displayed.
  SceneSettings Seen() const
  {
    SceneSettings scene = this->Made.Settings;
    for (SceneStructure& structure : scene.Structures)
    {
      structure.IsVisible = structure.IsVisible && this->IsSeen;
    }
    return scene;
  }

  std::shared_ptr<const Segmentation> SegmentationOf(const std::filesystem::path& file)
  {
    const SceneNode node = SegmentationNode(file, this->Asked.LeftHanded, {});
    if (this->Products.count(node.Key) == 0)
    {
      this->Run(node, 0.0, 0.0, file.filename().string());
    }
    return ProductAs<Segmentation>(&this->Products.at(node.Key));
  }

  const SceneProduct* Find(const std::string& key) const
  {
    const auto found = this->Products.find(key);
    return found != this->Products.end() ? &found->second : nullptr;
  }

  const SceneProduct* ProductAt(SceneStep step, int id) const
  {
    const auto found =
        std::find_if(this->Plan.begin(), this->Plan.end(),
                     [&](const SceneNode& node) { return node.Step == step && node.Id == id; });
    return found != this->Plan.end() ? this->Find(found->Key) : nullptr;
  }

  // Until nothing is left to be made: what fails may bring something else into the plan.
  void RunPlan()
  {
    for (bool ran = true; ran;)
    {
      ran = false;
      this->Plan.clear();
      PlanScene(
          this->Planned, {}, [this](const std::string& key) { return this->Find(key); }, false,
          this->Plan);
      for (std::size_t n = 0; n < this->Plan.size(); ++n)
      {
        if (this->IsReady(this->Plan[n]))
        {
          this->RunNode(n);
          ran = true;
        }
      }
    }
    for (const SceneNode& node : this->Plan)
    {
      this->RequireMade(node);
    }
  }

  bool IsReady(const SceneNode& node) const
  {
    const auto isMade = [this](const std::string& input)
    {
      const SceneProduct* product = this->Find(input);
      return product != nullptr && FailureOf(*product).empty();
    };
    return !node.Key.empty() && this->Find(node.Key) == nullptr &&
           std::all_of(node.Inputs.begin(), node.Inputs.end(), isMade);
  }

  void RunNode(std::size_t number)
  {
    const SceneNode& node = this->Plan[number];
    const SceneStructure* structure = FindStructure(this->Made.Settings, node.Id);
    const auto count = static_cast<double>(this->Plan.size());
    std::string title = node.Reads.filename().string();
    if (structure != nullptr && node.Reads.empty())
    {
      const auto& all = this->Made.Settings.Structures;
      title = structure->File.filename().string() + ", ";
      title += all.size() > 1 ? "structure " + std::to_string(structure - all.data() + 1) + " of " +
                                    std::to_string(all.size()) + ": "
                              : std::string();
      title += TitleOf(*structure);
    }
    this->Run(node, static_cast<double>(number) / count, 1.0 / count, title);
    this->Release(number);
  }

  void Run(const SceneNode& node, double done, double part, const std::string& title)
  {
    std::vector<SceneProduct> inputs;
    for (const std::string& input : node.Inputs)
    {
      inputs.push_back(*this->Find(input));
    }
    std::vector<std::pair<std::string, double>> stages;
    StageClock clock(stages);
    SceneProduct product =
        node.Make(inputs, [&](double fraction, const std::string& stage)
                  { return this->Progress(done + part * fraction, title + ": " + stage); });
    clock.EndStage({});
    const double seconds = stages.front().second;
    if (!node.Reads.empty())
    {
      std::error_code isNoFile;
      const std::uintmax_t bytes = std::filesystem::file_size(node.Reads, isNoFile);
      this->Made.Account.Files.push_back(
          {node.Reads, {KindOf(node.Step), isNoFile ? 0 : bytes, seconds, {}}});
    }
    this->Seconds[node.Id] += node.Reads.empty() ? seconds : 0.0;
    this->Products[node.Key] = std::move(product);
  }

  // A file's content, once nothing that is left to be made needs it.
  void Release(std::size_t number)
  {
    const bool isDecided = std::none_of(this->Plan.begin(), this->Plan.end(),
                                        [](const SceneNode& node) { return node.Key.empty(); });
    for (const std::string& input : this->Plan[number].Inputs)
    {
      const SceneProduct& product = *this->Find(input);
      const bool isLarge = ProductAs<Segmentation>(&product) || ProductAs<Volume>(&product);
      const bool isWanted =
          std::any_of(this->Plan.begin(), this->Plan.end(),
                      [&](const SceneNode& node)
                      {
                        return this->Find(node.Key) == nullptr &&
                               std::count(node.Inputs.begin(), node.Inputs.end(), input) > 0;
                      });
      if (isDecided && isLarge && !isWanted)
      {
        this->Products[input] = SceneFailure(); // none, and nothing left of it
      }
    }
  }

  // Fitting is refused for shapes that other representations can take.
  void RequireMade(const SceneNode& node) const
  {
    const SceneProduct* product = this->Find(node.Key);
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
    const SceneStructure* structure = FindStructure(this->Made.Settings, node.Id);
    const bool isFit = structure->Representation == TouchRepresentation::Harmonics;
    throw InputError(WithHint(
        CaseSentence(structure->File, found->Structure, found->Message),
        isRefused && isFit
            ? "fit it with palpate fit and touch the model, or leave the representation out"
        : isFit && !isBad ? "leave the representation out"
                          : ChooseAnother));
  }

  void Collect(const SceneStructure& structure, const TouchStructure* touch,
               const SceneContact* contact)
  {
    SceneStructureAccount account{TitleOf(structure), structure.File, {}, {}};
    const bool isNeither = !structure.IsVisible && !structure.IsTouchable;
    const bool isDisplayed = structure.IsVisible && this->IsSeen;
    BuiltStructure built;
    built.Touch.Name = TitleOf(structure);
    account.Contact.WhyNot = isNeither ? NeitherReason : UntouchedReason;
    account.Drawing.WhyNot = isNeither             ? NeitherReason
                             : structure.IsVisible ? NobodyLooks
                                                   : UnseenReason;
    double seconds = this->Seconds[structure.Id];
    if (contact != nullptr)
    {
      built.Touch = *touch;
      built.Drilled = contact->Drilled;
      built.Represented = contact->Contact->Represented;
      built.Seconds = seconds;
      const std::size_t texture = contact->Texture != nullptr ? contact->Texture->Bytes : 0;
      account.Contact = {built.Represented, touch->Model->Bytes() + texture, seconds, {}};
      seconds = 0.0;
    }
    if (isDisplayed)
    {
      std::vector<std::pair<std::string, double>> stages;
      StageClock clock(stages);
      built.Looks = contact != nullptr ? contact->Contact->Looks : this->LooksOf(structure.Id);
      account.Drawing = this->Draw(built.Looks);
      clock.EndStage({});
      account.Drawing.Seconds = seconds + stages.front().second;
    }
    this->Made.Account.Structures.push_back(std::move(account));
    if (contact != nullptr || isDisplayed)
    {
      (contact != nullptr ? this->Made.Touched : this->Made.OnlyDisplayed)
          .push_back(std::move(built));
    }
    if (const auto protection =
            ProductAs<SceneProtection>(this->ProductAt(SceneStep::Protection, structure.Id)))
    {
      this->Made.Protections.push_back({TitleOf(structure), structure.AlarmDistance, protection});
    }
  }

  // What is displayed without being touched.
  TouchAppearance LooksOf(int id) const
  {
    TouchAppearance looks;
    if (const auto fit = ProductAs<FitResult>(this->ProductAt(SceneStep::Model, id)))
    {
      looks.Model = std::make_shared<const SphericalHarmonicModel>(fit->Model);
    }
    else if (const auto field = ProductAs<ScalarField>(this->ProductAt(SceneStep::Field, id)))
    {
      looks.Field = field;
    }
    else if (const auto surface = ProductAs<FitSurface>(this->ProductAt(SceneStep::Surface, id)))
    {
      looks.Surface = surface->Found.Surface;
    }
    return looks;
  }

  // A model becomes the surface that is drawn of it.
  static SceneItem Draw(TouchAppearance& looks)
  {
    if (looks.Field != nullptr)
    {
      return {"rays through the field that is felt", 0, 0.0, {}};
    }
    if (looks.Model != nullptr)
    {
      constexpr int Frequency = 20;
      looks.Surface = DrawModel(*looks.Model, Frequency);
      looks.Model = nullptr;
    }
    return {std::to_string(looks.Surface->GetNumberOfCells()) + " triangles",
            BytesOf(*looks.Surface),
            0.0,
            {}};
  }

  // Files that are named and were not read, each once.
  void AccountForFiles()
  {
    std::vector<SceneFileAccount>& files = this->Made.Account.Files;
    std::set<std::filesystem::path> known;
    for (const SceneFileAccount& read : files)
    {
      known.insert(read.File);
    }
    for (const SceneStructure& structure : this->Asked.Structures)
    {
      for (const std::filesystem::path& file : {structure.File, structure.TextureImage})
      {
        if (!file.empty() && known.insert(file).second)
        {
          files.push_back({file, {{}, 0, 0.0, "nothing that is made needs it"}});
        }
      }
    }
  }

  const SceneSettings& Asked;
  bool IsSeen;
  const ProgressFunction& Progress;
  SceneSettings Planned; // with nothing displayed where nobody looks
  std::vector<SceneNode> Plan;
  std::map<std::string, SceneProduct> Products;
  std::map<int, double> Seconds; // by structure
  BuiltScene Made;
};
} // namespace

BuiltScene BuildScene(const SceneSettings& settings, bool isSeen, const ProgressFunction& progress)
{
  return Builder(settings, isSeen, progress).Build();
}

SceneItem AccountForServo(const BuiltScene& built)
{
  if (built.Contacts.empty())
  {
    return {{}, 0, 0.0, "nothing of the scene is touched"};
  }
  auto scene = std::make_shared<TouchScene>(MakeTouchScene(built.Settings, built.Contacts, {}));
  std::vector<std::pair<std::string, double>> stages;
  StageClock clock(stages);
  std::unique_ptr<ServoScene> servo;
  RequireInput(ServoScene::Make(std::move(scene), ServoSettings().VelocityTimeConstant, servo));
  clock.EndStage({});
  return {"trackers and an index", servo->Bytes(), stages.front().second, {}};
}
} // namespace palpate
