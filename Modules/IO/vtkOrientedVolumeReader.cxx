#include "vtkOrientedVolumeReader.h"

#include "OutputImageInformation.h"
#include "VolumeFile.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTimeStamp.h"

vtkStandardNewMacro(vtkOrientedVolumeReader);

struct vtkOrientedVolumeReader::ReadState
{
  palpate::Volume Volume;
  vtkTimeStamp ReadTime;
};

vtkOrientedVolumeReader::vtkOrientedVolumeReader() : State(std::make_unique<ReadState>())
{
  this->SetNumberOfInputPorts(0);
}

vtkOrientedVolumeReader::~vtkOrientedVolumeReader()
{
  this->SetFileName(nullptr);
  this->SetSeries(nullptr);
}

int vtkOrientedVolumeReader::GetNumberOfNotes()
{
  return static_cast<int>(this->State->Volume.Notes.size());
}

const char* vtkOrientedVolumeReader::GetNote(int index)
{
  const auto& notes = this->State->Volume.Notes;
  const bool exists = index >= 0 && index < static_cast<int>(notes.size());
  return exists ? notes[static_cast<std::size_t>(index)].c_str() : nullptr;
}

int vtkOrientedVolumeReader::RequestInformation(vtkInformation*, vtkInformationVector**,
                                                vtkInformationVector* outputs)
{
  if (!this->State->Volume.Image || this->State->ReadTime < this->GetMTime())
  {
    this->State->Volume = {};
    try
    {
      this->State->Volume =
          palpate::ReadVolume(this->FileName ? this->FileName : "",
                              {this->Series ? this->Series : "",
                               this->RefuseLeftHanded ? palpate::LeftHandedAxes::Refuse
                                                      : palpate::LeftHandedAxes::Reverse});
    }
    catch (const std::exception& error)
    {
      vtkErrorMacro(<< error.what());
      return 0;
    }
    this->State->ReadTime.Modified();
  }
  palpate::DescribeOutput(this->State->Volume.Image, outputs->GetInformationObject(0));
  return 1;
}

int vtkOrientedVolumeReader::RequestData(vtkInformation*, vtkInformationVector**,
                                         vtkInformationVector* outputs)
{
  vtkImageData::GetData(outputs)->ShallowCopy(this->State->Volume.Image);
  this->UpdateProgress(1.0);
  return 1;
}

void vtkOrientedVolumeReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
  os << indent << "Series: " << (this->Series ? this->Series : "(none)") << '\n';
  os << indent << "RefuseLeftHanded: " << this->RefuseLeftHanded << '\n';
  os << indent << "Notes: " << this->GetNumberOfNotes() << '\n';
}
