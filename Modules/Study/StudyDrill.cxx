#include "StudyDrill.h"

#include "DrillExport.h"
#include "DrillState.h"
#include "DrilledField.h"
#include "ImageFormat.h"
#include "ImageWriter.h"
#include "InputError.h"
#include "SurfaceFile.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace palpate
{
namespace
{
// Structures that are not, or not yet, protected on all drilled fields.
std::vector<StudyForbidden> UnreadyOf(const std::vector<StudyForbidden>& forbidden,
                                      const std::vector<DrillSource>& drilled)
{
  const auto isReady = [&drilled](const StudyForbidden& one)
  {
    const auto isKeptOut = [&one](const DrillSource& source)
    {
      const FieldGrid& grid = source.Field->Grid();
      const auto like = RemovedDistances::None(grid, DrilledField::BandOf(grid));
      return one.Protection->On(*like) != nullptr;
    };
    return one.IsReady() && std::all_of(drilled.begin(), drilled.end(), isKeptOut);
  };
  std::vector<StudyForbidden> unready;
  std::copy_if(forbidden.begin(), forbidden.end(), std::back_inserter(unready),
               [&](const StudyForbidden& one) { return !isReady(one); });
  return unready;
}
} // namespace

bool StudyDrill::AreDrilled(const std::vector<SceneContact>& drilled) const
{
  return std::equal(drilled.begin(), drilled.end(), this->Drilled.begin(), this->Drilled.end(),
                    [](const SceneContact& a, const SceneContact& b)
                    { return a.Id == b.Id && a.Drilled.Field == b.Drilled.Field; });
}

bool StudyDrill::AreForbidden(const std::vector<StudyForbidden>& forbidden) const
{
  return std::equal(
      forbidden.begin(), forbidden.end(), this->Forbidden.begin(), this->Forbidden.end(),
      [](const StudyForbidden& a, const StudyForbidden& b) {
        return a.Id == b.Id && a.Protection == b.Protection && a.AlarmDistance == b.AlarmDistance;
      });
}

bool StudyDrill::Protects(const std::vector<StudyForbidden>& forbidden) const
{
  const auto isProtected = [this](const StudyForbidden& one)
  {
    return one.IsReady() &&
           std::any_of(this->Forbidden.begin(), this->Forbidden.end(),
                       [&one](const StudyForbidden& known)
                       { return known.Id == one.Id && known.Protection == one.Protection; });
  };
  return this->Drilled.empty() || std::all_of(forbidden.begin(), forbidden.end(), isProtected);
}

void StudyDrill::Follow(const StudyState& state, const std::vector<SceneContact>& contacts,
                        const std::vector<StudyForbidden>& forbidden)
{
  std::vector<SceneContact> drilled;
  std::vector<DrillSource> sources;
  this->SiteOfContact.clear();
  for (const SceneContact& contact : contacts)
  {
    const bool isDrilled = contact.Drilled.Field != nullptr;
    this->SiteOfContact.push_back(isDrilled ? static_cast<int>(drilled.size()) : -1);
    if (isDrilled)
    {
      drilled.push_back(contact);
      sources.push_back(contact.Drilled);
    }
  }
  const std::vector<StudyForbidden> unready = UnreadyOf(forbidden, sources);
  this->HoldText = drilled.empty() ? std::string() : DrillHoldText(unready);
  // While one is not ready, the previous protection is kept.
  if (!this->AreDrilled(drilled) || (unready.empty() && !this->AreForbidden(forbidden)))
  {
    this->Renew(state, drilled, forbidden);
  }
  else if (this->Context != nullptr &&
           !(state.Tool == this->Tool && state.Drill.Turns == this->Motion.Turns &&
             state.Drill.VibrationFrequency == this->Motion.VibrationFrequency))
  {
    this->Context->UseTool(state.Tool, state.Drill);
    ++this->Changes;
  }
  this->Tool = state.Tool;
  this->Motion = state.Drill;
}

void StudyDrill::Renew(const StudyState& state, const std::vector<SceneContact>& drilled,
                       const std::vector<StudyForbidden>& forbidden)
{
  std::vector<StudyForbidden> ready;
  std::copy_if(forbidden.begin(), forbidden.end(), std::back_inserter(ready),
               [](const StudyForbidden& one) { return one.IsReady(); });
  // If this throws, the state is unchanged.
  const auto next = DrillContext::Make(state, drilled, {ready.begin(), ready.end()});
  const std::shared_ptr<DrillContext> before = std::exchange(this->Context, next);
  const std::vector<SceneContact> drilledBefore = std::exchange(this->Drilled, drilled);
  this->Forbidden = ready;
  if (before != nullptr && this->Context != nullptr)
  {
    this->KeepWhatIsGone(*before, drilledBefore);
  }
  this->Watch = std::make_unique<DrillWatch>(this->Context);
  this->Known = {};
  this->SeenNumber = ~std::uint64_t{0};
  ++this->Changes;
}

void StudyDrill::KeepWhatIsGone(const DrillContext& before,
                                const std::vector<SceneContact>& drilledBefore)
{
  std::vector<std::shared_ptr<const RemovedDistances>> kept = this->Context->Editor().Removed();
  const auto removed = before.Editor().Removed();
  for (std::size_t n = 0; n < this->Drilled.size(); ++n)
  {
    for (std::size_t last = 0; last < drilledBefore.size(); ++last)
    {
      const bool isSame = this->Drilled[n].Drilled.Field == drilledBefore[last].Drilled.Field;
      kept[n] = isSame ? removed[last] : kept[n];
    }
  }
  static_cast<void>(this->Context->Editor().Restore(kept)); // fields are the same
}

void StudyDrill::PutInto(TouchScene& scene) const
{
  if (this->Context != nullptr)
  {
    this->Context->PutInto(scene, this->SiteOfContact);
  }
  for (TouchStructure& structure : scene.Structures)
  {
    // Without wear the drill cuts nothing, even with the pedal pressed. Already removed material
    // stays removed.
    structure.Drill = this->HoldText.empty() ? structure.Drill : DrillLaw();
  }
}

std::shared_ptr<DrillEditor> StudyDrill::Editor() const
{
  return this->Context != nullptr ? this->Context->SharedEditor() : nullptr;
}

// Updates the surfaces of cuts, whose outlines slices show, at most ten times per second.
void StudyDrill::ReadCuts()
{
  const std::vector<double> volumes = this->Context->Editor().RemovedVolumes();
  for (std::size_t site = 0; site < volumes.size(); ++site)
  {
    StudyDrilled& one = this->Known.Drilled[site];
    one.RemovedVolume = volumes[site];
    one.Cut = RemovedSurface(*this->Context, static_cast<int>(site));
  }
}

StudyDrillReading StudyDrill::Read(double time, const TouchState& newest)
{
  if (this->Context == nullptr)
  {
    return {};
  }
  this->Known.Hold = this->HoldText;
  constexpr double CutPeriod = 0.1; // s
  const DrillReading reading = this->Context->Editor().Newest();
  this->Known.Drilled.resize(reading.Fields.size());
  for (std::size_t site = 0; site < reading.Fields.size(); ++site)
  {
    StudyDrilled& one = this->Known.Drilled[site];
    one.Id = this->Drilled[site].Id;
    one.Name = this->Context->Sites()[site].Name;
    one.Field = reading.Fields[site];
  }
  if (reading.Number != this->SeenNumber &&
      !(time >= this->CutTime && time < this->CutTime + CutPeriod))
  {
    this->SeenNumber = reading.Number;
    this->CutTime = time;
    this->ReadCuts();
  }
  this->Known.CanUndo = reading.CanUndo;
  this->Known.CanRedo = reading.CanRedo;
  this->Known.Problem = reading.Problem;
  this->Watch->Look(time, newest);
  this->Known.Approaches = this->Watch->Approaches();
  return this->Known;
}

void StudyDrill::Save(const std::filesystem::path& path) const
{
  if (this->Context == nullptr)
  {
    throw InputError("there is no drilled state to save; make a structure drillable first");
  }
  WriteDrillState(path, *this->Context);
}

void StudyDrill::Open(const std::filesystem::path& path)
{
  if (this->Context == nullptr)
  {
    throw InputError(
        "no structure is drillable yet; make one drillable, touch it, then open the drilled state");
  }
  ReadDrillState(path, *this->Context);
  this->SeenNumber = ~std::uint64_t{0};
  ++this->Changes;
}

int StudyDrill::SiteOf(int id) const
{
  const auto found = std::find_if(this->Drilled.begin(), this->Drilled.end(),
                                  [id](const SceneContact& part) { return part.Id == id; });
  if (found == this->Drilled.end())
  {
    throw InputError("this structure is not drilled; choose one that is");
  }
  return static_cast<int>(found - this->Drilled.begin());
}

void StudyDrill::Export(int id, const std::filesystem::path& path,
                        const ProgressFunction& progress) const
{
  const int site = this->SiteOf(id);
  if (IsWritableImage(path))
  {
    WriteImage(path, DrilledImage(*this->Context, site, progress));
  }
  else if (IsSurfaceFile(path))
  {
    WriteSurface(path, DrilledSurface(*this->Context, site, progress));
  }
  else
  {
    throw InputError(path.string() +
                     " has an ending of neither a volume nor a surface format; use " +
                     ListOfEndings(ImageFormats().WrittenEndings()) + ", or " +
                     ListOfEndings(SurfaceFormats().WrittenEndings()));
  }
}
} // namespace palpate
