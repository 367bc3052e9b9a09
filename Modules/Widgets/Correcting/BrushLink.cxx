#include "BrushLink.h"

#include "vtkAppendPolyData.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr double RadiusPerNotch = 1.1; // factor
constexpr std::uint32_t BrushButton = 1U << StudyTouch::DrillButton;

Vector3 NormalOf(const SlicePane& slice)
{
  return slice.PixelRight().cross(slice.PixelUp()).normalized();
}

// To the head, the front and the right, as the slices are counted.
Vector3 ForwardOf(const ViewGrid& views, const SlicePane* pane)
{
  return pane == views.Slice(SliceOrientation::Axial)     ? Vector3(0.0, 0.0, 1.0)
         : pane == views.Slice(SliceOrientation::Coronal) ? Vector3(0.0, -1.0, 0.0)
                                                          : Vector3(-1.0, 0.0, 0.0);
}
} // namespace

BrushLink::BrushLink(StudyController& study, ViewContents& contents, ViewGrid& views,
                     CorrectionLink& pulls, QObject* parent)
    : QObject(parent), Study(study), Contents(contents), Views(views), Pulls(pulls)
{
  this->MakeActions();
  for (const SliceOrientation orientation : AllSliceOrientations)
  {
    this->FollowSlice(views.Slice(orientation));
  }
  this->FollowSpace();
  for (ViewPane* pane : views.Panes())
  {
    connect(pane, &ViewPane::StrokeEnded, this, &BrushLink::End);
    connect(pane, &ViewPane::WheelTurned, this,
            [this, pane](double, double, double notches)
            {
              if (this->IsOn() && this->HasRing)
              {
                pane->Accept();
                this->SetRadius(this->Size * std::pow(RadiusPerNotch, notches));
              }
            });
    connect(pane, &ViewPane::PointerLeft, this,
            [this]
            {
              if (this->IsOn())
              {
                this->HasRing = false;
                this->Contents.ShowRing({}, {});
              }
            });
  }
  connect(pulls.Mode(), &QAction::toggled, this,
          [this]
          {
            this->HasRing = false;
            this->GiveUp();
            this->FollowEdges();
          });
  connect(pulls.GripTool(), &QAction::triggered, this, &BrushLink::GripByHand);
  connect(&study, &StudyController::StateChanged, this, &BrushLink::ForgetDone);
  connect(&study, &StudyController::StateChanged, this, &BrushLink::FollowEdges);
  connect(&study, &StudyController::Touched, this, &BrushLink::FollowHand);
  connect(&study, &StudyController::TouchChanged, this,
          [this]
          {
            if (this->IsInHand())
            {
              this->GiveUp();
            }
            this->FollowEdges();
          });
}

void BrushLink::MakeActions()
{
  const auto add = [this](QList<QAction*>& list, const char* text, const char* key, auto act)
  {
    auto* action = new QAction(text, this);
    action->setShortcut(QString(key));
    connect(action, &QAction::triggered, this, act);
    list.append(action);
  };
  const auto choose = [this](CorrectionTool tool)
  {
    return [this, tool]
    {
      this->Pulls.Mode()->setChecked(true);
      this->SetTool(this->Chosen == tool ? CorrectionTool::Pull : tool);
    };
  };
  add(this->Brushes, "Paint or pull", "B", choose(CorrectionTool::Paint));
  add(this->Brushes, "Erase or pull", "Shift+B", choose(CorrectionTool::Erase));
  add(this->OfSlices, "Copy to next slice", "Ctrl+Shift+Up", [this] { this->CopySlice(1); });
  add(this->OfSlices, "Copy to previous slice", "Ctrl+Shift+Down", [this] { this->CopySlice(-1); });
  add(this->OfSlices, "Fill between slices", "Ctrl+Shift+F", [this] { this->FillBetween(); });
}

void BrushLink::FollowSlice(SlicePane* slice)
{
  connect(slice, &ViewPane::PointerMoved, this,
          [this, slice](double x, double y)
          {
            this->Pointed = slice;
            this->ShowRing(slice->PointAt(x, y), slice->PixelRight().normalized(),
                           slice->PixelUp().normalized());
          });
  connect(slice, &ViewPane::StrokeBegun, this,
          [this, slice](double x, double y, bool hasControl)
          { this->Begin(slice->PointAt(x, y), NormalOf(*slice), hasControl, slice); });
  connect(slice, &ViewPane::StrokeMoved, this,
          [this, slice](double x, double y)
          {
            if (this->Leading == slice)
            {
              this->Move(slice->PointAt(x, y));
            }
          });
}

void BrushLink::FollowSpace()
{
  SpacePane* space = this->Views.Space();
  connect(space, &ViewPane::PointerMoved, this,
          [this, space](double x, double y)
          {
            if (const auto place = this->PointInSpace(x, y))
            {
              this->ShowRing(*place, space->Axes().col(0), space->Axes().col(1));
            }
            else if (this->IsOn() && std::exchange(this->HasRing, false))
            {
              this->Contents.ShowRing({}, {});
            }
          });
  connect(space, &ViewPane::StrokeBegun, this,
          [this, space](double x, double y, bool hasControl)
          {
            if (const auto place = this->PointInSpace(x, y))
            {
              this->Begin(*place, std::nullopt, hasControl, space);
            }
          });
  connect(space, &ViewPane::StrokeMoved, this,
          [this, space](double x, double y)
          {
            const auto place = this->PointInSpace(x, y);
            if (this->Leading == space && place)
            {
              this->Move(*place);
            }
          });
}

bool BrushLink::IsOn() const
{
  return this->Pulls.Mode()->isChecked() && this->Chosen != CorrectionTool::Pull;
}

std::optional<Vector3> BrushLink::PointInSpace(double x, double y) const
{
  Vector3 picked = Vector3::Zero();
  const bool isThere =
      this->IsOn() && this->Views.Space()->View()->PickObject(x, y, picked.data()) ==
                          this->Contents.Correction().Display();
  return isThere ? std::optional(picked) : std::nullopt;
}

void BrushLink::SetTool(CorrectionTool tool)
{
  this->GiveUp();
  this->Chosen = tool;
  this->HasRing = false;
  this->Contents.ShowRing({}, {});
  this->Pulls.LetPull(tool == CorrectionTool::Pull);
  this->FollowEdges();
  Q_EMIT Changed();
}

void BrushLink::SetKeepsToEdges(bool isOn)
{
  this->IsToEdges = isOn;
  this->FollowEdges();
}

void BrushLink::FollowEdges()
{
  auto& open = this->Study.Current();
  open.FeelEdges(this->IsOn() && this->IsToEdges && this->Study.IsTouching());
  const std::string before = std::exchange(this->EdgeProblem, open.Edges().Problem());
  if (!this->EdgeProblem.empty() && this->EdgeProblem != before)
  {
    this->Study.Report(this->EdgeProblem);
  }
}

void BrushLink::SetRadius(double radius)
{
  this->Size = std::clamp(radius, LeastRadius, LargestRadius);
  if (this->Brush.IsBegun())
  {
    this->Move(this->Brush.Current()->PointsWorld->back());
  }
  if (this->HasRing)
  {
    this->ShowRing(this->RingWorld, this->RingRight, this->RingUp);
  }
  Q_EMIT Changed();
}

void BrushLink::Begin(const Vector3& placeWorld, const std::optional<Vector3>& normal, bool isOther,
                      ViewPane* pane)
{
  if (!this->IsOn() || this->Brush.IsBegun())
  {
    return;
  }
  BrushStroke like;
  like.Radius = this->Size;
  like.SliceNormal = normal;
  like.Erases = (this->Chosen == CorrectionTool::Erase) != isOther;
  vtkImageData* image = this->Contents.Images()->GetImage();
  const bool lacksImage = this->IsToEdges && image == nullptr;
  const Status status =
      lacksImage ? Status::Failure("There is no volume whose edges a brush could keep to.")
                 : this->Brush.Begin(this->Study.Current().Corrected(), like, placeWorld,
                                     this->IsToEdges ? image : nullptr);
  if (pane != nullptr)
  {
    pane->Accept(); // a drag that paints nothing moves no crosshair either
  }
  if (!status.IsOk())
  {
    this->Study.Report(status.Message());
    return;
  }
  this->Study.EndGesture();
  this->Leading = pane;
  this->ShowStrokes();
}

void BrushLink::Move(const Vector3& placeWorld)
{
  if (!this->Brush.IsBegun())
  {
    return;
  }
  const Status status = this->Brush.Move(placeWorld, this->Size);
  if (!status.IsOk())
  {
    this->Study.Report("The brush " + status.Message() + ".");
    this->Leading = nullptr;
  }
  this->ShowStrokes();
}

void BrushLink::End()
{
  if (!this->Brush.IsBegun())
  {
    return;
  }
  const bool erases = this->Brush.Current()->Erases;
  const vtkSmartPointer<vtkPolyData> outline = this->Brush.Outline();
  this->Leading = nullptr;
  if (const std::optional<CorrectionStep> step = this->Brush.End())
  {
    this->Strokes.push_back({outline, erases});
    this->Pulls.Do(*step);
  }
  this->ShowStrokes();
}

void BrushLink::GiveUp()
{
  this->Leading = nullptr;
  this->Brush.GiveUp();
  this->ShowStrokes();
}

void BrushLink::ShowRing(const Vector3& placeWorld, const Vector3& right, const Vector3& up)
{
  if (!this->IsOn())
  {
    return;
  }
  this->HasRing = true;
  this->RingWorld = placeWorld;
  this->RingRight = right;
  this->RingUp = up;
  this->Contents.ShowRing(CircleAround(placeWorld, right, up, this->Size),
                          QString("%1 mm").arg(this->Size, 0, 'f', 1).toStdString());
}

// Those that the mask has not yet, and the one that is led, in the colour of the last.
void BrushLink::ShowStrokes()
{
  std::vector<Pending> all = this->Strokes;
  if (this->Brush.IsBegun() && this->Brush.Outline() != nullptr)
  {
    all.push_back({this->Brush.Outline(), this->Brush.Current()->Erases});
  }
  if (all.empty())
  {
    this->Contents.ShowStroke(nullptr, false);
    return;
  }
  vtkNew<vtkAppendPolyData> together;
  for (const Pending& one : all)
  {
    together->AddInputData(one.Outline);
  }
  together->Update();
  this->Contents.ShowStroke(together->GetOutput(), all.back().Erases);
}

void BrushLink::ForgetDone()
{
  StudyCorrected& corrected = this->Study.Current().Corrected();
  if (!this->Strokes.empty() && (corrected.IsReady() || !corrected.IsWorking()))
  {
    this->Strokes.clear();
    this->ShowStrokes();
  }
}

void BrushLink::FollowHand()
{
  const StudyTouchReading& reading = this->Study.Reading();
  const bool isPressed =
      this->Study.IsTouching() && (reading.Newest.Sample.Buttons & BrushButton) != 0;
  const bool isChanged = isPressed != std::exchange(this->WasPressed, isPressed);
  if (isChanged && this->IsOn() && isPressed == !this->IsInHand())
  {
    this->GripByHand();
  }
  const bool touches = reading.TouchedId != 0 &&
                       reading.TouchedId == this->Study.Current().Corrected().StructureId();
  if (this->IsInHand() && touches)
  {
    this->Move(this->PlaceOfTool());
  }
}

// The surface's point that is nearest to the tool; what is touched has one.
Vector3 BrushLink::PlaceOfTool() const
{
  const SurfaceCorrection* pulls = this->Study.Current().Corrected().Pulls();
  const Vector3 tool = this->Pulls.TouchedPlace();
  return pulls != nullptr && !pulls->Points().empty() ? pulls->PointNow(pulls->NearestNow(tool))
                                                      : tool;
}

// Where the tool touches the structure, which goes on to be felt as it was at the stroke's begin.
void BrushLink::GripByHand()
{
  if (!this->IsOn())
  {
    return;
  }
  if (this->IsInHand())
  {
    this->End();
    return;
  }
  const int touched = this->Study.IsTouching() ? this->Study.Reading().TouchedId : 0;
  if (touched == 0 || touched != this->Study.Current().Corrected().StructureId())
  {
    this->Study.Report("The tool does not touch what is corrected: touch the structure to paint.");
    return;
  }
  this->Begin(this->PlaceOfTool(), std::nullopt, false, nullptr);
}

// Over which the pointer was last, or else with the keyboard.
SlicePane* BrushLink::PaneOfSlices() const
{
  SlicePane* chosen = this->Pointed;
  for (const SliceOrientation orientation : AllSliceOrientations)
  {
    SlicePane* const slice = this->Views.Slice(orientation);
    chosen = chosen == nullptr && slice->Canvas()->hasFocus() ? slice : chosen;
  }
  return chosen != nullptr ? chosen : this->Views.Slice(SliceOrientation::Axial);
}

void BrushLink::CopySlice(int direction)
{
  const CorrectedMask* mask = this->Study.Current().Corrected().Voxels();
  SlicePane* const pane = this->PaneOfSlices();
  const Vector3 cross(this->Contents.Crosshair()->GetPositionWorld());
  const auto shown =
      mask != nullptr ? SliceOfPlane(mask->Grid(), cross, NormalOf(*pane)) : std::nullopt;
  if (!shown)
  {
    this->Study.Report(mask == nullptr
                           ? "There is no mask under correction: choose Push and pull (G)."
                           : "The slices shown are not those of the mask: choose View > Slices "
                             "along the volume's axes.");
    return;
  }
  const Vector3 along = mask->Grid().Axes.col(shown->Axis);
  const int step = along.dot(ForwardOf(this->Views, pane)) > 0.0 ? direction : -direction;
  const int next = shown->Slice + step;
  if (next < 0 || next >= mask->ImageSize()[static_cast<std::size_t>(shown->Axis)])
  {
    this->Study.Report("There is no slice beyond this one.");
    return;
  }
  this->Pulls.Do(SliceCopy{shown->Axis, shown->Slice, next});
  const Vector3 moved = cross + step * along;
  this->Contents.Crosshair()->SetPositionWorld(moved.data());
}

void BrushLink::FillBetween()
{
  const CorrectedMask* mask = this->Study.Current().Corrected().Voxels();
  const auto filling =
      mask != nullptr ? FillingBetweenPainted(this->Study.State().Correction.Steps, mask->Grid())
                      : std::nullopt;
  if (!filling)
  {
    this->Study.Report("There is nothing to fill between: paint in two slices with others between "
                       "them first.");
    return;
  }
  this->Pulls.Do(*filling);
}
} // namespace palpate
