#include "ImageFile.h"

#include "AvailableMemory.h"

namespace palpate
{
double ImageFile::DataBytes() const
{
  return static_cast<double>(this->FileGrid.VoxelCount()) * this->Components() *
         vtkDataArray::GetDataTypeSize(this->ScalarType());
}

vtkSmartPointer<vtkDataArray> ImageFile::NewArray() const
{
  auto array =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(this->ScalarType()));
  this->CheckLength();
  CheckMemory(this->File, this->DataBytes());
  array->SetNumberOfComponents(this->Components());
  array->SetNumberOfTuples(this->FileGrid.VoxelCount());
  return array;
}
} // namespace palpate
