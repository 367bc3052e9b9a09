#include "ImageFile.h"

#include "AvailableMemory.h"
#include "DecimalText.h"
#include "Refusal.h"

namespace palpate
{
double ImageFile::DataBytes() const
{
  return static_cast<double>(this->FileGrid.VoxelCount()) * this->Components() *
         vtkDataArray::GetDataTypeSize(this->ScalarType());
}

void ImageFile::ChooseVolume(const std::string& number)
{
  const std::int64_t count = this->VolumeCount();
  if (count == 1)
  {
    return;
  }
  const int chosen = ParseInteger(number).value_or(0);
  if (chosen < 1 || chosen > count)
  {
    Refuse(this->File,
           "holds " + std::to_string(count) + " volumes" +
               (number.empty() ? "" : ", but none of this number"),
           "choose one by its number, from 1 to " + std::to_string(count) +
               " (--series), or convert it to a file of one volume first");
  }
  this->ChosenVolume = chosen - 1;
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
