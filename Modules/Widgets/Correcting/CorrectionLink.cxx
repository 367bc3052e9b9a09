#include "CorrectionLink.h"

#include "ToolIcon.h"

#include <QTimer>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr double NearSurface = 12.0;  // pixels
constexpr double LeastMotion = 0.05;  // mm, as of masks
constexpr double WidthPerNotch = 1.1; // factor
// The first button, which is also the drill's pedal: what is corrected is not drilled.
constexpr std::uint32_t GripButton = 1U << StudyTouch::DrillButton;

// About the size of the triangles at a point, mm: what is on the surface is no farther from a
// point.
double SizeAt(const SurfaceCorrection& pulls, std::size_t point)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < pulls.Points().size(); ++n)
  {
    const double square = (pulls.Points()[n] - pulls.Points()[point]).squaredNorm();
    least = square > 0.0 ? std::min(least, square) : least;
  }
  return 2.0 * std::sqrt(least);
}
} // namespace

std::vector<Vector3> CircleAround(const Vector3& center, const Vector3& right, const Vector3& up,
                                  double radius)
{
  constexpr int Corners = 48;
  std::vector<Vector3> circle;
  for (int n = 0; n < Corners; ++n)
  {
    const double angle = 2.0 * M_PI * n / Corners;
    circle.push_back(center + radius * (std::cos(angle) * right + std::sin(angle) * up));
  }
  return circle;
}

CorrectionLink::CorrectionLink(StudyController& study, ViewContents& contents, ViewGrid& views,
                               std::function<std::vector<int>()> selected,
                               std::function<Vector3()> contact, QObject* parent)
    : QObject(parent), Study(study), Contents(contents), Views(views),
      Selected(std::move(selected)), Contact(std::move(contact)),
      Pulling(new QAction("Push and pull", this)), Gripping(new QAction("Grip where touched", this))
{
  this->Pulling->setCheckable(true);
  this->Pulling->setShortcut(QString("G"));
  this->Pulling->setIcon(ToolIcon(ToolSign::Pull));
  this->Gripping->setShortcut(QString("Shift+G"));
  connect(this->Gripping, &QAction::triggered, this, &CorrectionLink::GripWhereTouched);
  connect(this->Pulling, &QAction::toggled, this, &CorrectionLink::ShowMode);
  connect(&study, &StudyController::StateChanged, this, &CorrectionLink::ShowSurface);
  connect(&study, &StudyController::Touched, this, &CorrectionLink::FollowHand);
  connect(&study, &StudyController::TouchChanged, this, &CorrectionLink::GiveUp);
  for (const SliceOrientation orientation : AllSliceOrientations)
  {
    this->FollowSlice(views.Slice(orientation));
  }
  this->FollowSpace();
  for (ViewPane* pane : views.Panes())
  {
    connect(pane, &ViewPane::StrokeEnded, this, &CorrectionLink::EndPull);
    connect(pane, &ViewPane::WheelTurned, this,
            [this, pane](double, double, double notches) { this->TurnWheel(pane, notches); });
    connect(pane, &ViewPane::PointerLeft, this,
            [this]
            {
              if (this->ArePulls)
              {
                this->HideRing();
              }
            });
  }
}

void CorrectionLink::FollowSlice(SlicePane* slice)
{
  const auto point = [this, slice](double x, double y)
  {
    const auto pointed = this->PointInSlice(*slice, x, y);
    this->ShowRing(pointed, slice->PixelRight().normalized(), slice->PixelUp().normalized());
    return pointed;
  };
  connect(slice, &ViewPane::PointerMoved, this,
          [this, point](double x, double y)
          {
            if (!this->Held && this->ArePulls)
            {
              point(x, y);
            }
          });
  connect(slice, &ViewPane::StrokeBegun, this,
          [this, slice, point](double x, double y)
          {
            const auto pointed = this->ArePulls ? point(x, y) : std::nullopt;
            if (pointed && this->Hold(*pointed, slice->PointAt(x, y), slice))
            {
              slice->Accept();
            }
          });
  connect(slice, &ViewPane::StrokeMoved, this,
          [this, slice](double x, double y)
          {
            if (this->Held && this->Held->Pane == slice)
            {
              this->PullTo(slice->PointAt(x, y));
            }
          });
}

void CorrectionLink::FollowSpace()
{
  SpacePane* space = this->Views.Space();
  const auto point = [this](double x, double y)
  {
    Vector3 picked = Vector3::Zero();
    const auto pointed = this->PointInSpace(x, y, picked);
    Vector3 right = Vector3::UnitX();
    Vector3 up = Vector3::UnitY();
    if (pointed)
    {
      const Vector3 normal = this->Study.Current().Corrected().Pulls()->Directions()[*pointed];
      right = normal.unitOrthogonal();
      up = normal.cross(right);
    }
    this->ShowRing(pointed, right, up);
    return pointed;
  };
  connect(space, &ViewPane::PointerMoved, this,
          [this, point](double x, double y)
          {
            if (!this->Held && this->ArePulls)
            {
              point(x, y);
            }
          });
  connect(space, &ViewPane::StrokeBegun, this,
          [this, space, point](double x, double y)
          {
            const auto pointed = this->ArePulls ? point(x, y) : std::nullopt;
            if (pointed && this->Hold(*pointed, Vector3::Zero(), space))
            {
              this->Held->StartHeight = y;
              this->Held->StartOffset = this->OffsetInSpace(x, y);
              space->Accept();
            }
          });
  connect(space, &ViewPane::StrokeMoved, this, &CorrectionLink::PullInSpace);
}

void CorrectionLink::ShowMode(bool isOn)
{
  this->GiveUp();
  this->HideRing();
  const StudyState& state = this->Study.State();
  if (isOn && FindStructure(state, state.Correction.StructureId) == nullptr)
  {
    this->Choose(this->FirstToCorrect());
  }
  if (isOn && this->Study.State().Correction.StructureId == 0)
  {
    this->Study.Report("There is nothing to correct: open a mask or a model.");
    // Once everybody knows that it is on.
    QTimer::singleShot(0, this->Pulling, [mode = this->Pulling] { mode->setChecked(false); });
  }
}

// 0 if there is none.
int CorrectionLink::FirstToCorrect() const
{
  std::vector<int> ids = this->Selected();
  for (const SceneStructure& structure : this->Study.State().Structures)
  {
    ids.push_back(structure.Id);
  }
  for (const int id : ids)
  {
    const SceneStructure* const one = FindStructure(this->Study.State(), id);
    if (one != nullptr && StudyCorrected::IsCorrectable(*one))
    {
      return id;
    }
  }
  return 0;
}

void CorrectionLink::Choose(int id)
{
  StudyState next = this->Study.State();
  if (id != next.Correction.StructureId)
  {
    next.Correction.StructureId = id;
    next.Correction.Steps.clear();
    this->Study.Change(id != 0 ? "Correct a structure" : "Discard the correction", next);
  }
}

// A preview that is shown ends by itself once the study has changed.
void CorrectionLink::ShowSurface()
{
  this->Contents.ShowCorrection(this->Study.State(), this->Study.Current().Corrected());
}

std::optional<std::size_t> CorrectionLink::PointInSlice(const SlicePane& slice, double x, double y)
{
  const SurfaceCorrection* pulls = this->Study.Current().Corrected().Pulls();
  if (!this->IsPulling() || pulls == nullptr || pulls->Points().empty())
  {
    return std::nullopt;
  }
  const Vector3 pointer = slice.PointAt(x, y);
  const std::size_t point = pulls->NearestNow(pointer);
  const double reach = NearSurface * slice.PixelRight().norm() + SizeAt(*pulls, point);
  return (pulls->PointNow(point) - pointer).norm() < reach ? std::optional(point) : std::nullopt;
}

std::optional<std::size_t> CorrectionLink::PointInSpace(double x, double y, Vector3& pickedWorld)
{
  const SurfaceCorrection* pulls = this->Study.Current().Corrected().Pulls();
  const bool isOn = this->IsPulling() && pulls != nullptr && !pulls->Points().empty();
  if (!isOn || this->Views.Space()->View()->PickObject(x, y, pickedWorld.data()) !=
                   this->Contents.Correction().Display())
  {
    return std::nullopt;
  }
  return pulls->NearestNow(pickedWorld);
}

bool CorrectionLink::Hold(std::size_t point, const Vector3& startWorld, ViewPane* pane)
{
  StudyCorrected& corrected = this->Study.Current().Corrected();
  if (!corrected.IsReady())
  {
    return false; // the last step is being done
  }
  this->Study.EndGesture();
  Grip grip;
  grip.PlaceWorld = corrected.Pulls()->PointNow(point);
  grip.Normal = corrected.Pulls()->Directions()[point];
  grip.StartWorld = startWorld;
  grip.Pane = pane;
  grip.Pull = PullAt(this->Next, grip.PlaceWorld);
  this->Held = grip;
  return true;
}

// The surface follows the pointer on its normal; where that is looked at from its end, upwards is
// outwards.
double CorrectionLink::OffsetInSpace(double x, double y) const
{
  vtkRenderer* renderer = this->Views.Space()->Renderer();
  const auto worldAt = [renderer](double atX, double atY, double depth)
  {
    renderer->SetDisplayPoint(atX, atY, depth);
    renderer->DisplayToWorld();
    const double* world = renderer->GetWorldPoint();
    return Vector3(Vector3(world) / world[3]);
  };
  const auto offset = OffsetOnNormal(this->Held->PlaceWorld, this->Held->Normal, worldAt(x, y, 0.0),
                                     worldAt(x, y, 1.0));
  if (offset)
  {
    return *offset;
  }
  const Vector3& place = this->Held->PlaceWorld;
  renderer->SetWorldPoint(place.x(), place.y(), place.z(), 1.0);
  renderer->WorldToDisplay();
  const double depth = renderer->GetDisplayPoint()[2];
  const double pixel = (worldAt(x, y + 1.0, depth) - worldAt(x, y, depth)).norm();
  return (y - this->Held->StartHeight) * pixel;
}

void CorrectionLink::PullInSpace(double x, double y)
{
  if (this->Held && this->Held->Pane == this->Views.Space())
  {
    this->Held->Pull.Displacement =
        std::clamp(this->OffsetInSpace(x, y) - this->Held->StartOffset,
                   -SurfaceCorrection::LargestDisplacement, SurfaceCorrection::LargestDisplacement);
    this->Preview();
  }
}

void CorrectionLink::PullTo(const Vector3& pointWorld)
{
  this->Held->Pull.TargetWorld = this->Held->PlaceWorld + pointWorld - this->Held->StartWorld;
  this->Preview();
}

void CorrectionLink::Preview()
{
  const PullWidth width = this->Next;
  const SurfacePull wide = PullAt(width, this->Held->PlaceWorld);
  this->Held->Pull.Width = wide.Width;
  this->Held->Pull.SecondWidth = wide.SecondWidth;
  const Status status = this->Study.Current().Corrected().Preview(this->Held->Pull);
  if (!status.IsOk())
  {
    this->Study.Report(status.Message());
    this->GiveUp();
  }
  this->ShowSurface();
  this->ShowRing(this->Pointed, this->RingRight, this->RingUp);
}

void CorrectionLink::EndPull()
{
  if (!this->Held)
  {
    return;
  }
  const SurfacePull pull = this->Held->Pull;
  const bool isMoved = (this->Held->Place() - pull.PlaceWorld).norm() >= LeastMotion;
  this->GiveUp();
  if (isMoved)
  {
    this->Do(pull);
  }
}

void CorrectionLink::GiveUp()
{
  if (this->Held)
  {
    if (this->IsInHand())
    {
      this->Study.Current().LetGoOfCorrected(false);
    }
    this->Held.reset();
    this->Study.Current().Corrected().EndPreview();
    this->ShowSurface();
    this->HideRing(); // until the pointer moves
  }
}

void CorrectionLink::Do(const CorrectionStep& step)
{
  StudyState next = this->Study.State();
  if (next.Correction.Steps.size() >= StudyCorrection::MostSteps)
  {
    this->Study.Report("There are 1,100 steps already: keep the result and go on from it.");
    return;
  }
  next.Correction.Steps.push_back(step);
  if (NumbersIn(next.Correction.Steps) > StudyCorrection::MostNumbers)
  {
    this->Study.Report("The strokes so far are too many: keep the result and go on from it.");
    return;
  }
  this->Study.Change(QString::fromStdString(NameOf(step)), next);
}

void CorrectionLink::LetPull(bool arePulls)
{
  this->GiveUp();
  this->HideRing();
  this->ArePulls = arePulls;
}

void CorrectionLink::SetWidth(const PullWidth& width)
{
  this->Next = width;
  this->Next.Width = std::clamp(width.Width, PullWidth::Least, PullWidth::Largest);
  if (this->Held)
  {
    this->Preview();
  }
  else
  {
    this->ShowRing(this->Pointed, this->RingRight, this->RingUp);
  }
  Q_EMIT WidthChanged();
}

// Elsewhere the wheel is the slices' and the camera's.
void CorrectionLink::TurnWheel(ViewPane* pane, double notches)
{
  if (this->IsPulling() && (this->Held || this->Pointed))
  {
    pane->Accept();
    this->SetWidth({this->Next.Width * std::pow(WidthPerNotch, notches), this->Next.HasTwo});
  }
}

// What is held has it where it is led.
void CorrectionLink::ShowRing(std::optional<std::size_t> point, const Vector3& right,
                              const Vector3& up)
{
  if (!this->Held)
  {
    this->Pointed = point;
    this->RingRight = right;
    this->RingUp = up;
  }
  // An edit or an undo may have left no such point.
  const SurfaceCorrection* pulls = this->Study.Current().Corrected().Pulls();
  const bool isThere = point && pulls != nullptr && *point < pulls->Points().size();
  std::vector<Vector3> ring;
  if (this->Held || isThere)
  {
    const Vector3 center = this->Held ? this->Held->Place() : pulls->PointNow(*point);
    ring = CircleAround(center, this->RingRight, this->RingUp, this->Next.Width);
  }
  this->Contents.ShowRing(ring, QString("%1 mm").arg(this->Next.Width, 0, 'f', 1).toStdString());
}

// The device's button grips what its tool touches; until it is released, the hand leads the
// surface.
void CorrectionLink::FollowHand()
{
  const StudyTouchReading& reading = this->Study.Reading();
  const bool isPressed =
      this->Study.IsTouching() && (reading.Newest.Sample.Buttons & GripButton) != 0;
  const bool isChanged = isPressed != std::exchange(this->WasPressed, isPressed);
  const bool isOn = this->IsPulling();
  if (isChanged && isOn && isPressed == !this->IsInHand())
  {
    this->Gripping->trigger();
  }
  if (this->IsInHand())
  {
    this->PullTo(Vector3(reading.Newest.ProbeWorld));
  }
}

void CorrectionLink::GripWhereTouched()
{
  if (!this->ArePulls)
  {
    return;
  }
  if (this->IsInHand())
  {
    this->EndPull();
    return;
  }
  const StudyTouchReading& reading = this->Study.Reading();
  StudyCorrected& corrected = this->Study.Current().Corrected();
  if (!this->Study.IsTouching() || !this->Pulling->isChecked() || corrected.Pulls() == nullptr ||
      reading.TouchedId == 0 || reading.TouchedId != corrected.StructureId())
  {
    this->Study.Report("The tool does not touch what is corrected: choose Push and pull (G), and "
                       "touch the structure.");
    return;
  }
  const std::size_t point = corrected.Pulls()->NearestNow(this->Contact());
  if (!this->Held && this->Hold(point, Vector3(reading.Newest.ProbeWorld), nullptr))
  {
    this->RingRight = this->Held->Normal.unitOrthogonal();
    this->RingUp = this->Held->Normal.cross(this->RingRight);
    this->Study.Current().LetGoOfCorrected(true);
  }
}
} // namespace palpate
