#include "vtkLinkedView.h"

#include "LengthText.h"

#include "vtkCommand.h"

void vtkLinkedView::SetRenderer(vtkRenderer* renderer)
{
  if (this->Renderer == renderer)
  {
    return;
  }
  if (this->Renderer != nullptr)
  {
    this->Renderer->RemoveObserver(this->Observer);
    this->RemoveFrom(this->Renderer);
  }
  this->Renderer = renderer;
  if (renderer != nullptr)
  {
    this->Observer = renderer->AddObserver(vtkCommand::StartEvent, this, &vtkLinkedView::Update);
    this->AddTo(renderer);
  }
  this->Modified();
}

void vtkLinkedView::Update()
{
  if (this->Renderer != nullptr)
  {
    this->UpdateFor(this->Renderer);
  }
}

palpate::LengthUnit vtkLinkedView::UnitOfLength() const
{
  return this->Centimeters ? palpate::LengthUnit::Centimeter : palpate::LengthUnit::Millimeter;
}

void vtkLinkedView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer.Get() << '\n';
  os << indent << "AlongImage: " << this->AlongImage << '\n';
  os << indent << "AnnotationVisibility: " << this->AnnotationVisibility << '\n';
  os << indent << "Centimeters: " << this->Centimeters << '\n';
}
