#include "Study.h"

#include "OpenBuiltInDevice.h"
#include "StudyFile.h"
#include "TouchExport.h"
#include "TouchRecording.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
// What is felt as by hand, but for what has come or gone.
bool IsFeltAlike(const StudyState& a, const StudyState& b)
{
  const auto isAlike = [&b](const StudyStructure& one)
  {
    const StudyStructure* other = FindStructure(b, one.Label);
    return other == nullptr ||
           (one.Representation == other->Representation && one.Degree == other->Degree);
  };
  return a.Interpolation == b.Interpolation &&
         std::all_of(a.Structures.begin(), a.Structures.end(), isAlike);
}

StudyState WithDialOf(const StudyState& before, StudyState next)
{
  if (next.Dial == before.Dial && next.SegmentationFile == before.SegmentationFile &&
      !IsFeltAlike(before, next))
  {
    next.Dial = StudyDial::ByHand;
  }
  return next;
}
} // namespace

Study::Study(Clock& clock, const RealtimeRequest& request) : Time(clock), Felt(clock, request) {}

void Study::Begin(const StudyState& state, const std::filesystem::path& file)
{
  this->StopTouch();
  this->CloseReplay();
  this->Steps.Reset(state);
  this->SessionFile = file;
  this->Unread.clear();
  if (state.Structures.empty())
  {
    this->Unread.insert(state.SegmentationFile);
  }
  this->Follow();
}

void Study::Open(const std::filesystem::path& file)
{
  this->Begin(ReadStudy(file), StudyPath(file));
}

void Study::Save(const std::filesystem::path& file)
{
  WriteStudy(file, this->State());
  this->SessionFile = StudyPath(file);
  this->Steps.MarkSaved();
}

void Study::OpenVolume(const std::filesystem::path& file, const std::string& series)
{
  StudyState next = this->State();
  next.VolumeFile = StudyPath(file);
  next.DicomSeries = series;
  next.View.CrosshairWorld.reset();
  next.View.Window.reset();
  next.View.Level.reset();
  this->Change("Open the volume " + file.filename().string(), next);
}

void Study::OpenSegmentation(const std::filesystem::path& file)
{
  StudyState next = this->State();
  next.SegmentationFile = StudyPath(file);
  next.Structures.clear();
  this->Unread.insert(next.SegmentationFile);
  this->Change("Open the segmentation " + file.filename().string(), next);
}

void Study::RelocateFile(const std::filesystem::path& missing, const std::filesystem::path& moved)
{
  this->Change("Find " + missing.filename().string(), Relocate(this->State(), missing, moved));
}

bool Study::Change(const std::string& sentence, const StudyState& next, const std::string& gesture)
{
  const bool isChanged = this->Steps.Change(sentence, WithDialOf(this->State(), next), gesture);
  if (isChanged)
  {
    this->Follow();
  }
  return isChanged;
}

bool Study::Undo()
{
  const bool isUndone = this->Steps.Undo();
  this->Follow();
  return isUndone;
}

bool Study::Redo()
{
  const bool isRedone = this->Steps.Redo();
  this->Follow();
  return isRedone;
}

// What is made and touched is what the state is now.
void Study::Follow()
{
  this->Made.Update(this->State());
  this->AdoptStructures();
  this->FollowByTouch();
}

void Study::AdoptStructures()
{
  const bool isRead =
      this->Made.StateOf(StudyStep::Segmentation).Is == StudyStepState::Kind::UpToDate;
  if (!isRead || this->Unread.erase(this->State().SegmentationFile) == 0)
  {
    return;
  }
  const auto segmentation = this->Made.Newest<Segmentation>(StudyStep::Segmentation);
  if (this->State().Structures.empty())
  {
    this->Steps.Amend(WithStructuresOf(this->State(), *segmentation));
    this->Made.Update(this->State());
  }
}

void Study::FollowByTouch()
{
  if (this->Felt.IsRunning())
  {
    this->Felt.Forbid(ForbiddenOf(this->State(), this->Made));
    this->Problem =
        this->Felt.Update(this->WithTool(), ContactsOf(this->State(), this->Made)).Message();
  }
}

// The state as it is felt: a tool's surface is the one that was read for it. While that is being
// read, or where it cannot be, the tool before is felt.
StudyState Study::WithTool()
{
  StudyState state = this->State();
  if (state.Tool.Kind == TouchToolSettings::Shape::Surface)
  {
    state.Tool.Surface = this->Made.Newest<SurfaceTool>(StudyStep::Tool);
    if (state.Tool.Surface == nullptr)
    {
      state.Tool = this->ReadTool;
    }
  }
  this->ReadTool = state.Tool;
  return state;
}

void Study::TurnAxes(const Matrix3& rotation)
{
  this->Felt.TurnAxes(rotation);
  this->FollowByTouch();
}

void Study::CancelStep(StudyStep step)
{
  this->Made.Cancel(step);
  this->FollowByTouch();
}

void Study::ResumeStep(StudyStep step)
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
  job.Work = [this, name = this->State().Device, &clock = this->Time](const ProgressFunction&)
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
  job.Fail = [this](const std::string& sentence)
  {
    this->Opening.reset();
    this->Problem = sentence;
  };
  this->Opening = this->Work.Start(std::move(job));
}

void Study::TakeDevice(std::unique_ptr<HapticDevice> device)
{
  const StudyStepState tool = this->Made.StateOf(StudyStep::Tool);
  const bool isMissing = this->State().Tool.Kind == TouchToolSettings::Shape::Surface &&
                         this->Made.Newest<SurfaceTool>(StudyStep::Tool) == nullptr;
  if (isMissing)
  {
    device->Close();
    this->Problem = tool.Is == StudyStepState::Kind::Failed
                        ? tool.Sentence
                        : "The tool's file is still being read: start the touch once it is.";
    return;
  }
  this->Felt.Forbid(ForbiddenOf(this->State(), this->Made));
  this->Problem =
      this->Felt.Start(std::move(device), this->WithTool(), ContactsOf(this->State(), this->Made))
          .Message();
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
}

void Study::OpenReplay(const std::filesystem::path& file)
{
  this->CloseReplay();
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
  job.Fail = [this](const std::string& sentence)
  {
    this->Reading.reset();
    this->Unplayable = sentence;
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
  StudyJob job;
  job.IsUrgent = true;
  job.Work = [file, recording = this->Played->Shared()](const ProgressFunction&)
  {
    ExportTouch(*recording, file);
    return StudyJob::Delivery([] {});
  };
  job.Fail = [this](const std::string& sentence) { this->Unplayable = sentence; };
  this->Work.Start(std::move(job));
}

const StudyTouchReading& Study::PollReplay()
{
  std::vector<int> labels;
  for (const StudyContact& contact : ContactsOf(this->State(), this->Made))
  {
    labels.push_back(contact.Label);
  }
  return this->Played->Poll(labels);
}

std::size_t Study::Deliver()
{
  const std::size_t count = this->Work.Deliver();
  if (count > 0)
  {
    this->AdoptStructures();
    this->FollowByTouch();
  }
  return count;
}

bool Study::Close(std::chrono::milliseconds longest)
{
  this->StopTouch();
  return this->Work.End(longest);
}

StudyState WithStructuresOf(const StudyState& state, const Segmentation& segmentation)
{
  StudyState next = state;
  next.Structures.clear();
  for (const Segment& segment : segmentation.Segments)
  {
    StudyStructure structure;
    structure.Label = segment.Label;
    structure.Name = segment.Name;
    structure.Color = segment.Color;
    structure.Degree = state.Fit.Degree;
    const bool isShown =
        next.Structures.empty() || segmentation.Segments.size() <= Study::MostShownUnasked;
    structure.IsVisible = isShown;
    structure.IsTouchable = isShown;
    next.Structures.push_back(std::move(structure));
  }
  return next;
}
} // namespace palpate
