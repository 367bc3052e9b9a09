#include "StructureMask.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

namespace palpate::cli
{
vtkSmartPointer<vtkImageData> MaskOf(const Segmentation& segmentation, const Segment& structure)
{
  vtkImageData* layer = segmentation.Layers[static_cast<std::size_t>(structure.Layer)];
  vtkDataArray* values = layer->GetPointData()->GetScalars();
  vtkNew<vtkUnsignedCharArray> inside;
  inside->SetNumberOfTuples(values->GetNumberOfTuples());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    inside->SetValue(i, values->GetComponent(i, 0) == structure.Value ? 1 : 0);
  }
  auto mask = vtkSmartPointer<vtkImageData>::New();
  mask->CopyStructure(layer);
  mask->GetPointData()->SetScalars(inside);
  return mask;
}
} // namespace palpate::cli
