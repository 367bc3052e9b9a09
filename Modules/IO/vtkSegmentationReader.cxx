#include "vtkSegmentationReader.h"

#include "ExceptionMessage.h"
#include "OutputImageInformation.h"
#include "SegmentationFile.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <optional>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSegmentationReader);

struct vtkSegmentationReader::ReadState
{
  palpate::Segmentation Segmentation;
  std::vector<std::string> Remarks;
  std::optional<std::string> FileName; ///< of the file that was read
  bool RefuseLeftHanded = false;       ///< when it was read

  const palpate::Segment* Find(int index) const
  {
    const auto& segments = this->Segmentation.Segments;
    const bool exists = index >= 0 && index < static_cast<int>(segments.size());
    return exists ? &segments[static_cast<std::size_t>(index)] : nullptr;
  }
};

vtkSegmentationReader::vtkSegmentationReader() : State(std::make_unique<ReadState>())
{
  this->SetNumberOfInputPorts(0);
}

vtkSegmentationReader::~vtkSegmentationReader()
{
  this->SetFileName(nullptr);
}

int vtkSegmentationReader::GetNumberOfLayers()
{
  return static_cast<int>(this->State->Segmentation.Layers.size());
}

int vtkSegmentationReader::GetNumberOfSegments()
{
  return static_cast<int>(this->State->Segmentation.Segments.size());
}

int vtkSegmentationReader::GetSegmentLabel(int index)
{
  const palpate::Segment* segment = this->State->Find(index);
  return segment ? segment->Label : -1;
}

int vtkSegmentationReader::GetSegmentValue(int index)
{
  const palpate::Segment* segment = this->State->Find(index);
  return segment ? segment->Value : -1;
}

int vtkSegmentationReader::GetSegmentLayer(int index)
{
  const palpate::Segment* segment = this->State->Find(index);
  return segment ? segment->Layer : -1;
}

const char* vtkSegmentationReader::GetSegmentName(int index)
{
  const palpate::Segment* segment = this->State->Find(index);
  return segment ? segment->Name.c_str() : nullptr;
}

void vtkSegmentationReader::GetSegmentColor(int index, double color[3])
{
  const palpate::Segment* segment = this->State->Find(index);
  for (std::size_t channel = 0; channel < 3; ++channel)
  {
    color[channel] = segment ? segment->Color[channel] : 0.5;
  }
}

int vtkSegmentationReader::GetNumberOfNotes()
{
  return static_cast<int>(this->State->Remarks.size());
}

const char* vtkSegmentationReader::GetNote(int index)
{
  const auto& notes = this->State->Remarks;
  const bool exists = index >= 0 && index < static_cast<int>(notes.size());
  return exists ? notes[static_cast<std::size_t>(index)].c_str() : nullptr;
}

bool vtkSegmentationReader::ReadFile()
{
  const std::string name = this->FileName ? this->FileName : "";
  if (this->State->FileName == name && this->State->RefuseLeftHanded == this->RefuseLeftHanded)
  {
    return true;
  }
  *this->State = {};
  try
  {
    this->State->Segmentation =
        palpate::ReadSegmentation(name, this->RefuseLeftHanded ? palpate::LeftHandedAxes::Refuse
                                                               : palpate::LeftHandedAxes::Reverse);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< palpate::MessageOf(error));
    return false;
  }
  this->State->Remarks = this->State->Segmentation.Remarks();
  for (const auto& layer : this->State->Segmentation.Layers)
  {
    // ParaView shows named arrays only.
    layer->GetPointData()->GetScalars()->SetName("Labels");
  }
  this->State->FileName = name;
  this->State->RefuseLeftHanded = this->RefuseLeftHanded;
  return true;
}

int vtkSegmentationReader::RequestInformation(vtkInformation*, vtkInformationVector**,
                                              vtkInformationVector* outputs)
{
  if (!this->ReadFile())
  {
    return 0;
  }
  if (this->Layer < 0 || this->Layer >= this->GetNumberOfLayers())
  {
    vtkErrorMacro(<< this->FileName << " has no layer " << this->Layer << "; choose one from 0 to "
                  << this->GetNumberOfLayers() - 1 << ".");
    return 0;
  }
  palpate::DescribeOutput(this->State->Segmentation.Layers[static_cast<std::size_t>(this->Layer)],
                          outputs->GetInformationObject(0));
  return 1;
}

int vtkSegmentationReader::RequestData(vtkInformation*, vtkInformationVector**,
                                       vtkInformationVector* outputs)
{
  vtkImageData::GetData(outputs)->ShallowCopy(
      this->State->Segmentation.Layers[static_cast<std::size_t>(this->Layer)]);
  this->UpdateProgress(1.0);
  return 1;
}

void vtkSegmentationReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
  os << indent << "RefuseLeftHanded: " << this->RefuseLeftHanded << '\n';
  os << indent << "Layer: " << this->Layer << '\n';
  os << indent << "Layers: " << this->GetNumberOfLayers() << '\n';
  os << indent << "Segments: " << this->GetNumberOfSegments() << '\n';
}
