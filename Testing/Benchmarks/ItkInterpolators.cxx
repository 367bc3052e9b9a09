#include "ItkCompiler.h"
#include "PeerLibraries.h"

#include <algorithm>
#include <itkBSplineInterpolateImageFunction.h>
#include <itkImage.h>
#include <itkLinearInterpolateImageFunction.h>

namespace palpate::bench
{
namespace
{
using Image = itk::Image<std::int16_t, 3>;

Image::Pointer MakeImage(const FieldGrid& grid, const std::vector<std::int16_t>& samples)
{
  auto image = Image::New();
  Image::SizeType size;
  Image::SpacingType spacing;
  Image::PointType origin;
  Image::DirectionType direction;
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    const int a = static_cast<int>(axis);
    size[axis] = static_cast<itk::SizeValueType>(grid.Size()[axis]);
    spacing[axis] = grid.Spacing()[a];
    origin[axis] = grid.OriginWorld()[a];
    for (unsigned row = 0; row < 3; ++row)
    {
      direction(row, axis) = grid.Direction()(static_cast<int>(row), a);
    }
  }
  image->SetRegions(size);
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->SetDirection(direction);
  image->Allocate();
  std::copy(samples.begin(), samples.end(), image->GetBufferPointer());
  return image;
}

template <typename Interpolator>
void AreInside(const Interpolator& interpolator, double iso,
               const std::vector<Vector3>& pointsWorld, std::vector<unsigned char>& inside)
{
  for (std::size_t p = 0; p < pointsWorld.size(); ++p)
  {
    const Image::PointType point(pointsWorld[p].data());
    inside[p] = interpolator->IsInsideBuffer(point) && interpolator->Evaluate(point) >= iso ? 1 : 0;
  }
}
class Interpolators final : public ItkInterpolators
{
public:
  Interpolators(const FieldGrid& grid, const std::vector<std::int16_t>& samples)
      : Volume(MakeImage(grid, samples))
  {
    this->Linear->SetInputImage(this->Volume);
    this->BSpline->SetSplineOrder(3);
    this->BSpline->SetInputImage(this->Volume);
  }

  void AreInsideLinear(double iso, const std::vector<Vector3>& pointsWorld,
                       std::vector<unsigned char>& inside) const override
  {
    AreInside(this->Linear, iso, pointsWorld, inside);
  }
  void AreInsideBSpline(double iso, const std::vector<Vector3>& pointsWorld,
                        std::vector<unsigned char>& inside) const override
  {
    AreInside(this->BSpline, iso, pointsWorld, inside);
  }

private:
  Image::Pointer Volume;
  itk::LinearInterpolateImageFunction<Image, double>::Pointer Linear =
      itk::LinearInterpolateImageFunction<Image, double>::New();
  itk::BSplineInterpolateImageFunction<Image, double, double>::Pointer BSpline =
      itk::BSplineInterpolateImageFunction<Image, double, double>::New();
};
} // namespace

std::unique_ptr<ItkInterpolators> PALPATE_ITK_PEERS(const FieldGrid& grid,
                                                    const std::vector<std::int16_t>& samples)
{
  return std::make_unique<Interpolators>(grid, samples);
}
} // namespace palpate::bench
