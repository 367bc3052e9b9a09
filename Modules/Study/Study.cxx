#include "Study.h"

#include "InputError.h"
#include "OpenBuiltInDevice.h"
#include "SegmentationFile.h"
#include "SteadyClock.h"
#include "StudyFile.h"
#include "StudyRecovery.h"
#include "StudyStructures.h"
#include "TouchRecording.h"
#include "TouchTicksFile.h"

#include <algorithm>
#include <utility>

namespace palpate
{
Study::Study(Clock& clock, const RealtimeRequest& request) : Time(clock), Felt(clock, request) {}

void Study::Begin(const StudyState& state, const std::filesystem::path& file)
{
  this->StopTouch();
  this->CloseReplay();
  this->DrillFiles.Cancel();
  this->Felt.Drill().Clear();
  for (const StudyJobs::Id id : this->Adding)
  {
    this->Work.Cancel(id);
  }
  this->Adding.clear();
  this->Steps.Reset(state);
  this->SessionFile = file;
  this->FormerFile.clear();
  this->Unread.clear();
  if (LacksStructures(state))
  {
    this->Unread.insert(state.SegmentationFile);
  }
  this->Follow();
}

void Study::Open(const std::filesystem::path& file)
{
  std::filesystem::path drilled;
  const StudyState state = ReadStudy(file, &drilled);
  this->Begin(state, StudyPath(file));
  this->ReadDrilled(drilled);
}

void Study::ReadDrilled(const std::filesystem::path& file)
{
  if (!file.empty())
  {
    this->DrillFiles.Read(file, [this](const std::vector<DrillRecord>& records)
                          { this->Felt.Drill().Await(records); });
  }
}

void Study::Recover(const std::filesystem::path& folder)
{
  const RecoveredStudy kept = ReadRecovery(folder);
  this->Begin(kept.State, {});
  this->FormerFile = kept.FormerFile;
  this->Steps.MarkUnsaved();
  this->ReadDrilled(kept.Drilled);
}

void Study::Save(const std::filesystem::path& file)
{
  if (this->DrillFiles.IsReading())
  {
    throw InputError("What was drilled is still being read: save the study again in a moment.");
  }
  const StudyDrillSnapshot drilled = this->Felt.Drill().Take();
  WriteStudy(file, this->State(), SaveDrilled(file, drilled));
  this->SessionFile = StudyPath(file);
  this->FormerFile.clear();
  this->Steps.MarkSaved();
  this->Felt.Drill().MarkSaved(drilled);
  this->DrillFiles.Cancel(); // what could not be read is no longer part of the session
}

// What was only opened can be opened again: until something else has changed, it is not asked for.
void Study::ChangeByFile(const std::string& message, const StudyState& next)
{
  const bool isOnlyOpened = this->SessionFile.empty() && !this->Steps.IsChanged();
  this->Change(message, next);
  if (isOnlyOpened)
  {
    this->Steps.MarkSaved();
  }
}

void Study::OpenVolume(const std::filesystem::path& file, const std::string& series)
{
  StudyState next = this->State();
  next.VolumeFile = StudyPath(file);
  next.DicomSeries = series;
  next.View.CrosshairWorld.reset();
  next.View.Window.reset();
  next.View.Level.reset();
  this->ChangeByFile("Open the volume " + file.filename().string(), next);
}

void Study::AddVolume(const std::filesystem::path& file, const std::string& series)
{
  if (this->State().VolumeFile.empty())
  {
    this->OpenVolume(file, series);
    return;
  }
  StudyState next = this->State();
  StudyVolume added;
  for (const StudyVolume& one : next.Volumes)
  {
    added.Id = std::max(added.Id, one.Id);
  }
  ++added.Id;
  added.File = StudyPath(file);
  added.Series = series;
  added.Colors = VolumeColors::Hot; // tells it from the first one
  next.Volumes.push_back(added);
  this->ChangeByFile("Add the volume " + file.filename().string(), next);
}

void Study::OpenSegmentation(const std::filesystem::path& file)
{
  StudyState next = this->State();
  const std::filesystem::path before = next.SegmentationFile;
  next.SegmentationFile = StudyPath(file);
  next.Structures.erase(std::remove_if(next.Structures.begin(), next.Structures.end(),
                                       [&before](const SceneStructure& one)
                                       { return one.File == before; }),
                        next.Structures.end());
  this->Unread.insert(next.SegmentationFile);
  this->ChangeByFile("Open the segmentation " + file.filename().string(), next);
}

void Study::AddSegmentation(const std::filesystem::path& file,
                            const std::function<void(const std::string& message)>& fail)
{
  const auto id = std::make_shared<StudyJobs::Id>();
  StudyJob job;
  job.IsUrgent = true;
  job.Work = [this, file = StudyPath(file), id,
              leftHanded = this->State().LeftHanded](const ProgressFunction&)
  {
    return StudyJob::Delivery(
        [this, file, id, read = ReadSegmentation(file, leftHanded)]
        {
          this->Adding.erase(*id);
          this->ChangeByFile("Add the structures of " + file.filename().string(),
                             WithAddedStructuresOf(this->State(), file, read));
        });
  };
  job.Fail = [this, id, fail](const std::string& message)
  {
    this->Adding.erase(*id);
    fail(message);
  };
  *id = this->Work.Start(std::move(job));
  this->Adding.insert(*id);
}

void Study::AddStructure(const std::filesystem::path& file)
{
  SceneStructure structure;
  structure.Name = file.stem().string();
  structure.File = StudyPath(file);
  this->ChangeByFile("Add " + file.filename().string(), WithStructure(this->State(), structure));
}

void Study::AddThreshold(const StudyThreshold& threshold)
{
  const SceneStructure structure = ThresholdStructure(this->State(), threshold);
  this->Change("Add " + structure.Name, WithStructure(this->State(), structure));
}

void Study::OpenScene(const std::filesystem::path& file)
{
  this->AddScene(file, ReadWholeScene(file, this->State().LeftHanded));
}

void Study::AddScene(const std::filesystem::path& file, const SceneSettings& scene)
{
  this->ChangeByFile("Open the scene " + file.filename().string(), WithScene(this->State(), scene));
}

void Study::AddMarkups(const std::filesystem::path& file, const StudyMarkups& markups)
{
  StudyState next = this->State();
  next.Landmarks.insert(next.Landmarks.end(), markups.Landmarks.begin(), markups.Landmarks.end());
  next.Measurements.insert(next.Measurements.end(), markups.Measurements.begin(),
                           markups.Measurements.end());
  this->ChangeByFile("Open " + file.filename().string(), next);
}

void Study::RelocateFile(const std::filesystem::path& missing, const std::filesystem::path& moved)
{
  this->Change("Find " + missing.filename().string(), Relocate(this->State(), missing, moved));
}

bool Study::Change(const std::string& message, const StudyState& next, const std::string& gesture)
{
  return this->FollowIf(this->Steps.Change(message, next, gesture));
}

bool Study::FollowIf(bool isChanged)
{
  if (isChanged)
  {
    this->Follow();
  }
  return isChanged;
}

// Updates products and touch to the current state.
void Study::Follow()
{
  this->Made.Update(this->State());
  this->AdoptStructures();
  this->Organ.Follow(this->State().Drawing);
  this->FollowCorrection();
  this->FollowByTouch();
}

void Study::AdoptStructures()
{
  const bool isRead =
      this->Made.StateOf(SceneStep::Segmentation).Is == StudyStepState::Kind::UpToDate;
  if (!isRead || this->Unread.erase(this->State().SegmentationFile) == 0)
  {
    return;
  }
  const auto segmentation = this->Made.Newest<Segmentation>(SceneStep::Segmentation);
  if (LacksStructures(this->State()))
  {
    this->Steps.Amend(WithStructuresOf(this->State(), *segmentation));
    this->Made.Update(this->State());
  }
}

void Study::PrepareTouch()
{
  this->Felt.Forbid(ForbiddenOf(this->State(), this->Made));
  this->Felt.Guide(GuideDistancesOf(this->State(), [this](SceneStep step, int id)
                                    { return this->Made.NewestProduct(step, id); }));
}

void Study::FollowByTouch()
{
  if (this->LacksContacts && !this->Contacts().empty())
  {
    this->StopTouch(); // it did not start; now there is something to touch
  }
  if (this->Felt.IsRunning())
  {
    this->PrepareTouch();
    this->Problem = this->Felt.Update(this->WithTool(), this->Contacts()).Message();
  }
  else if (this->Felt.Drill().IsAwaiting())
  {
    this->FollowByDrill();
  }
}

// What was drilled is shown without a touch too.
void Study::FollowByDrill()
{
  try
  {
    this->Felt.Drill().Follow(this->WithTool(), this->Contacts(),
                              ForbiddenOf(this->State(), this->Made));
  }
  catch (const InputError& error)
  {
    this->Problem = error.what();
  }
}

void Study::OpenDrilled(const std::filesystem::path& file,
                        const std::function<void(const std::string& message)>& fail)
{
  this->DrillFiles.Read(
      file,
      [this, file](const std::vector<DrillRecord>& records)
      {
        const bool wasTouching = this->Felt.IsRunning();
        this->StopTouch();
        this->FollowByDrill();
        this->Felt.Drill().Open(records, file);
        if (wasTouching)
        {
          this->StartTouch();
        }
      },
      fail);
}

std::string Study::DrilledProblem() const
{
  const std::string& unread = this->DrillFiles.Problem();
  return unread.empty() ? this->Felt.Drill().RestoreProblem() : unread;
}

// The state for touch: with the tool's surface as read. While it is being read, or if that fails,
// the previous tool is used.
StudyState Study::WithTool()
{
  StudyState state = this->State();
  if (state.Tool.Kind == TouchToolSettings::Shape::Surface)
  {
    state.Tool.Surface = this->Made.Newest<SurfaceTool>(SceneStep::Tool);
    if (state.Tool.Surface == nullptr)
    {
      state.Tool = this->ReadTool;
    }
  }
  this->ReadTool = state.Tool;
  this->Organ.AddTo(state);
  return state;
}

std::vector<SceneContact> Study::Contacts() const
{
  std::vector<SceneContact> contacts = ContactsOf(this->State(), [this](SceneStep step, int id)
                                                  { return this->Made.NewestProduct(step, id); });
  this->Organ.AddTo(contacts);
  this->Correcting.AddTo(contacts);
  return contacts;
}

void Study::TurnAxes(const Matrix3& rotation)
{
  this->Felt.TurnAxes(rotation);
  this->FollowByTouch();
}

void Study::CancelStep(SceneStep step)
{
  this->Made.Cancel(step);
  this->FollowByTouch();
}

void Study::ResumeStep(SceneStep step)
{
  this->Made.Resume(step);
  this->Made.Retry(step);
  this->FollowByTouch();
}

void Study::StartTouch()
{
  this->StopTouch();
  this->CloseReplay();
  StudyJob job;
  job.IsUrgent = true;
  std::string silent = this->State().Device;
  const bool isHeard = TakeSound(silent) || this->AreHeard; // the device may ask for it itself
  job.Work = [this, name = silent + (isHeard ? "+sound" : ""),
              &clock = this->Time](const ProgressFunction&)
  {
    const auto device = std::make_shared<std::unique_ptr<HapticDevice>>();
    const Status status = OpenBuiltInDevice(name, clock, *device);
    return StudyJob::Delivery(
        [this, device, status]
        {
          this->Opening.reset();
          this->Problem = status.Message();
          if (status.IsOk())
          {
            this->TakeDevice(std::move(*device));
          }
        });
  };
  job.Fail = [this](const std::string& message)
  {
    this->Opening.reset();
    this->Problem = message;
  };
  this->Opening = this->Work.Start(std::move(job));
}

void Study::TakeDevice(std::unique_ptr<HapticDevice> device)
{
  const StudyStepState tool = this->Made.StateOf(SceneStep::Tool);
  const bool isMissing = this->State().Tool.Kind == TouchToolSettings::Shape::Surface &&
                         this->Made.Newest<SurfaceTool>(SceneStep::Tool) == nullptr;
  if (isMissing)
  {
    device->Close();
    this->Problem = tool.Is == StudyStepState::Kind::Failed
                        ? tool.Message
                        : "The tool's file is still being read: start the touch afterwards.";
    return;
  }
  this->PrepareTouch();
  const std::vector<SceneContact> contacts = this->Contacts();
  this->LacksContacts = contacts.empty();
  this->Problem = this->Felt.Start(std::move(device), this->WithTool(), contacts).Message();
}

void Study::MoveWorkspace(const Vector3& centerWorld, const std::string& gesture)
{
  if (this->Felt.IsRunning())
  {
    StudyState next = this->State();
    next.Placement.CenterWorld = this->Felt.PlacementFor(centerWorld);
    this->Change("Move the workspace", next, gesture);
  }
}

void Study::FitWorkspace()
{
  StudyState next = this->State();
  next.Placement.CenterWorld.reset();
  next.Placement.Scale.reset();
  this->Felt.FitWorkspace();
  if (!this->Change("Fit the workspace", next))
  {
    this->FollowByTouch();
  }
}

void Study::StopTouch()
{
  if (this->Opening)
  {
    this->Work.Cancel(*this->Opening);
    this->Opening.reset();
  }
  this->Felt.Stop();
  this->Problem.clear();
  this->LacksContacts = false;
}

// A replay that is open stays until this one has been read.
void Study::OpenReplay(const std::filesystem::path& file)
{
  if (this->Reading)
  {
    this->Work.Cancel(*this->Reading);
  }
  this->Unplayable.clear();
  StudyJob job;
  job.IsUrgent = true;
  job.Work = [this, file](const ProgressFunction&)
  {
    return StudyJob::Delivery(
        [this, file, recording = ReadReplay(file)]
        {
          this->StopTouch();
          this->Reading.reset();
          this->Played = std::make_unique<StudyReplay>(file, recording, this->Time);
          if (recording->WasCutOff)
          {
            this->Unplayable = file.string() + " ended within a tick, which is left out.";
          }
        });
  };
  job.Fail = [this](const std::string& message)
  {
    this->Reading.reset();
    this->Unplayable = message;
  };
  this->Reading = this->Work.Start(std::move(job));
}

void Study::CloseReplay()
{
  if (this->Reading)
  {
    this->Work.Cancel(*this->Reading);
    this->Reading.reset();
  }
  this->Played.reset();
  this->Unplayable.clear();
}

void Study::ExportReplay(const std::filesystem::path& file)
{
  if (this->Played == nullptr)
  {
    return;
  }
  this->Unplayable.clear();
  this->Written.Start(
      file,
      [file, recording = this->Played->Shared()](const ProgressFunction& progress)
      { ExportTouch(*recording, file, progress); },
      [this](const std::string& message) { this->Unplayable = message; });
}

const StudyTouchReading& Study::PollReplay()
{
  std::vector<int> labels;
  for (const SceneContact& contact : this->Contacts())
  {
    labels.push_back(contact.Id);
  }
  return this->Played->Poll(labels);
}

std::size_t Study::Deliver()
{
  const std::size_t count = this->Work.Deliver();
  if (count > 0)
  {
    this->AdoptStructures();
    this->FollowCorrection();
    this->FollowByTouch();
  }
  return count;
}

bool Study::Close(std::chrono::milliseconds longest)
{
  this->StopTouch();
  return this->Work.End(longest);
}

const QualityMeasurement* Study::QualityOf(const SceneStructure& structure) const
{
  const auto found = this->Qualities.find(structure.Id);
  const bool isKnown =
      found != this->Qualities.end() && found->second.Key == QualityKey(this->State(), structure);
  return isKnown ? found->second.Measured.get() : nullptr;
}

void Study::MeasureQuality()
{
  for (const SceneStructure& structure : this->State().Structures)
  {
    if (!structure.IsTouchable || !HasPresets(structure) ||
        this->Measuring.count(structure.Id) > 0 || this->QualityOf(structure) != nullptr)
    {
      continue;
    }
    const int id = structure.Id;
    const std::string key = QualityKey(this->State(), structure);
    StudyJob job;
    job.Work = [this, id, key, structure,
                scene = SceneSettings(this->WithTool())](const ProgressFunction& progress)
    {
      const SteadyClock clock;
      auto measured = std::make_shared<const QualityMeasurement>(
          palpate::MeasureQuality(scene, structure, clock, progress));
      return StudyJob::Delivery(
          [this, id, key, measured = std::move(measured)]
          {
            this->Measuring.erase(id);
            this->Qualities[id] = {key, measured, {}};
          });
    };
    job.Fail = [this, id, key](const std::string& message)
    {
      this->Measuring.erase(id);
      this->Qualities[id] = {key, nullptr, message};
    };
    this->Measuring[id] = this->Work.Start(std::move(job));
  }
}

std::vector<QualityLine> Study::QualityLines() const
{
  std::vector<QualityLine> lines;
  for (const SceneStructure& structure : this->State().Structures)
  {
    if (!structure.IsTouchable || !HasPresets(structure))
    {
      continue;
    }
    QualityLine line = MakeQualityLine(structure, this->QualityOf(structure));
    const auto running = this->Measuring.find(structure.Id);
    if (running != this->Measuring.end())
    {
      const auto progress = this->Work.ProgressOf(running->second);
      line.MeasuringFraction = progress ? progress->Fraction : 0.0;
    }
    const auto known = this->Qualities.find(structure.Id);
    line.Problem = known != this->Qualities.end() ? known->second.Problem : std::string();
    lines.push_back(std::move(line));
  }
  return lines;
}

void Study::UseRecommendedQuality()
{
  StudyState next = this->State();
  for (SceneStructure& structure : next.Structures)
  {
    const QualityMeasurement* measured =
        HasPresets(structure) ? this->QualityOf(structure) : nullptr;
    const int preset = measured != nullptr ? RecommendedPreset(*measured, next.Rate) : -1;
    structure = preset >= 0 ? WithPreset(structure, preset) : structure;
  }
  this->Change("Use the recommended quality", next);
}
} // namespace palpate
