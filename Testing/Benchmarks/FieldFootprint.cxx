#include "FieldFootprint.h"

#include "FieldSampler.h"
#include "SkullPhantom.h"

#include "vtkImageBSplineCoefficients.h"
#include "vtkImageCast.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkShortArray.h"

#include <chrono>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace palpate::bench
{
namespace
{
template <typename Run>
double FootprintSeconds(const Run& run)
{
  const auto start = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The samples are shared, not copied.
vtkSmartPointer<vtkImageData> ImageOf(SkullPhantom& skull)
{
  vtkNew<vtkShortArray> scalars;
  scalars->SetArray(skull.Samples.data(), static_cast<vtkIdType>(skull.Samples.size()), 1);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(skull.Grid.Size().data());
  image->GetPointData()->SetScalars(scalars);
  return image;
}

double SecondsOfDense(vtkImageData* image, FieldInterpolation interpolation)
{
  vtkNew<vtkImageCast> cast;
  cast->SetOutputScalarTypeToFloat();
  vtkNew<vtkImageBSplineCoefficients> coefficients;
  vtkImageAlgorithm* filter = cast;
  if (interpolation == FieldInterpolation::TricubicBSpline)
  {
    filter = coefficients;
  }
  filter->SetInputDataObject(image);
  return FootprintSeconds([filter] { filter->Update(); });
}

void CheckAnswers(const SkullPhantom& skull, const std::shared_ptr<const ScalarField>& field)
{
  const FieldSampler sampler(field);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    for (const double side : {-1.0, 1.0})
    {
      const Vector3 direction = side * Vector3::Unit(axis);
      const Vector3 bone = skull.PointInBoneWorld(direction);
      if (!sampler.IsInsideWorld(0, bone) || sampler.IsInsideWorld(0, bone + 8.0 * direction))
      {
        throw std::runtime_error("a field of the phantom does not tell bone from air");
      }
    }
  }
}

FieldFootprintRow MakeFootprintRow(SkullPhantom& skull, FieldInterpolation interpolation)
{
  FieldFootprintRow row{};
  row.Nodes = skull.Grid.Size()[0];
  row.Interpolation = interpolation;
  row.DenseBytes = sizeof(float) * skull.Samples.size();
  row.DenseBuildSeconds = SecondsOfDense(ImageOf(skull), interpolation);
  std::shared_ptr<const ScalarField> field;
  row.BuildSeconds = FootprintSeconds([&] { field = skull.MakeField(interpolation); });
  CheckAnswers(skull, field);
  row.Bytes = field->Bytes();
  row.StoredPart = static_cast<double>(field->Channel(0).BlockCount()) /
                   static_cast<double>(field->Layout().BrickCount());
  return row;
}
} // namespace

std::vector<FieldFootprintRow> FieldFootprints()
{
  std::vector<FieldFootprintRow> rows;
  for (const int nodes : {128, 192, 256, 384, 512})
  {
    SkullPhantom skull(nodes);
    rows.push_back(MakeFootprintRow(skull, FieldInterpolation::Trilinear));
    rows.push_back(MakeFootprintRow(skull, FieldInterpolation::TricubicBSpline));
  }
  return rows;
}

std::string ToMarkdown(const std::vector<FieldFootprintRow>& rows)
{
  constexpr double Mega = 1e6;
  std::ostringstream text;
  text << "| nodes | interpolation | bricks stored | field, MB | dense floats, MB | part | built "
          "in, s | dense built in, s |\n|---|---|---|---|---|---|---|---|\n";
  text << std::fixed;
  for (const FieldFootprintRow& row : rows)
  {
    const bool isCubic = row.Interpolation == FieldInterpolation::TricubicBSpline;
    text << "| " << row.Nodes << "³ | " << (isCubic ? "tricubic" : "trilinear")
         << std::setprecision(1) << " | " << 100.0 * row.StoredPart << " % | "
         << static_cast<double>(row.Bytes) / Mega << " | "
         << static_cast<double>(row.DenseBytes) / Mega << " | "
         << 100.0 * static_cast<double>(row.Bytes) / static_cast<double>(row.DenseBytes) << " % | "
         << std::setprecision(2) << row.BuildSeconds << " | " << row.DenseBuildSeconds << " |\n";
  }
  return text.str();
}
} // namespace palpate::bench
