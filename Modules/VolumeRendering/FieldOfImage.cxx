#include "FieldOfImage.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"

#include <optional>

namespace palpate
{
namespace
{
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>; // as VTK's matrices

std::optional<ScalarType> TypeOf(vtkDataArray* scalars)
{
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(return ScalarTypeOf<VTK_TT>());
  }
  return std::nullopt;
}
} // namespace

FieldGrid GridOfImage(vtkImageData* image)
{
  const int* extent = image->GetExtent();
  std::array<int, 3> size{};
  image->GetDimensions(size.data());
  const Matrix3 direction = Eigen::Map<const RowMajor>(image->GetDirectionMatrix()->GetData());
  Vector3 origin;
  image->TransformIndexToPhysicalPoint(extent[0], extent[2], extent[4], origin.data());
  return {size, origin, Vector3(image->GetSpacing()), direction};
}

vtkSmartPointer<vtkImageData> EmptyImageOf(const FieldGrid& grid)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(grid.Size().data());
  image->SetSpacing(grid.Spacing().data());
  image->SetOrigin(grid.OriginWorld().data());
  image->SetDirectionMatrix(RowMajor(grid.Direction()).data());
  return image;
}

Status SamplesOfImage(vtkImageData* image, FieldSamples& samples)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (scalars == nullptr || scalars->GetNumberOfComponents() != 1)
  {
    return Status::Failure("The image needs scalars of one component.");
  }
  const std::optional<ScalarType> type = TypeOf(scalars);
  if (!type || !scalars->HasStandardMemoryLayout())
  {
    return Status::Failure("The image has an unsupported scalar type.");
  }
  std::array<int, 3> size{};
  image->GetDimensions(size.data());
  samples = {scalars->GetVoidPointer(0), *type, {0, 0, 0}, size, 0.0};
  return Status::Success();
}

Status BuildFieldOfImage(vtkImageData* image, const std::vector<double>& isoValues,
                         const FieldForm& form, const FieldBuilder::Progress& progress,
                         std::shared_ptr<const ScalarField>& field)
{
  FieldSamples samples;
  if (Status status = SamplesOfImage(image, samples); !status.IsOk())
  {
    return status;
  }
  FieldBuilder builder(GridOfImage(image));
  builder.SetForm(form);
  const int channel = builder.AddChannel(samples);
  for (const double iso : isoValues)
  {
    builder.AddMaterial({channel, iso, FieldSense::AtLeast});
  }
  return builder.Build(field, progress);
}
} // namespace palpate
