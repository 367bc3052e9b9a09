#include "OutputImageInformation.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationIntegerVectorKey.h"
#include "vtkMatrix3x3.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace palpate
{
void DescribeOutput(vtkImageData* image, vtkInformation* output)
{
  output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), image->GetExtent(), 6);
  output->Set(vtkDataObject::SPACING(), image->GetSpacing(), 3);
  output->Set(vtkDataObject::ORIGIN(), image->GetOrigin(), 3);
  output->Set(vtkDataObject::DIRECTION(), image->GetDirectionMatrix()->GetData(), 9);
  vtkDataObject::SetPointDataActiveScalarInfo(output, image->GetScalarType(), 1);
}
} // namespace palpate
