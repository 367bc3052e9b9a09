#include "vtkSubVoxelRepresentation.h"

#include "vtkSubVoxelVolume.h"
#include "vtkSubVoxelVolumeMapper.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

vtkStandardNewMacro(vtkSubVoxelRepresentation);

vtkSubVoxelRepresentation::vtkSubVoxelRepresentation()
{
  this->Mapper->SetNumberOfIsoValues(1);
  this->Property->ShadeOn();
  this->Volume->SetMapper(this->Mapper);
  this->Volume->SetProperty(this->Property);
}

vtkSubVoxelRepresentation::~vtkSubVoxelRepresentation() = default;

void vtkSubVoxelRepresentation::SetIsoValue(double value)
{
  this->Mapper->SetIsoValue(0, value);
}

void vtkSubVoxelRepresentation::SetInterpolation(int interpolation)
{
  this->Mapper->SetInterpolation(interpolation);
}

void vtkSubVoxelRepresentation::SetSurfaceColor(double red, double green, double blue)
{
  this->Mapper->SetMaterialColor(0, red, green, blue);
}

void vtkSubVoxelRepresentation::SetSurfaceOpacity(double opacity)
{
  this->Mapper->SetMaterialOpacity(0, opacity);
}

void vtkSubVoxelRepresentation::SetSpecular(double specular)
{
  this->Property->SetSpecular(specular);
}

void vtkSubVoxelRepresentation::SetVisibility(bool isVisible)
{
  this->Superclass::SetVisibility(isVisible);
  this->Volume->SetVisibility(isVisible);
}

int vtkSubVoxelRepresentation::ProcessViewRequest(vtkInformationRequestKey* request,
                                                  vtkInformation* input, vtkInformation* output)
{
  if (!this->Superclass::ProcessViewRequest(request, input, output))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    vtkPVRenderView::SetPiece(input, this, this->Image);
    if (this->Image != nullptr)
    {
      vtkPVRenderView::SetGeometryBounds(input, this, this->Image->GetBounds());
    }
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    this->Mapper->SetInputConnection(vtkPVRenderView::GetPieceProducer(input, this));
  }
  return 1;
}

int vtkSubVoxelRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkSubVoxelRepresentation::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                           vtkInformationVector* outputs)
{
  this->Image = nullptr;
  if (inputs[0]->GetNumberOfInformationObjects() == 1)
  {
    this->Image = vtkSmartPointer<vtkImageData>::New();
    this->Image->ShallowCopy(vtkImageData::GetData(inputs[0]));
  }
  return this->Superclass::RequestData(request, inputs, outputs);
}

bool vtkSubVoxelRepresentation::AddToView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (renderView == nullptr)
  {
    return false;
  }
  renderView->GetRenderer()->AddVolume(this->Volume);
  return this->Superclass::AddToView(view);
}

bool vtkSubVoxelRepresentation::RemoveFromView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (renderView == nullptr)
  {
    return false;
  }
  renderView->GetRenderer()->RemoveVolume(this->Volume);
  return this->Superclass::RemoveFromView(view);
}

void vtkSubVoxelRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mapper:\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
