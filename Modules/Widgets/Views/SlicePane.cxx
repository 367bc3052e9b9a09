#include "SlicePane.h"

namespace palpate
{
namespace
{
QColor ColorFor(SliceOrientation orientation)
{
  const auto color = ColorOf(orientation);
  return QColor::fromRgbF(color[0], color[1], color[2]);
}
} // namespace

SlicePane::SlicePane(SliceOrientation orientation, const ViewContents& contents, QWidget* parent)
    : ViewPane(NameOf(orientation), ColorFor(orientation), parent)
{
  this->setObjectName(QString(NameOf(orientation)).toLower());
  this->Slice->SetOrientation(static_cast<int>(orientation));
  this->Slice->TitleVisibilityOff(); // the header has it
  this->Show(this->Slice, contents);
  this->Style->AddView(this->Slice);
  this->SetStyle(this->Style);
  this->Style->AddObserver(vtkInteractorStyleSlice::AimedEvent, this, &SlicePane::TellAim);
  this->Style->AddObserver(vtkInteractorStyleSlice::PressedEvent, this, &SlicePane::Pressed);
  this->Style->AddObserver(vtkInteractorStyleSlice::HandMovedEvent, this, &SlicePane::TellHand);
  this->Style->AddObserver(vtkInteractorStyleSlice::LiftedEvent, this, &SlicePane::Lifted);
  connect(this, &ViewPane::Rendered, this,
          [this]
          {
            this->Header()->ShowSlice(this->Slice->GetSliceNumber(),
                                      this->Slice->GetNumberOfSlices());
            this->TellPoint(); // the slice may have moved under the pointer
          });
  connect(this->Header(), &ViewHeader::SliceChosen, this, &SlicePane::ChooseSlice);
  connect(this, &ViewPane::PointerMoved, this,
          [this](double x, double y)
          {
            this->Pointer = QPointF(x, y);
            this->TellPoint();
          });
  connect(this, &ViewPane::PointerLeft, this, [this] { this->Pointer.reset(); });
  connect(this, &ViewPane::Clicked, this,
          [this](double x, double y) { Q_EMIT ClickedAt(this->PointAt(x, y)); });
  connect(this, &ViewPane::Tapped, this,
          [this](double x, double y) { Q_EMIT TappedAt(this->PointAt(x, y)); });
}

Vector3 SlicePane::PointAt(double x, double y) const
{
  Vector3 point;
  this->Slice->DisplayToWorld(x, y, point.data());
  return point;
}

void SlicePane::TellAim()
{
  Q_EMIT Aimed(Vector3(this->Style->GetPointerWorld()));
}

void SlicePane::TellHand()
{
  Q_EMIT HandMoved(Vector3(this->Style->GetPointerWorld()));
}

void SlicePane::ShowPlace(const Vector3& pointWorld)
{
  this->Slice->ShowPoint(pointWorld.data());
  this->RequestRender();
}

void SlicePane::TellPoint()
{
  if (this->Pointer)
  {
    Q_EMIT PointedAt(this->PointAt(this->Pointer->x(), this->Pointer->y()));
  }
}

void SlicePane::SetStrokes(bool areOn)
{
  ViewPane::SetStrokes(areOn);
  this->ShowHand(false);
}

void SlicePane::SetNeurological(bool isNeurological)
{
  this->Slice->SetNeurological(isNeurological);
  this->RequestRender();
}

void SlicePane::ShowFields(const std::set<vtkVolume*>& fields)
{
  const std::set<vtkSmartPointer<vtkVolume>> next(fields.begin(), fields.end());
  if (next == this->Fields)
  {
    return;
  }
  for (const auto& field : this->Fields)
  {
    this->Slice->RemoveField(field);
    this->Unfollow(field);
  }
  for (const auto& field : next)
  {
    this->Slice->AddField(field);
    this->Follow(field);
  }
  this->Fields = next;
  this->RequestRender();
}

void SlicePane::FitToImage()
{
  this->Slice->FitToImage();
  this->RequestRender();
}

void SlicePane::ChooseSlice(int number)
{
  this->Slice->Scroll(number - this->Slice->GetSliceNumber());
}
} // namespace palpate
