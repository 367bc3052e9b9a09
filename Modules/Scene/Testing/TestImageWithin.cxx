#include "ImageWithin.h"

#include "FieldOfImage.h"
#include "RandomOrientation.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
// An image with an oblique direction whose scalars identify their nodes.
vtkSmartPointer<vtkImageData> NumberedImage(std::mt19937_64& random)
{
  const FieldGrid grid({17, 9, 12}, {-20.0, 33.0, 5.0}, {0.8, 1.5, 1.1},
                       test::RandomOrientation(random));
  vtkSmartPointer<vtkImageData> image = EmptyImageOf(grid);
  image->AllocateScalars(VTK_SHORT, 1);
  auto* scalar = static_cast<short*>(image->GetScalarPointer());
  for (int i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    scalar[i] = static_cast<short>(i);
  }
  return image;
}

TEST(ImageWithin, KeepsScalarsAndPlacesThatTheBoxNeeds)
{
  std::mt19937_64 random(4401);
  std::uniform_real_distribution<double> part(-0.2, 1.2);
  int smaller = 0;
  for (int sample = 0; sample < 200; ++sample)
  {
    const vtkSmartPointer<vtkImageData> image = NumberedImage(random);
    const FieldGrid grid = GridOfImage(image);
    const auto place = [&]
    { return Vector3(part(random) * 16.0, part(random) * 8.0, part(random) * 11.0); };
    const Vector3 middle = grid.PointWorld(place());
    const Eigen::AlignedBox3d box(middle - Vector3(0.3, 1.0, 2.0), middle + Vector3(0.3, 1.0, 2.0));
    const vtkSmartPointer<vtkImageData> found = ImageWithin(image, box);
    const FieldGrid within = GridOfImage(found);
    smaller += found->GetNumberOfPoints() < image->GetNumberOfPoints() ? 1 : 0;
    const auto* scalar = static_cast<const short*>(found->GetScalarPointer());
    const auto& size = within.Size();
    for (int n = 0; n < found->GetNumberOfPoints(); ++n)
    {
      const Vector3 node(n % size[0], n / size[0] % size[1], n / size[0] / size[1]);
      const Vector3 index = grid.PointIndex(within.PointWorld(node));
      const Vector3 nearest = index.array().round();
      ASSERT_LT((index - nearest).norm(), 1e-9); // of coordinates of 40 mm, rounded
      ASSERT_EQ(scalar[n], nearest[0] + 17.0 * (nearest[1] + 9.0 * nearest[2]));
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      const Vector3 point = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
      const Vector3 last(16.0, 8.0, 11.0);
      const Vector3 inImage = grid.PointIndex(point);
      if ((inImage.array() >= 0.0).all() && (inImage.array() <= last.array()).all())
      {
        const Vector3 inPart = within.PointIndex(point);
        ASSERT_TRUE((inPart.array() >= 0.0).all() && inPart[0] <= size[0] - 1 &&
                    inPart[1] <= size[1] - 1 && inPart[2] <= size[2] - 1);
      }
    }
  }
  EXPECT_GT(smaller, 100);
}

TEST(ImageWithin, BoxOutsideGetsTheWholeImage)
{
  std::mt19937_64 random(4402);
  const vtkSmartPointer<vtkImageData> image = NumberedImage(random);
  const Vector3 far = Vector3::Constant(1e4);
  EXPECT_EQ(ImageWithin(image, {far, far + Vector3::Ones()}), image);
}
} // namespace
} // namespace palpate
