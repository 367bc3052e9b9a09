#include "RenderedVolume.h"

#include "ReducedImage.h"

#include "vtkAutoInit.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

// Without it, the processor's ray caster cannot show what it drew either.
VTK_MODULE_INIT(vtkRenderingVolumeOpenGL2)

namespace palpate
{
namespace
{
// The image in a border of its least value. Without it, a body that the image cuts has no gradient
// there, and so would not be lit.
vtkSmartPointer<vtkImageData> InBorder(vtkImageData* image)
{
  std::array<int, 3> size{};
  image->GetDimensions(size.data());
  auto made = vtkSmartPointer<vtkImageData>::New();
  made->SetDimensions(size[0] + 2, size[1] + 2, size[2] + 2);
  made->SetSpacing(image->GetSpacing());
  made->SetDirectionMatrix(image->GetDirectionMatrix());
  const int* extent = image->GetExtent();
  double origin[3];
  image->TransformIndexToPhysicalPoint(extent[0] - 1, extent[2] - 1, extent[4] - 1, origin);
  made->SetOrigin(origin);
  made->AllocateScalars(image->GetScalarType(), 1);
  made->GetPointData()->GetScalars()->Fill(image->GetScalarRange()[0]);
  const auto row =
      static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(image->GetScalarSize());
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      std::memcpy(made->GetScalarPointer(1, j + 1, k + 1),
                  image->GetScalarPointer(extent[0], extent[2] + j, extent[4] + k), row);
    }
  }
  return made;
}

// VTK's ray casters ignore an image's direction, so it is that of the volume instead.
void PlaceInFrame(vtkImageData* image, vtkVolume* volume)
{
  vtkNew<vtkMatrix4x4> frame;
  const vtkMatrix3x3* direction = image->GetDirectionMatrix();
  const double* origin = image->GetOrigin();
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      frame->SetElement(row, column, direction->GetElement(row, column));
    }
    frame->SetElement(row, 3, origin[row]);
  }
  volume->SetUserMatrix(frame);
  image->SetOrigin(0.0, 0.0, 0.0);
  vtkNew<vtkMatrix3x3> identity;
  image->SetDirectionMatrix(identity);
}

vtkSmartPointer<vtkVolumeMapper> MakeCardMapper()
{
  auto mapper = vtkSmartPointer<vtkGPUVolumeRayCastMapper>::New();
  mapper->LockSampleDistanceToInputSpacingOn();
  mapper->UseJitteringOn();
  return mapper;
}

vtkSmartPointer<vtkFixedPointVolumeRayCastMapper> MakeProcessorMapper()
{
  auto mapper = vtkSmartPointer<vtkFixedPointVolumeRayCastMapper>::New();
  mapper->LockSampleDistanceToInputSpacingOn();
  mapper->IntermixIntersectingGeometryOn();
  return mapper;
}

void SetMaterial(vtkVolumeProperty* property, double diagonal)
{
  constexpr double StepsAcross = 150.0;
  property->SetInterpolationTypeToLinear();
  property->SetScalarOpacityUnitDistance(diagonal / StepsAcross);
  property->ShadeOn();
  property->SetAmbient(0.25);
  property->SetDiffuse(0.75);
  property->SetSpecular(0.15);
  property->SetSpecularPower(12.0);
}
} // namespace

RenderedVolume::RenderedVolume(vtkImageData* image, bool usesCard)
    : Shown(vtkSmartPointer<vtkVolume>::New())
{
  const vtkSmartPointer<vtkImageData> own = InBorder(ReducedImage(image, MostVoxels));
  PlaceInFrame(own, this->Shown);
  SetMaterial(this->Shown->GetProperty(), own->GetLength());
  if (usesCard)
  {
    this->Mapper = MakeCardMapper();
    this->Mapper->SetInputData(own);
    this->Shown->SetMapper(this->Mapper);
    return;
  }
  const vtkSmartPointer<vtkFixedPointVolumeRayCastMapper> mapper = MakeProcessorMapper();
  this->Mapper = mapper;
  mapper->SetInputData(own);
  this->Shown->SetMapper(mapper);
  // Gradients and ranges of blocks, which are kept for the frames; they depend on no renderer.
  vtkNew<vtkRenderer> anyRenderer;
  mapper->PerVolumeInitialization(anyRenderer, this->Shown);
}

RenderedVolume::~RenderedVolume() = default;

void RenderedVolume::Show(VolumePreset preset, double window, double level)
{
  if (this->Last && this->Last->Preset == preset && this->Last->Window == window &&
      this->Last->Level == level)
  {
    return;
  }
  this->Last = Look{preset, window, level};
  vtkNew<vtkColorTransferFunction> colors;
  vtkNew<vtkPiecewiseFunction> opacities;
  for (const VolumeShade& shade : ShadesOf(preset))
  {
    const double value = level + (shade.Share - 0.5) * window;
    colors->AddRGBPoint(value, shade.Color[0], shade.Color[1], shade.Color[2]);
    opacities->AddPoint(value, shade.Opacity);
  }
  vtkVolumeProperty* property = this->Shown->GetProperty();
  property->SetColor(colors);
  property->SetScalarOpacity(opacities);
  const bool isMaximum = preset == VolumePreset::MaximumIntensity;
  property->SetShade(isMaximum ? 0 : 1);
  this->Mapper->SetBlendMode(isMaximum ? vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND
                                       : vtkVolumeMapper::COMPOSITE_BLEND);
  this->Shown->Modified(); // views check its modification time
}

void RenderedVolume::LimitRays(int width, int height, double rays)
{
  if (auto* mapper = vtkFixedPointVolumeRayCastMapper::SafeDownCast(this->Mapper))
  {
    const double pixels = 1.0 * width * height;
    mapper->SetMinimumImageSampleDistance(
        static_cast<float>(std::max(1.0, std::sqrt(pixels / rays))));
  }
}
} // namespace palpate
