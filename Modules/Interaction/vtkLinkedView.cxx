#include "vtkLinkedView.h"

#include "vtkCrosshair.h"
#include "vtkImageDisplay.h"
#include "vtkLandmarks.h"
#include "vtkProbeRepresentation.h"

#include "vtkCommand.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

struct vtkLinkedView::Shared
{
  vtkSmartPointer<vtkRenderer> Renderer;
  unsigned long Observer = 0;
  vtkSmartPointer<vtkImageDisplay> Display;
  vtkSmartPointer<vtkCrosshair> Crosshair;
  vtkSmartPointer<vtkLandmarks> Landmarks;
  vtkSmartPointer<vtkProbeRepresentation> Probe;
};

vtkLinkedView::vtkLinkedView() : Given(std::make_unique<Shared>()) {}

vtkLinkedView::~vtkLinkedView() = default;

void vtkLinkedView::SetRenderer(vtkRenderer* renderer)
{
  Shared& given = *this->Given;
  if (given.Renderer == renderer)
  {
    return;
  }
  if (given.Renderer != nullptr)
  {
    given.Renderer->RemoveObserver(given.Observer);
    this->RemoveFrom(given.Renderer);
  }
  given.Renderer = renderer;
  if (renderer != nullptr)
  {
    given.Observer = renderer->AddObserver(vtkCommand::StartEvent, this, &vtkLinkedView::Update);
    this->AddTo(renderer);
  }
  this->Modified();
}

vtkRenderer* vtkLinkedView::GetRenderer()
{
  return this->Given->Renderer;
}

void vtkLinkedView::SetImageDisplay(vtkImageDisplay* display)
{
  this->Given->Display = display;
  this->Modified();
}

vtkImageDisplay* vtkLinkedView::GetImageDisplay()
{
  return this->Given->Display;
}

void vtkLinkedView::SetCrosshair(vtkCrosshair* crosshair)
{
  this->Given->Crosshair = crosshair;
  this->Modified();
}

vtkCrosshair* vtkLinkedView::GetCrosshair()
{
  return this->Given->Crosshair;
}

void vtkLinkedView::SetLandmarks(vtkLandmarks* landmarks)
{
  this->Given->Landmarks = landmarks;
  this->Modified();
}

vtkLandmarks* vtkLinkedView::GetLandmarks()
{
  return this->Given->Landmarks;
}

void vtkLinkedView::SetProbe(vtkProbeRepresentation* probe)
{
  this->Given->Probe = probe;
  this->Modified();
}

vtkProbeRepresentation* vtkLinkedView::GetProbe()
{
  return this->Given->Probe;
}

void vtkLinkedView::Update()
{
  if (this->Given->Renderer != nullptr)
  {
    this->UpdateFor(this->Given->Renderer);
  }
}

void vtkLinkedView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Given->Renderer.Get() << '\n';
  os << indent << "AlongImage: " << this->AlongImage << '\n';
  os << indent << "AnnotationVisibility: " << this->AnnotationVisibility << '\n';
}
