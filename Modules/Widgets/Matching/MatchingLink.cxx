#include "MatchingLink.h"

#include "SceneMove.h"
#include "ToolIcon.h"

#include <cmath>

namespace palpate
{
namespace
{
constexpr int FramePeriod = 16; // ms
} // namespace

MatchingLink::MatchingLink(StudyController& study, ViewContents& contents, ViewGrid& views,
                           QObject* parent)
    : QObject(parent), Study(study), Contents(contents), Views(views),
      Matching(new QAction("Hold and match", this)),
      Holding(new QAction("Hold the organ at the tool", this)), Held(study.Current().Jobs())
{
  this->Matching->setCheckable(true);
  this->Matching->setShortcut(QString("H"));
  this->Matching->setIcon(ToolIcon(ToolSign::Match));
  this->Holding->setCheckable(true);
  this->Holding->setShortcut(QString("Shift+H"));
  this->Frames.setInterval(FramePeriod);
  this->Since.start();
  connect(this->Matching, &QAction::toggled, this, &MatchingLink::ShowMode);
  connect(this->Holding, &QAction::toggled, this, &MatchingLink::HoldAtTool);
  connect(&this->Frames, &QTimer::timeout, this, &MatchingLink::Advance);
  // Queued: once the views show what has changed.
  connect(&study, &StudyController::StateChanged, this, &MatchingLink::FollowSurfaces,
          Qt::QueuedConnection);
  connect(&study, &StudyController::ProductsChanged, this, &MatchingLink::FollowSurfaces,
          Qt::QueuedConnection);
  connect(&study, &StudyController::Touched, this, &MatchingLink::FollowTouch);
  connect(&study, &StudyController::TouchChanged, this,
          [this]
          {
            this->Holding->setChecked(this->Holding->isChecked() && this->Study.IsTouching());
            this->ShowDragging();
          });
  for (const SliceOrientation orientation : AllSliceOrientations)
  {
    this->FollowSlice(views.Slice(orientation));
  }
  this->FollowSpace(views.Space());
}

void MatchingLink::FollowSlice(SlicePane* slice)
{
  connect(slice, &SlicePane::StrokeBegun, this,
          [this, slice](double x, double y, bool hasControl)
          {
            if (this->Matching->isChecked())
            {
              slice->Accept();
              this->BeginStroke(slice->PointAt(x, y), hasControl);
            }
          });
  connect(slice, &SlicePane::StrokeMoved, this,
          [this, slice](double x, double y) { this->MoveStroke(*slice, slice->PointAt(x, y)); });
  connect(slice, &SlicePane::StrokeEnded, this,
          [this]
          {
            if (this->Held.Is() == HeldOrgan::Phase::Pointed)
            {
              this->Release();
            }
          });
}

void MatchingLink::FollowSpace(SpacePane* space)
{
  connect(space, &SpacePane::Dragged, this, &MatchingLink::TakeDrag);
  connect(space, &SpacePane::DragEnded, this,
          [this]
          {
            if (this->Held.Is() == HeldOrgan::Phase::Pointed)
            {
              this->Release();
            }
          });
}

void MatchingLink::Choose(const MatchChoice& choice)
{
  const bool isOther =
      choice.MovingId != this->Chosen.MovingId || choice.FixedId != this->Chosen.FixedId;
  this->Chosen = choice;
  if (isOther)
  {
    this->Take();
  }
  Q_EMIT Changed();
}

vtkPolyData* MatchingLink::SurfaceOf(int id) const
{
  const auto shown = this->Contents.Surfaces().find(id);
  return shown != this->Contents.Surfaces().end() ? shown->second->GetSurface() : nullptr;
}

// Both organs as they are displayed now.
void MatchingLink::Take()
{
  this->Holding->setChecked(false);
  this->Held.Leave();
  this->Moving = this->SurfaceOf(this->Chosen.MovingId);
  this->Fixed = this->SurfaceOf(this->Chosen.FixedId);
  const bool canTake = this->Matching->isChecked() && this->Moving != nullptr &&
                       this->Fixed != nullptr && this->Moving != this->Fixed;
  if (canTake)
  {
    const Status status = this->Held.Take(this->Moving, this->Fixed);
    if (!status.IsOk())
    {
      this->Study.Report("The organ cannot be held: " + status.Message() + ".");
    }
  }
  this->Show();
  this->ShowDragging();
}

// A surface that is made again, as after a match was kept, is taken where it is now.
void MatchingLink::FollowSurfaces()
{
  const bool areSame = this->SurfaceOf(this->Chosen.MovingId) == this->Moving &&
                       this->SurfaceOf(this->Chosen.FixedId) == this->Fixed;
  if (!areSame)
  {
    this->Take();
  }
  else if (this->Held.Is() != HeldOrgan::Phase::Absent)
  {
    this->Show(); // the display of the structure may be visible again
  }
  Q_EMIT Changed();
}

void MatchingLink::ShowMode(bool isOn)
{
  if (isOn && this->Held.Is() == HeldOrgan::Phase::Absent)
  {
    this->Take();
  }
  else if (!isOn)
  {
    this->Holding->setChecked(false);
    this->Release();
  }
  this->ShowDragging();
  Q_EMIT Changed();
}

// While a tool touches, the mouse in the 3-D view leads it instead.
void MatchingLink::ShowDragging()
{
  const bool isOn = this->Matching->isChecked() && !this->Study.IsTouching() &&
                    this->Held.Is() != HeldOrgan::Phase::Absent;
  this->Last = isOn ? this->Held.Middle() : this->Last;
  this->Views.Space()->SetDragging(isOn, this->Last);
}

void MatchingLink::BeginStroke(const Vector3& point, bool turns)
{
  this->Last = point;
  this->IsTurning = turns;
  if (this->Held.Is() != HeldOrgan::Phase::Carried)
  {
    this->Held.Point();
  }
  this->Frames.start();
}

void MatchingLink::MoveStroke(const SlicePane& slice, const Vector3& point)
{
  if (!this->Matching->isChecked() || !this->Held.IsHeld())
  {
    return;
  }
  if (this->IsTurning)
  {
    const Vector3 axis = slice.PixelRight().cross(slice.PixelUp()).normalized();
    const Vector3 from = this->Last - this->Held.Middle();
    const Vector3 to = point - this->Held.Middle();
    const double angle =
        std::atan2(axis.dot(from.cross(to)), from.dot(to) - axis.dot(from) * axis.dot(to));
    this->Held.Turn(angle * axis);
    if (this->Held.Field() != nullptr)
    {
      this->Study.Current().Hold(this->Held.Field());
    }
  }
  else
  {
    this->Held.Move(point - this->Last);
  }
  this->Last = point;
  this->Advance();
}

void MatchingLink::TakeDrag(const Vector3& world)
{
  if (!this->Matching->isChecked() || this->Study.IsTouching())
  {
    return;
  }
  if (this->Held.Is() != HeldOrgan::Phase::Pointed)
  {
    this->Held.Point();
    this->Frames.start();
  }
  this->Held.Move(world - this->Last);
  this->Last = world;
  this->Advance();
}

void MatchingLink::HoldAtTool(bool isHeld)
{
  if (!isHeld)
  {
    if (this->Held.Is() == HeldOrgan::Phase::Carried)
    {
      this->Study.Current().Hold(nullptr);
      this->Release();
    }
    return;
  }
  const bool canHold = this->Matching->isChecked() && this->Study.IsTouching() &&
                       this->Held.Is() != HeldOrgan::Phase::Absent;
  if (!canHold)
  {
    this->Holding->setChecked(false);
    this->Study.Report("The tool cannot hold the organ: choose two organs, switch on \"Hold and "
                       "match\" and start touching first.");
    return;
  }
  this->Held.Carry(Vector3(this->Study.Reading().Newest.ProbeWorld));
  this->Study.Current().Hold(this->Held.Field());
  this->Frames.start();
}

void MatchingLink::FollowTouch()
{
  const TouchState& newest = this->Study.Reading().Newest;
  const bool isDown = newest.HasSample && (newest.Sample.Buttons & (1U << HoldButton)) != 0;
  if (this->Matching->isChecked() && isDown != this->IsButtonDown)
  {
    this->Holding->setChecked(isDown);
  }
  this->IsButtonDown = isDown;
  this->Held.FollowTool(Vector3(newest.ProbeWorld));
}

void MatchingLink::Release()
{
  this->Held.Release();
  this->Advance();
}

void MatchingLink::Advance()
{
  this->Held.Advance(0.001 * static_cast<double>(this->Since.elapsed()));
  this->Show();
  using Phase = HeldOrgan::Phase;
  const bool isStill = this->Held.Is() == Phase::Absent || this->Held.Is() == Phase::Lying;
  if (isStill && this->Frames.isActive())
  {
    this->Frames.stop();
    this->ShowDragging();
  }
  Q_EMIT Changed();
}

void MatchingLink::Show()
{
  const bool isShown = this->Held.Is() != HeldOrgan::Phase::Absent;
  this->Contents.ShowHeld(this->Chosen.MovingId,
                          isShown ? Moved(this->Held.Pose(), this->Moving).Get() : nullptr);
}

void MatchingLink::PutBack()
{
  this->Holding->setChecked(false);
  this->Held.PutBack();
  if (!this->Matching->isChecked())
  {
    this->Held.Leave();
  }
  this->Show();
  this->ShowDragging();
  Q_EMIT Changed();
}

void MatchingLink::Keep(const std::filesystem::path& file)
{
  this->Study.Try(
      [&]
      {
        const StudyState next =
            WriteMatch(this->Study.State(), this->Chosen, this->Held.Pose(), file);
        this->Study.Change("Keep the match", next);
      });
}
} // namespace palpate
