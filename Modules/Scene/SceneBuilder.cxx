#include "SceneBuilder.h"

#include "InputError.h"
#include "ModelSurface.h"
#include "Refusal.h"
#include "SceneCuts.h"
#include "SceneLabels.h"
#include "SceneRun.h"
#include "Servo.h"
#include "SofteningNotes.h"
#include "StageClock.h"

#include <algorithm>
#include <set>
#include <utility>

namespace palpate
{
namespace
{
constexpr const char* UntouchedReason = "not touched in the scene";

class Builder
{
public:
  Builder(SceneSettings settings, const ProgressFunction& progress, BadMasks badMasks)
      : Asked(std::move(settings)), Progress(progress), Bad(badMasks)
  {
  }

  BuiltScene Build()
  {
    if (this->Bad == BadMasks::LeaveOut)
    {
      this->LeaveOutBadMasks();
    }
    this->Made.Settings = ResolveLabels(this->Asked, false,
                                        [this](const std::filesystem::path& file)
                                        { return this->SegmentationOf(file); });
    this->RequireGuides();
    this->Planned = this->Undisplayed();
    this->Run.Make(this->Planned, this->Progress);
    this->Made.Account.Files = this->Run.Files();
    const auto products = [this](SceneStep step, int id) { return this->Run.ProductAt(step, id); };
    this->Made.Contacts = ContactsOf(this->Planned, products);
    this->Made.Distances = GuideDistancesOf(this->Planned, products);
    for (SofteningNote& note : SofteningNotes(this->Planned, products))
    {
      this->Made.Warnings.push_back(std::move(note.Text));
    }
    this->WarnOfCuts();
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
  std::shared_ptr<const Segmentation> SegmentationOf(const std::filesystem::path& file)
  {
    return this->Run.SegmentationOf(file, this->Asked.LeftHanded, this->Progress);
  }

  // What is read here is not read again.
  void LeaveOutBadMasks()
  {
    std::vector<SceneStructure> good;
    for (const SceneStructure& structure : this->Asked.Structures)
    {
      try
      {
        if (structure.Source() == SceneSource::Label)
        {
          SegmentsOf(structure, *this->SegmentationOf(structure.File));
        }
        good.push_back(structure);
      }
      catch (const InputError& error)
      {
        this->Made.LeftOut.emplace_back(error.what());
      }
    }
    if (good.empty())
    {
      throw InputError(this->Made.LeftOut.front());
    }
    this->Asked.Structures = std::move(good);
  }

  void RequireGuides() const
  {
    for (const GuideSettings& guide : this->Made.Settings.Guides)
    {
      if (guide.HasStructure() && FindStructure(this->Made.Settings, guide.Structure) == nullptr)
      {
        throw InputError("the scene has no structure with the id " +
                         std::to_string(guide.Structure) +
                         ", by which a guide is made; correct \"structure\" in \"guides\"");
      }
    }
  }

  bool IsCut(const SceneStructure& structure)
  {
    const auto file = this->SegmentationOf(structure.File); // read before
    return !CutsOf(*file, SegmentOf(structure, *file)).empty();
  }
  // Its contact has its cuts.
  bool PassesCuts(const SceneStructure& structure) const
  {
    return std::any_of(this->Made.Contacts.begin(), this->Made.Contacts.end(),
                       [&](const SceneContact& one)
                       { return one.Id == structure.Id && !one.Contact->Cuts.empty(); });
  }

  void WarnOfCuts()
  {
    for (const SceneStructure& structure : this->Planned.Structures)
    {
      if (!structure.IsTouchable || structure.Source() != SceneSource::Label)
      {
        continue;
      }
      const bool isFelt = structure.KeepsCuts || structure.IsDrilled();
      if (isFelt ? this->IsCut(structure) : this->PassesCuts(structure))
      {
        this->Made.Warnings.push_back(
            TitleOf(structure) + " is cut by the border of its image; the cut is " +
            (isFelt ? "felt as if the organ ended there" : "not felt: the tool passes there"));
      }
    }
  }

  SceneSettings Undisplayed() const
  {
    SceneSettings scene = this->Made.Settings;
    for (SceneStructure& structure : scene.Structures)
    {
      structure.IsVisible = false;
    }
    return scene;
  }

  void Collect(const SceneStructure& structure, const TouchStructure* touch,
               const SceneContact* contact)
  {
    SceneStructureAccount account{TitleOf(structure), structure.File, {}};
    account.Contact.WhyNot = UntouchedReason;
    if (contact != nullptr)
    {
      BuiltStructure built;
      built.Touch = *touch;
      built.Represented = contact->Contact->Represented;
      built.Yields = contact->Contact->Yields;
      built.Seconds = this->Run.SecondsOf(structure.Id);
      const std::size_t effects = contact->Effects != nullptr ? contact->Effects->Bytes() : 0;
      account.Contact = {built.Represented, touch->Model->Bytes() + effects, built.Seconds, {}};
      this->Made.Touched.push_back(std::move(built));
    }
    this->Made.Account.Structures.push_back(std::move(account));
    if (const auto protection =
            ProductAs<SceneProtection>(this->Run.ProductAt(SceneStep::Protection, structure.Id)))
    {
      this->Made.Protections.push_back({TitleOf(structure), structure.AlarmDistance, protection});
    }
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
      std::vector<std::filesystem::path> named{structure.File, structure.WithinFile};
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

  SceneSettings Asked;
  const ProgressFunction& Progress;
  BadMasks Bad;
  SceneSettings Planned; // with nothing displayed
  SceneRun Run;
  BuiltScene Made;
};
} // namespace

BuiltScene BuildScene(const SceneSettings& settings, const ProgressFunction& progress,
                      BadMasks badMasks)
{
  return Builder(settings, progress, badMasks).Build();
}

SceneItem AccountForServo(const BuiltScene& built)
{
  if (built.Contacts.empty())
  {
    return {{}, 0, 0.0, "no structure of the scene is touched"};
  }
  auto scene = std::make_shared<TouchScene>(
      MakeTouchScene(built.Settings, built.Contacts, {}, built.Distances));
  std::vector<std::pair<std::string, double>> stages;
  StageClock clock(stages);
  std::unique_ptr<ServoScene> servo;
  RequireInput(ServoScene::Make(std::move(scene), ServoSettings().VelocityTimeConstant, servo));
  clock.EndStage({});
  return {"trackers and an index", servo->Bytes(), stages.front().second, {}};
}
} // namespace palpate
