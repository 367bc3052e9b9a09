#include "vtkModelReader.h"

#include "ExceptionMessage.h"
#include "ModelFile.h"
#include "ModelSurface.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <exception>

vtkStandardNewMacro(vtkModelReader);

namespace
{
void AddField(vtkPolyData* surface, const char* name, const double* values, int count)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(count);
  array->InsertNextTuple(values);
  surface->GetFieldData()->AddArray(array);
}
} // namespace

int vtkModelReader::CanReadFile(const char* name)
{
  try
  {
    palpate::ReadModel(name);
    return 1;
  }
  catch (const std::exception&)
  {
    return 0;
  }
}

int vtkModelReader::RequestData(vtkInformation*, vtkInformationVector**,
                                vtkInformationVector* outputs)
{
  try
  {
    const palpate::OrganModel model =
        palpate::ReadModel(this->FileName ? this->FileName : "").Surface;
    vtkPolyData* output = vtkPolyData::GetData(outputs);
    output->ShallowCopy(palpate::DrawModel(model, palpate::DrawnFrequency(model, this->Frequency)));
    const double degree = palpate::DegreeOf(model);
    AddField(output, "Degree", &degree, 1);
    AddField(output, "Center", palpate::CenterOf(model).data(), 3);
    return 1;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< palpate::MessageOf(error));
    return 0;
  }
}

void vtkModelReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
  os << indent << "Frequency: " << this->Frequency << '\n';
}
