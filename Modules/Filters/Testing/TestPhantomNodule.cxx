#include "PhantomNodule.h"

#include "PhantomSampler.h"
#include "ProstateLikeModel.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace palpate::phantom_nodule_test
{
namespace
{
const Vector3 TestCenter(12.3, -45.6, 78.9);

palpate::RadialModel Body()
{
  return palpate::MakeProstateLikeModel(8, 3, TestCenter);
}

palpate::RadialModel Sphere(double radius)
{
  return {0, {radius * std::sqrt(4.0 * M_PI)}, TestCenter};
}

PhantomGrid CubicGrid(double spacing)
{
  const int count = static_cast<int>(std::ceil(64.0 / spacing));
  PhantomGrid grid;
  grid.Size = {count, count, count};
  grid.Spacing.setConstant(spacing);
  grid.CenterOn(TestCenter);
  return grid;
}

PhantomAppearance WithNodule(double diameter, double depth)
{
  PhantomAppearance look;
  look.Nodule.emplace();
  const palpate::Status status = PhantomNodule::Place(Body(), diameter, depth, *look.Nodule);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return look;
}

template <typename Scalar>
std::vector<Scalar> Values(vtkImageData* image)
{
  const auto* first = static_cast<const Scalar*>(image->GetScalarPointer());
  return {first, first + image->GetNumberOfPoints()};
}

double BallVolume(double diameter)
{
  return M_PI / 6.0 * std::pow(diameter, 3);
}

TEST(PhantomNodule, LiesBehindCentreOfSphere)
{
  PhantomNodule nodule;
  ASSERT_TRUE(PhantomNodule::Place(Sphere(20.0), 10.0, 5.0, nodule).IsOk());
  EXPECT_EQ(nodule.Radius, 5.0);
  EXPECT_LE((nodule.Offset - Vector3(0.0, 10.0, 0.0)).norm(), 1e-12); // roundings
}

TEST(PhantomNodule, TopLiesAtDepthAlongNormal)
{
  const palpate::RadialModel body = Body();
  const Vector3 behind = Vector3::UnitY();
  for (const double depth : {0.0, 2.0, 8.0})
  {
    PhantomNodule nodule;
    ASSERT_TRUE(PhantomNodule::Place(body, 8.0, depth, nodule).IsOk());
    const Vector3 top = TestCenter + nodule.Offset + nodule.Radius * body.Normal(behind);
    EXPECT_LE((top + depth * body.Normal(behind) - body.PointWorld(behind)).norm(), 1e-12);
  }
}

TEST(PhantomNodule, RejectsBallsThatAreNotInside)
{
  PhantomNodule nodule;
  EXPECT_TRUE(PhantomNodule::Place(Sphere(20.0), 40.0, 0.0, nodule).IsOk());
  EXPECT_TRUE(PhantomNodule::Place(Sphere(20.0), 10.0, 30.0, nodule).IsOk());
  const palpate::Status large = PhantomNodule::Place(Sphere(20.0), 43.0, 0.0, nodule);
  EXPECT_NE(large.Message().find("reach 3 mm out of it"), std::string::npos) << large.Message();
  const palpate::Status deep = PhantomNodule::Place(Sphere(20.0), 10.0, 70.0, nodule);
  EXPECT_NE(deep.Message().find("reach 40 mm out of it"), std::string::npos) << deep.Message();
  EXPECT_FALSE(PhantomNodule::Place(Sphere(20.0), 0.0, 5.0, nodule).IsOk());
  EXPECT_FALSE(PhantomNodule::Place(Sphere(20.0), 5.0, -0.1, nodule).IsOk());
  EXPECT_FALSE(PhantomNodule::Place(Sphere(20.0), std::nan(""), 5.0, nodule).IsOk());
  EXPECT_FALSE(PhantomNodule::Place(Sphere(20.0), 5.0, std::nan(""), nodule).IsOk());
}

TEST(PhantomNodule, MaskHoldsItsVolume)
{
  constexpr double Spacing = 0.5;
  for (const double diameter : {4.0, 8.0, 16.0})
  {
    const PhantomImages phantom =
        MakePhantom(Body(), CubicGrid(Spacing), WithNodule(diameter, 2.0));
    const std::vector<unsigned char> nodule = Values<unsigned char>(phantom.Nodule);
    const auto inside = static_cast<double>(std::count(nodule.begin(), nodule.end(), 1));
    // About area / h^2 voxels are cut, each with an error of h^3 / sqrt(12): five deviations.
    EXPECT_NEAR(inside * std::pow(Spacing, 3), BallVolume(diameter),
                5.0 * Spacing * Spacing * std::sqrt(M_PI * diameter * diameter / 12.0))
        << diameter;
  }
}

TEST(PhantomNodule, ChangesVolumeByItsOwnAndNothingElse)
{
  const PhantomGrid grid = CubicGrid(1.0);
  PhantomAppearance look = WithNodule(8.0, 2.0);
  look.InnerZoneFraction = 0.0; // one tissue around the nodule
  look.NoduleIntensity = look.Body - 1.0;
  PhantomAppearance plain = look;
  plain.Nodule.reset();
  const PhantomImages without = MakePhantom(Body(), grid, plain);
  const PhantomImages with = MakePhantom(Body(), grid, look);
  EXPECT_FALSE(without.Nodule);
  EXPECT_EQ(Values<unsigned char>(with.Mask), Values<unsigned char>(without.Mask));
  const std::vector<float> before = Values<float>(without.Volume);
  const std::vector<float> after = Values<float>(with.Volume);
  const std::vector<unsigned char> body = Values<unsigned char>(with.Mask);
  const std::vector<unsigned char> nodule = Values<unsigned char>(with.Nodule);
  double darkened = 0.0;
  for (std::size_t v = 0; v < before.size(); ++v)
  {
    darkened += before[v] - after[v];
    ASSERT_LE(nodule[v], body[v]);
  }
  // 4^3 points a voxel of 1 mm: counting points 0.25 mm apart, five deviations.
  EXPECT_NEAR(darkened, BallVolume(8.0), 5.0 * 0.0625 * std::sqrt(M_PI * 64.0 / 12.0));
}

TEST(PhantomNodule, HasIntensityOfItsOwn)
{
  const PhantomAppearance look = WithNodule(12.0, 2.0);
  const PhantomGrid grid = CubicGrid(1.0);
  const PhantomImages phantom = MakePhantom(Body(), grid, look);
  const std::vector<float> values = Values<float>(phantom.Volume);
  int pure = 0;
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    double point[3];
    phantom.Volume->GetPoint(static_cast<vtkIdType>(v), point);
    // Half a diagonal of a voxel is 0.87 mm.
    if (look.Nodule->SignedDistance(Vector3(point) - TestCenter) < -0.9)
    {
      ASSERT_EQ(values[v], static_cast<float>(look.NoduleIntensity));
      ++pure;
    }
  }
  EXPECT_GT(pure, 400);
}
} // namespace
} // namespace palpate::phantom_nodule_test
