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
  if (!this->AreDrilled(drilled) || this->IsAwaited ||
      (unready.empty() && !this->AreForbidden(forbidden)))
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
  const std::vector<State> savedBefore = std::exchange(this->Saved, {drilled.size(), nullptr});
  this->Forbidden = ready;
  this->Unfit.clear();
  this->IsAwaited = false;
  std::vector<State> removed(drilled.size());
  if (before != nullptr)
  {
    this->KeepRemoved(*before, drilledBefore, savedBefore, removed);
  }
  if (this->Context != nullptr)
  {
    this->RestoreAside(removed);
  }
  this->Watch = std::make_unique<DrillWatch>(this->Context);
  this->Known = {};
  this->SeenNumber = ~std::uint64_t{0};
  this->Finish();
  ++this->Changes;
}

// What was removed from fields that are still drilled stays removed; the rest is set aside.
void StudyDrill::KeepRemoved(const DrillContext& before,
                             const std::vector<SceneContact>& drilledBefore,
                             const std::vector<State>& savedBefore, std::vector<State>& removed)
{
  const std::vector<State> last = before.Editor().Removed();
  for (std::size_t n = 0; n < drilledBefore.size(); ++n)
  {
    const auto same =
        std::find_if(this->Drilled.begin(), this->Drilled.end(),
                     [&one = drilledBefore[n]](const SceneContact& contact) {
                       return contact.Id == one.Id && contact.Drilled.Field == one.Drilled.Field;
                     });
    const bool isEmpty = last[n]->Corners().empty();
    if (same != this->Drilled.end() && !(isEmpty && savedBefore[n] == nullptr))
    {
      const auto site = static_cast<std::size_t>(same - this->Drilled.begin());
      removed[site] = last[n];
      this->Saved[site] = savedBefore[n];
    }
    else if (!isEmpty)
    {
      this->Aside.push_back({RecordOf(before, n, *last[n]), last[n] == savedBefore[n]});
    }
  }
}

// `removed` has the regions of fields that were drilled before, and null for the others.
void StudyDrill::RestoreAside(std::vector<State>& removed)
{
  const std::vector<State> nothing = this->Context->Editor().Removed();
  for (std::size_t site = 0; site < removed.size(); ++site)
  {
    const std::string& name = this->Context->Sites()[site].Name;
    const std::string source = SourceDigest(*this->Context, site);
    const auto one =
        std::find_if(this->Aside.begin(), this->Aside.end(),
                     [&source](const SetAside& other) { return other.Record.Source == source; });
    if (removed[site] == nullptr && one != this->Aside.end())
    {
      removed[site] = RemovedOf(one->Record, *this->Context, site);
      this->Saved[site] = one->IsSaved ? removed[site] : nullptr;
      this->Unfit = removed[site] == nullptr
                        ? "What was drilled in " + name + " is damaged, and left out."
                        : this->Unfit;
      this->Aside.erase(one);
    }
    else if (std::any_of(this->Aside.begin(), this->Aside.end(),
                         [&name](const SetAside& other) { return other.Record.Name == name; }))
    {
      this->Unfit = "What was drilled in " + name +
                    " is left out, since its voxels or its iso-value are others; it is removed "
                    "again once they are as they were.";
    }
    removed[site] = removed[site] == nullptr ? nothing[site] : removed[site];
  }
  static_cast<void>(this->Context->Editor().BeginWith(removed)); // regions fit their fields
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

void StudyDrill::ReadFields()
{
  const DrillReading reading = this->Context->Editor().Newest();
  this->Known.Hold = this->HoldText;
  this->Known.Drilled.resize(reading.Fields.size());
  for (std::size_t site = 0; site < reading.Fields.size(); ++site)
  {
    StudyDrilled& one = this->Known.Drilled[site];
    one.Id = this->Drilled[site].Id;
    one.Name = this->Context->Sites()[site].Name;
    one.Field = reading.Fields[site];
  }
  this->Known.CanUndo = reading.CanUndo;
  this->Known.CanRedo = reading.CanRedo;
  this->Known.Problem = reading.Problem;
}

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
  constexpr double CutPeriod = 0.1; // s
  const std::uint64_t number = this->Context->Editor().Newest().Number;
  this->ReadFields();
  // The surfaces of cuts, whose outlines slices show, are updated at most ten times per second.
  if (number != this->SeenNumber && !(time >= this->CutTime && time < this->CutTime + CutPeriod))
  {
    this->SeenNumber = number;
    this->CutTime = time;
    this->ReadCuts();
  }
  this->Watch->Look(time, newest);
  this->Known.Approaches = this->Watch->Approaches();
  return this->Known;
}

void StudyDrill::Finish()
{
  if (this->Context != nullptr)
  {
    this->ReadFields();
    this->ReadCuts();
  }
}

void StudyDrill::Clear()
{
  this->Context.reset();
  this->Watch.reset();
  this->Drilled.clear();
  this->Forbidden.clear();
  this->HoldText.clear();
  this->SiteOfContact.clear();
  this->Saved.clear();
  this->Aside.clear();
  this->IsAwaited = false;
  this->Unfit.clear();
  this->Known = {};
  this->SeenNumber = ~std::uint64_t{0};
  ++this->Changes;
}

void StudyDrill::Await(const std::vector<DrillRecord>& records)
{
  for (const DrillRecord& record : records)
  {
    this->Aside.push_back({record, true});
  }
  this->IsAwaited = true;
}

StudyDrillSnapshot StudyDrill::Take() const
{
  const StudyDrillCopy copy = this->Copy();
  return {copy.Records(), copy.Removed};
}

StudyDrillCopy StudyDrill::Copy() const
{
  StudyDrillCopy copy;
  if (this->Context != nullptr)
  {
    copy.Removed = this->Context->Editor().Removed();
  }
  for (State& removed : copy.Removed)
  {
    removed = removed->Corners().empty() ? nullptr : removed;
  }
  std::vector<DrillRecord> aside;
  for (const SetAside& one : this->Aside)
  {
    aside.push_back(one.Record);
  }
  copy.SetAside = aside.size();
  copy.Records = [context = this->Context, removed = copy.Removed, aside = std::move(aside)]
  {
    std::vector<DrillRecord> records;
    for (std::size_t site = 0; site < removed.size(); ++site)
    {
      if (removed[site] != nullptr)
      {
        records.push_back(RecordOf(*context, site, *removed[site]));
      }
    }
    records.insert(records.end(), aside.begin(), aside.end());
    return records;
  };
  return copy;
}

void StudyDrill::MarkSaved(const StudyDrillSnapshot& snapshot)
{
  this->Saved = snapshot.Removed;
  for (SetAside& one : this->Aside)
  {
    one.IsSaved = true;
  }
}

bool StudyDrill::IsChanged() const
{
  return std::any_of(this->Aside.begin(), this->Aside.end(),
                     [](const SetAside& one) { return !one.IsSaved; }) ||
         (this->Context != nullptr && !this->Context->Editor().Holds(this->Saved));
}

void StudyDrill::Open(const std::vector<DrillRecord>& records, const std::filesystem::path& path)
{
  if (this->Context == nullptr)
  {
    throw InputError("no structure can be drilled yet; make one touchable and give it a drill "
                     "role, then open the drilled state");
  }
  RestoreDrillState(records, path, *this->Context);
  this->SeenNumber = ~std::uint64_t{0};
  this->Finish();
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

std::function<void(const ProgressFunction&)>
StudyDrill::Exporting(int id, const std::filesystem::path& path) const
{
  const int site = this->SiteOf(id);
  const bool isImage = IsWritableImage(path);
  if (!isImage && !IsSurfaceFile(path))
  {
    throw InputError(path.string() +
                     " has an ending of neither a volume nor a surface format; use " +
                     ListOfEndings(ImageFormats().WrittenEndings()) + ", or " +
                     ListOfEndings(SurfaceFormats().WrittenEndings()));
  }
  return [context = this->Context, site, path, isImage](const ProgressFunction& progress)
  {
    isImage ? WriteImage(path, DrilledImage(*context, site, progress))
            : WriteSurface(path, DrilledSurface(*context, site, progress));
  };
}
} // namespace palpate
