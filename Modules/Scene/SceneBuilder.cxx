#include "SceneBuilder.h"

#include "ModelSurface.h"
#include "Refusal.h"
#include "SceneLabels.h"
#include "SceneRun.h"
#include "Servo.h"
#include "StageClock.h"

#include <algorithm>
#include <set>
#include <utility>

namespace palpate
{
namespace
{
constexpr const char* NeitherReason = "neither displayed nor touched in the scene";
constexpr const char* UnseenReason = "not displayed in the scene";
constexpr const char* UntouchedReason = "not touched in the scene";
constexpr const char* NobodyLooks = "nothing is displayed here";

std::size_t BytesOf(vtkPolyData& surface)
{
  constexpr std::size_t Kibi = 1024;
  return Kibi * surface.GetActualMemorySize();
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
    this->Made.Settings = ResolveLabels(
        this->Asked, this->IsSeen,
        [this](const std::filesystem::path& file)
        { return this->Run.SegmentationOf(file, this->Asked.LeftHanded, this->Progress); });
    this->Planned = this->Seen();
    this->Run.Make(this->Planned, this->Progress);
    this->Made.Account.Files = this->Run.Files();
    this->Made.Contacts = ContactsOf(this->Planned, [this](SceneStep step, int id)
                                     { return this->Run.ProductAt(step, id); });
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
  // Nothing is made for display without a viewer.
  SceneSettings Seen() const
  {
    SceneSettings scene = this->Made.Settings;
    for (SceneStructure& structure : scene.Structures)
    {
      structure.IsVisible = structure.IsVisible && this->IsSeen;
    }
    return scene;
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
    double seconds = this->Run.SecondsOf(structure.Id);
    if (contact != nullptr)
    {
      built.Touch = *touch;
      built.Drilled = contact->Drilled;
      built.Represented = contact->Contact->Represented;
      built.Seconds = seconds;
      const std::size_t effects = contact->Effects != nullptr ? contact->Effects->Bytes() : 0;
      account.Contact = {built.Represented, touch->Model->Bytes() + effects, seconds, {}};
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
            ProductAs<SceneProtection>(this->Run.ProductAt(SceneStep::Protection, structure.Id)))
    {
      this->Made.Protections.push_back({TitleOf(structure), structure.AlarmDistance, protection});
    }
  }

  // Display of a structure that is not touched.
  TouchAppearance LooksOf(int id) const
  {
    TouchAppearance looks;
    if (const auto fit = ProductAs<FitResult>(this->Run.ProductAt(SceneStep::Model, id)))
    {
      looks.Model = std::make_shared<const SphericalHarmonicModel>(fit->Model);
    }
    else if (const auto field = ProductAs<ScalarField>(this->Run.ProductAt(SceneStep::Field, id)))
    {
      looks.Field = field;
    }
    else if (const auto surface =
                 ProductAs<FitSurface>(this->Run.ProductAt(SceneStep::Surface, id)))
    {
      looks.Surface = surface->Found.Surface;
    }
    return looks;
  }

  // A model is drawn as a surface.
  static SceneItem Draw(TouchAppearance& looks)
  {
    if (looks.Field != nullptr)
    {
      return {"ray casting of the touched field", 0, 0.0, {}};
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

  // Files that are named but were not read, each once.
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
      std::vector<std::filesystem::path> named{structure.File};
      for (const auto& [key, image] : structure.Images)
      {
        named.push_back(image);
      }
      for (const std::filesystem::path& file : named)
      {
        if (!file.empty() && known.insert(file).second)
        {
          files.push_back({file, {{}, 0, 0.0, "no product needs it"}});
        }
      }
    }
  }

  const SceneSettings& Asked;
  bool IsSeen;
  const ProgressFunction& Progress;
  SceneSettings Planned; // with nothing displayed if there is no viewer
  SceneRun Run{false};
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
    return {{}, 0, 0.0, "no structure of the scene is touched"};
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
