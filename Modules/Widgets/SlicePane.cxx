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
  this->Slice->SetImageDisplay(contents.Images());
  this->Slice->SetCrosshair(contents.Crosshair());
  this->Slice->SetLandmarks(contents.Landmarks());
  this->Slice->SetProbe(contents.Probe());
  this->Slice->SetWorkspace(contents.Workspace());
  this->Slice->SetRenderer(this->Renderer());
  this->Style->AddView(this->Slice);
  this->SetStyle(this->Style);
  this->Follow(contents.Images());
  this->Follow(contents.Crosshair());
  this->Follow(contents.Landmarks());
  this->Follow(contents.Probe());
  this->Follow(contents.Workspace());
  connect(this, &ViewPane::Rendered, this,
          [this] {
            this->Header()->ShowSlice(this->Slice->GetSliceNumber(),
                                      this->Slice->GetNumberOfSlices());
          });
  connect(this->Header(), &ViewHeader::SliceChosen, this, &SlicePane::ChooseSlice);
  connect(this, &ViewPane::PointerMoved, this,
          [this](double x, double y) { Q_EMIT PointedAt(this->PointAt(x, y)); });
  connect(this, &ViewPane::Clicked, this,
          [this](double x, double y) { Q_EMIT ClickedAt(this->PointAt(x, y)); });
}

Vector3 SlicePane::PointAt(double x, double y) const
{
  Vector3 point;
  this->Slice->DisplayToWorld(x, y, point.data());
  return point;
}

void SlicePane::AddSurface(vtkSurfaceDisplay* surface)
{
  this->Slice->AddSurface(surface);
  this->Follow(surface);
}

void SlicePane::RemoveSurface(vtkSurfaceDisplay* surface)
{
  this->Slice->RemoveSurface(surface);
  this->Unfollow(surface);
}

void SlicePane::SetAlongImage(bool isAlongImage)
{
  this->Slice->SetAlongImage(isAlongImage);
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
