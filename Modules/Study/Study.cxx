#include "Study.h"

#include "DeviceList.h"
#include "InputError.h"
#include "SegmentationFile.h"
#include "StudyFile.h"
#include "StudyRecovery.h"
#include "StudyStructures.h"
#include "TouchRecording.h"
#include "TouchTicksFile.h"

#include <algorithm>
#include <utility>

namespace palpate
{
Study::Study(Clock& clock, const RealtimeRequest& request)
    : Time(clock), Felt(clock, request), Device(clock, Work,
                                                [this](auto device, const std::string& problem)
                                                {
                                                  this->Problem = problem;
                                                  if (device != nullptr)
                                                  {
                                                    this->TakeDevice(std::move(device));
                                                  }
                                                })
{
}

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
  this->FollowShapes();
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
  const bool isMeant =
      this->Felt.IsRunning() || this->Device.IsOpening() || this->Device.IsAwaited();
  const std::string& name = this->Device.Name(); // empty for a device that was given
  if (isMeant && !name.empty() && name != this->State().Device)
  {
    this->StartTouch();
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
  this->EdgesThere.AddTo(state);
  return state;
}

std::vector<SceneContact> Study::Contacts() const
{
  std::vector<SceneContact> contacts = ContactsOf(this->State(), [this](SceneStep step, int id)
                                                  { return this->Made.NewestProduct(step, id); });
  this->Organ.AddTo(contacts);
  this->Correcting.AddTo(contacts);
  this->EdgesThere.AddTo(contacts);
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
  this->Device.Open(this->State().Device, this->AreHeard);
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
  // A hand that does not expect it meets no force.
  this->IsBack = this->Device.IsAwaited() && device->Capabilities().HasMotors;
  this->Device.Found();
  this->Problem =
      this->Felt.Start(std::move(device), this->WithTool(), contacts, this->IsBack).Message();
}

void Study::WatchDevice(const StudyTouchReading& reading)
{
  const bool isLost = this->Felt.IsRunning() && reading.Newest.State == DeviceState::Error &&
                      IsPluggedIn(this->Device.Name());
  if (isLost)
  {
    this->EndTouch();
    this->Device.Await(reading.DeviceProblem);
  }
  const TouchState& newest = reading.Newest;
  this->IsBack =
      this->IsBack && this->Felt.IsRunning() &&
      (newest.State != DeviceState::Ready || newest.Safety.Fault == SafetyFault::SwitchedOff);
  this->Device.TryAgain();
}

std::string Study::DeviceNotice() const
{
  return this->IsBack ? "The device is back: allow force again when the hand is ready."
                      : this->Device.Notice();
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
  this->Device.Cancel();
  this->EndTouch();
}

void Study::EndTouch()
{
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
    this->FollowShapes();
    this->FollowByTouch();
  }
  return count;
}

bool Study::Close(std::chrono::milliseconds longest)
{
  this->StopTouch();
  return this->Work.End(longest);
}
} // namespace palpate
