#include "ShapeSynthesis.h"

#include "InputError.h"
#include "ModelFile.h"
#include "TemporaryFolder.h"

#include <cmath>
#include <gtest/gtest.h>
#include <utility>

namespace palpate::shape_synthesis_test
{
namespace
{
/// Balls with relief: two modes, of which the first changes the radius by 2 mm per deviation.
CohortGroup TwoModes()
{
  CohortGroup group;
  const double unit = std::sqrt(4.0 * M_PI); // coefficient of 1 mm of radius
  for (const auto& [size, relief] :
       {std::pair<double, double>{-1.0, -0.5}, {-1.0, 0.5}, {1.0, -0.5}, {1.0, 0.5}})
  {
    const double factor = std::sqrt(3.0 / 4.0); // deviations over cases - 1
    group.Rows.emplace_back();
    group.Models.emplace_back(
        RadialModel(1, {unit * (20.0 + 2.0 * factor * size), 0.0, relief * factor * unit, 0.0},
                    Vector3::Zero()));
  }
  EXPECT_TRUE(FindShapeModes(CoefficientsOf(group), group.Modes).IsOk());
  return group;
}

TEST(ShapeSynthesis, AddsStandardDeviationsOfModesToTheMean)
{
  const CohortGroup group = TwoModes();
  const test::TemporaryFolder folder;
  WriteSynthesis(group, "1:2,2:-1", folder.Path(), "test");
  const auto shape = std::get<RadialModel>(ReadModel(folder / "shape.json").Surface);
  const double unit = std::sqrt(4.0 * M_PI);
  EXPECT_NEAR(shape.Coefficients()[0], 24.0 * unit, 1e-12);
  EXPECT_NEAR(shape.Coefficients()[2], -0.5 * unit, 1e-12);
  EXPECT_EQ(shape.CenterWorld(), Vector3::Zero());
}

TEST(ShapeSynthesis, ZeroIsTheMean)
{
  const auto mean = std::get<RadialModel>(SynthesizeShape(TwoModes(), "0"));
  EXPECT_NEAR(mean.Coefficients()[0], 20.0 * std::sqrt(4.0 * M_PI), 1e-12);
  EXPECT_NEAR(mean.Coefficients()[2], 0.0, 1e-12);
}

TEST(ShapeSynthesis, RejectsWhatIsNoListOfModes)
{
  const CohortGroup group = TwoModes();
  for (const char* text : {",", "1", "1:", "1:x", "1:2;2:1", "1:2,1:3", "3:1", "0:1", "-1:1",
                           "1.5:1", "1:nan", "1:inf"})
  {
    EXPECT_THROW(SynthesizeShape(group, text), InputError) << text;
  }
}

TEST(ShapeSynthesis, RejectsShapeThroughItsCentre)
{
  EXPECT_THROW(SynthesizeShape(TwoModes(), "1:-11"), InputError);
  EXPECT_NO_THROW(SynthesizeShape(TwoModes(), "1:-9"));
}
} // namespace
} // namespace palpate::shape_synthesis_test
