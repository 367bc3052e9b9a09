#include "StudyDrill.h"

#include "DrillExport.h"
#include "DrillState.h"
#include "FilterRun.h"
#include "ImageWriter.h"
#include "InputError.h"
#include "SurfaceFile.h"

#include <algorithm>

namespace palpate
{
namespace
{
bool GoOn(double, const std::string&)
{
  return true;
}
} // namespace

std::vector<StudyForbidden> ForbiddenOf(const StudyState& state, const StudyPipeline& pipeline)
{
  std::vector<StudyForbidden> forbidden;
  for (const StudyStructure& structure : state.Structures)
  {
    const auto surface = pipeline.Newest<FitSurface>(StudyStep::Surface, structure.Label);
    if (structure.IsForbidden && surface != nullptr && surface->Found.Surface != nullptr)
    {
      forbidden.push_back(
          {structure.Label, TitleOf(structure), surface->Found.Surface, structure.AlarmDistance});
    }
  }
  return forbidden;
}

bool StudyDrill::IsSameAs(const std::vector<Part>& drilled,
                          const std::vector<StudyForbidden>& forbidden) const
{
  const auto isSamePart = [](const Part& a, const Part& b)
  { return a.Label == b.Label && a.Source.Field == b.Source.Field; };
  const auto isSameForbidden = [](const StudyForbidden& a, const StudyForbidden& b)
  { return a.Label == b.Label && a.Surface == b.Surface && a.AlarmDistance == b.AlarmDistance; };
  return std::equal(drilled.begin(), drilled.end(), this->Drilled.begin(), this->Drilled.end(),
                    isSamePart) &&
         std::equal(forbidden.begin(), forbidden.end(), this->Forbidden.begin(),
                    this->Forbidden.end(), isSameForbidden);
}

void StudyDrill::Follow(const StudyState& state, const std::vector<StudyContact>& contacts,
                        const std::vector<StudyForbidden>& forbidden)
{
  std::vector<Part> drilled;
  this->SiteOfContact.clear();
  for (const StudyContact& contact : contacts)
  {
    const bool isDrilled = contact.Drilled.Field != nullptr;
    this->SiteOfContact.push_back(isDrilled ? static_cast<int>(drilled.size()) : -1);
    if (isDrilled)
    {
      drilled.push_back({contact.Label, contact.Drilled});
    }
  }
  if (!this->IsSameAs(drilled, forbidden))
  {
    this->Renew(state, drilled, forbidden);
  }
  else if (this->Bench != nullptr &&
           !(state.Tool == this->Tool && state.Drill.Turns == this->Motion.Turns &&
             state.Drill.VibrationFrequency == this->Motion.VibrationFrequency))
  {
    this->Bench->UseTool(state.Tool, state.Drill);
    ++this->Changes;
  }
  this->Tool = state.Tool;
  this->Motion = state.Drill;
}

void StudyDrill::Renew(const StudyState& state, const std::vector<Part>& drilled,
                       const std::vector<StudyForbidden>& forbidden)
{
  const bool isRunning = this->Keeper != nullptr;
  this->Stop();
  TouchStructures made;
  for (const Part& part : drilled)
  {
    TouchableStructure structure;
    structure.Touch.Name = TitleOf(*FindStructure(state, part.Label));
    structure.Drilled = part.Source;
    made.Touched.push_back(std::move(structure));
  }
  for (const StudyForbidden& one : forbidden)
  {
    made.Forbidden.emplace_back(one.Name, one.Surface, one.AlarmDistance);
  }
  TouchSettings settings;
  settings.Tool = state.Tool;
  settings.Drill = state.Drill;
  const std::shared_ptr<DrillBench> before = this->Bench;
  const std::vector<Part> drilledBefore = this->Drilled;
  this->Bench = DrillBench::Make(settings, made, GoOn);
  if (before != nullptr && this->Bench != nullptr)
  {
    std::vector<std::shared_ptr<const RemovedDistances>> kept = this->Bench->Editor().Removed();
    const auto removed = before->Editor().Removed();
    for (std::size_t n = 0; n < drilled.size(); ++n)
    {
      for (std::size_t last = 0; last < drilledBefore.size(); ++last)
      {
        const bool isSame = drilled[n].Source.Field == drilledBefore[last].Source.Field;
        kept[n] = isSame ? removed[last] : kept[n];
      }
    }
    static_cast<void>(this->Bench->Editor().Restore(kept)); // of the same fields
  }
  this->Drilled = drilled;
  this->Forbidden = forbidden;
  this->Watch = std::make_unique<DrillWatch>(this->Bench);
  this->Known = {};
  this->SeenNumber = ~std::uint64_t{0};
  ++this->Changes;
  if (isRunning)
  {
    this->Start();
  }
}

void StudyDrill::PutInto(TouchScene& scene) const
{
  if (this->Bench != nullptr)
  {
    this->Bench->PutInto(scene, this->SiteOfContact);
  }
}

void StudyDrill::Start()
{
  if (this->Bench != nullptr)
  {
    this->Bench->Editor().ForNextServo();
    this->SeenNumber = ~std::uint64_t{0}; // numbers begin again
  }
  this->Keeper = std::make_unique<DrillKeeper>(this->Bench);
  this->Keeper->Start();
}

void StudyDrill::Stop()
{
  this->Keeper.reset();
}

// Surfaces of cuts, ten times a second at most: slices show their outlines.
void StudyDrill::ReadCuts()
{
  const std::vector<double> volumes = this->Bench->Editor().RemovedVolumes();
  for (std::size_t site = 0; site < volumes.size(); ++site)
  {
    StudyDrilled& one = this->Known.Drilled[site];
    one.RemovedVolume = volumes[site];
    one.Cut = RemovedSurface(*this->Bench, static_cast<int>(site));
  }
}

StudyDrillReading StudyDrill::Read(double time, const TouchState& newest)
{
  if (this->Bench == nullptr)
  {
    return {};
  }
  constexpr double CutPeriod = 0.1; // s
  const DrillReading reading = this->Bench->Editor().Newest();
  this->Known.Drilled.resize(reading.Fields.size());
  for (std::size_t site = 0; site < reading.Fields.size(); ++site)
  {
    StudyDrilled& one = this->Known.Drilled[site];
    one.Label = this->Drilled[site].Label;
    one.Name = this->Bench->Sites()[site].Name;
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
  if (this->Bench == nullptr)
  {
    throw InputError("nothing is drilled that could be saved; make a structure drillable first");
  }
  WriteDrillState(path, *this->Bench);
}

void StudyDrill::Open(const std::filesystem::path& path)
{
  if (this->Bench == nullptr)
  {
    throw InputError("nothing can be drilled yet; make a structure drillable, touch it, and open "
                     "the drilled state then");
  }
  ReadDrillState(path, *this->Bench);
  this->SeenNumber = ~std::uint64_t{0};
  ++this->Changes;
}

int StudyDrill::SiteOf(int label) const
{
  const auto found = std::find_if(this->Drilled.begin(), this->Drilled.end(),
                                  [label](const Part& part) { return part.Label == label; });
  if (found == this->Drilled.end())
  {
    throw InputError("nothing of this structure is drilled; choose one that is");
  }
  return static_cast<int>(found - this->Drilled.begin());
}

void StudyDrill::Export(int label, const std::filesystem::path& path,
                        const ProgressFunction& progress) const
{
  const int site = this->SiteOf(label);
  if (IsWritableImage(path))
  {
    WriteImage(path, DrilledImage(*this->Bench, site, progress));
  }
  else if (IsSurfaceFile(path))
  {
    WriteSurface(path, DrilledSurface(*this->Bench, site, progress));
  }
  else
  {
    throw InputError(path.string() + " has an ending that neither volumes nor surfaces have; use "
                                     ".nrrd, .nii.gz, .stl or .vtp");
  }
}
} // namespace palpate
