#include "vtkPatientVolumeReader.h"

#include "ExceptionMessage.h"
#include "OutputImageInformation.h"
#include "VolumeFile.h"

#include "vtkDataArray.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <exception>

vtkStandardNewMacro(vtkPatientVolumeReader);

int vtkPatientVolumeReader::RequestInformation(vtkInformation*, vtkInformationVector**,
                                               vtkInformationVector* outputs)
{
  if (this->Read == nullptr || this->ReadTime < this->GetMTime())
  {
    this->Read = nullptr;
    try
    {
      palpate::VolumeChoice choice;
      choice.Series = this->Series;
      this->Read = palpate::ReadVolume(this->FileName ? this->FileName : "", choice).Image;
    }
    catch (const std::exception& error)
    {
      vtkErrorMacro(<< palpate::MessageOf(error));
      return 0;
    }
    this->Read->GetPointData()->GetScalars()->SetName("Values");
    this->ReadTime.Modified();
  }
  palpate::DescribeOutput(this->Read, outputs->GetInformationObject(0));
  return 1;
}

int vtkPatientVolumeReader::RequestData(vtkInformation*, vtkInformationVector**,
                                        vtkInformationVector* outputs)
{
  vtkImageData::GetData(outputs)->ShallowCopy(this->Read);
  return 1;
}

void vtkPatientVolumeReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
  os << indent << "Series: " << this->Series << '\n';
}
