// ITK has headers of an Eigen of its own: this file is compiled alone.
#include "ImageRegistration.h"

#include "InputError.h"
#include "ItkCompiler.h"
#include "ItkMapRows.h"

#include "vtkDataArray.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"

#include "itkAffineTransform.h"
#include "itkCommand.h"
#include "itkImage.h"
#include "itkImageRegistrationMethodv4.h"
#include "itkMattesMutualInformationImageToImageMetricv4.h"
#include "itkRegistrationParameterScalesFromPhysicalShift.h"
#include "itkRegularStepGradientDescentOptimizerv4.h"
#include "itkSimilarity3DTransform.h"
#include "itkVersorRigid3DTransform.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
using Image = itk::Image<float, 3>;
using Metric = itk::MattesMutualInformationImageToImageMetricv4<Image, Image>;
using Optimizer = itk::RegularStepGradientDescentOptimizerv4<double>;
using Scales = itk::RegistrationParameterScalesFromPhysicalShift<Metric>;
using Linear = itk::MatrixOffsetTransformBase<double, 3, 3>;
using Method = itk::ImageRegistrationMethodv4<Image, Image, Linear>;
using Affine = itk::AffineTransform<double, 3>;

constexpr int Levels = 3;
constexpr int MostSteps = 200; // of a level
constexpr double Samples = 50000.0;
constexpr unsigned Bins = 32;

Image::Pointer ImageOf(vtkImageData* image)
{
  const auto made = Image::New();
  Image::RegionType region;
  Image::SpacingType spacing;
  Image::PointType origin;
  Image::DirectionType direction;
  for (int axis = 0; axis < 3; ++axis)
  {
    region.SetSize(axis, static_cast<itk::SizeValueType>(image->GetDimensions()[axis]));
    spacing[axis] = image->GetSpacing()[axis];
    origin[axis] = image->GetOrigin()[axis];
    for (int row = 0; row < 3; ++row)
    {
      direction(row, axis) = image->GetDirectionMatrix()->GetElement(row, axis);
    }
  }
  made->SetRegions(region);
  made->SetSpacing(spacing);
  made->SetOrigin(origin);
  made->SetDirection(direction);
  made->Allocate();
  vtkDataArray* values = image->GetPointData()->GetScalars();
  float* to = made->GetBufferPointer();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double value = values->GetComponent(i, 0);
    to[i] = std::isfinite(value) ? static_cast<float>(value) : 0.0F;
  }
  return made;
}

Linear::Pointer TransformOf(const ImageRegistrationSettings& settings)
{
  if (settings.IsAffine)
  {
    return Affine::New().GetPointer();
  }
  return settings.ChangesSize ? Linear::Pointer(itk::Similarity3DTransform<double>::New())
                              : Linear::Pointer(itk::VersorRigid3DTransform<double>::New());
}

Affine::Pointer TransformOf(const MapRows& rows)
{
  const auto transform = Affine::New();
  Affine::MatrixType matrix;
  Affine::OutputVectorType shift;
  for (unsigned row = 0; row < 3; ++row)
  {
    for (unsigned column = 0; column < 3; ++column)
    {
      matrix(row, column) = rows[row][column];
    }
    shift[row] = rows[row][3];
  }
  transform->SetMatrix(matrix);
  transform->SetOffset(shift);
  return transform;
}

Image::PointType MiddleOf(const Image& image)
{
  itk::ContinuousIndex<double, 3> middle;
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    middle[axis] = 0.5 * (static_cast<double>(image.GetBufferedRegion().GetSize(axis)) - 1.0);
  }
  Image::PointType point;
  image.TransformContinuousIndexToPhysicalPoint(middle, point);
  return point;
}

// One registration with all its parts of ITK.
class MutualInformation
{
public:
  MutualInformation(vtkImageData* moving, vtkImageData* fixed,
                    const ImageRegistrationSettings& settings)
      : Fixed(ImageOf(fixed)), Transform(TransformOf(settings)),
        Start(TransformOf(settings.StartBack))
  {
    this->Transform->SetIdentity();
    this->Transform->SetCenter(MiddleOf(*this->Fixed));
    const auto metric = Metric::New();
    metric->SetNumberOfHistogramBins(Bins);
    metric->SetUseMovingImageGradientFilter(false);
    metric->SetUseFixedImageGradientFilter(false);
    const auto scales = Scales::New();
    scales->SetMetric(metric);
    scales->SetTransformForward(true);
    this->Steps->SetScalesEstimator(scales);
    this->Steps->SetNumberOfIterations(MostSteps);
    this->Steps->SetDoEstimateLearningRateOnce(true);
    this->Steps->SetMinimumStepLength(1e-4);
    this->Steps->SetRelaxationFactor(0.6);
    this->Steps->SetReturnBestParametersAndValue(true);
    this->Run->SetFixedImage(this->Fixed);
    this->Run->SetMovingImage(ImageOf(moving));
    this->Run->SetMovingInitialTransform(this->Start);
    this->Run->SetInitialTransform(this->Transform);
    this->Run->InPlaceOn();
    this->Run->SetMetric(metric);
    this->Run->SetOptimizer(this->Steps);
    this->SetLevels();
  }

  std::optional<ImageRegistration> Find(const KernelProgress& progress)
  {
    ImageRegistration found;
    const auto watch = itk::SimpleMemberCommand<MutualInformation>::New();
    watch->SetCallbackFunction(this, &MutualInformation::Watch);
    this->Steps->AddObserver(itk::IterationEvent(), watch);
    this->Progress = &progress;
    try
    {
      this->Run->Update();
    }
    catch (const Stopped&)
    {
      return {};
    }
    catch (const itk::ExceptionObject&)
    {
      throw InputError("the images hardly overlap where the registration starts, or one of them "
                       "has a single value; start it closer, by landmarks or --initial");
    }
    const auto whole = Affine::New();
    whole->SetMatrix(this->Transform->GetMatrix());
    whole->SetOffset(this->Transform->GetOffset());
    whole->Compose(this->Start); // after it
    found.Back = RowsOf(*whole);
    found.InformationBefore = -this->First;
    found.InformationAfter = -this->Steps->GetCurrentMetricValue();
    found.Steps = this->Count;
    return found;
  }

private:
  struct Stopped
  {
  };

  // Voxels of about equal sides, four, two and one times as large as the smallest side or, of large
  // images, a 128th of the longest.
  void SetLevels()
  {
    const Image::SpacingType spacing = this->Fixed->GetSpacing();
    const auto size = this->Fixed->GetBufferedRegion().GetSize();
    double finest = *std::min_element(spacing.Begin(), spacing.End());
    double voxels = 1.0;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      finest = std::max(finest, spacing[axis] * static_cast<double>(size[axis]) / 128.0);
      voxels *= static_cast<double>(size[axis]);
    }
    this->Run->SetNumberOfLevels(Levels);
    Method::SmoothingSigmasArrayType sigmas(Levels);
    Method::MetricSamplingPercentageArrayType parts(Levels);
    for (unsigned level = 0; level < Levels; ++level)
    {
      const double side = finest * (1U << (Levels - 1 - level));
      Method::ShrinkFactorsPerDimensionContainerType shrink;
      double kept = voxels;
      for (unsigned axis = 0; axis < 3; ++axis)
      {
        const double factor = std::clamp(std::round(side / spacing[axis]), 1.0,
                                         std::max(1.0, static_cast<double>(size[axis]) / 24.0));
        shrink[axis] = static_cast<unsigned>(factor);
        kept /= shrink[axis];
      }
      this->Run->SetShrinkFactorsPerDimension(level, shrink);
      sigmas[level] = level + 1 < Levels ? 0.5 * side : 0.0;
      parts[level] = std::min(1.0, Samples / kept);
    }
    this->Run->SetSmoothingSigmasPerLevel(sigmas);
    this->Run->SetSmoothingSigmasAreSpecifiedInPhysicalUnits(true);
    this->Run->SetMetricSamplingStrategy(Method::MetricSamplingStrategyEnum::RANDOM);
    this->Run->SetMetricSamplingPercentagePerLevel(parts);
    this->Run->MetricSamplingReinitializeSeed(1);
    this->Steps->SetMaximumStepSizeInPhysicalUnits(finest);
  }

  void Watch()
  {
    const auto level = static_cast<double>(this->Run->GetCurrentLevel());
    const auto step = static_cast<double>(this->Steps->GetCurrentIteration());
    ++this->Count;
    if (level + 1.0 >= Levels && step < 0.5)
    {
      this->First = this->Steps->GetCurrentMetricValue();
    }
    if (*this->Progress && !(*this->Progress)((level + step / MostSteps) / Levels))
    {
      throw Stopped();
    }
  }

  Image::Pointer Fixed;
  Linear::Pointer Transform;
  Affine::Pointer Start; // from the fixed image, where Transform takes it, to the moving one
  Optimizer::Pointer Steps = Optimizer::New();
  Method::Pointer Run = Method::New();
  const KernelProgress* Progress = nullptr;
  double First = 0.0;
  int Count = 0;
};
} // namespace

std::optional<ImageRegistration> RegisterImages(vtkImageData* moving, vtkImageData* fixed,
                                                const ImageRegistrationSettings& settings,
                                                const KernelProgress& progress)
{
  return MutualInformation(moving, fixed, settings).Find(progress);
}
} // namespace palpate
