#include "ProstateLikeModel.h"

#include "IcosahedronDirections.h"
#include "ModelMeasures.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace palpate::prostate_like_model_test
{
namespace
{
TEST(ProstateLikeModel, HasProstateSizeAndIsStarShaped)
{
  const palpate::IcosahedronDirections directions(8);
  for (std::uint64_t seed = 0; seed < 50; ++seed)
  {
    const auto model = MakeProstateLikeModel(12, seed, Vector3::Zero());
    EXPECT_GT(VolumeOf(model), 30e3) << "seed " << seed; // mm^3
    EXPECT_LT(VolumeOf(model), 60e3) << "seed " << seed;
    for (const Vector3& direction : directions.Directions())
    {
      ASSERT_GT(model.Radius(direction), 10.0) << "seed " << seed;
    }
  }
}

TEST(ProstateLikeModel, LowDegreesAreIndependentOfHighest)
{
  const auto low = MakeProstateLikeModel(5, 9, Vector3::Zero());
  const auto high = MakeProstateLikeModel(12, 9, Vector3::Zero());
  for (std::size_t c = 0; c < low.Coefficients().size(); ++c)
  {
    // Both projections are exact up to aliasing from beyond degree 40: nanometres.
    EXPECT_NEAR(low.Coefficients()[c], high.Coefficients()[c], 1e-6);
  }
}

TEST(ProstateLikeModel, SeedsGiveDifferentBodies)
{
  EXPECT_NE(MakeProstateLikeModel(8, 1, Vector3::Zero()).Coefficients(),
            MakeProstateLikeModel(8, 2, Vector3::Zero()).Coefficients());
}

TEST(ProstateLikeModel, BackIsFlatterThanFront)
{
  const auto model = MakeProstateLikeModel(12, 4, Vector3::Zero());
  EXPECT_LT(model.Radius(Vector3::UnitY()), model.Radius(-Vector3::UnitY()));
}
} // namespace
} // namespace palpate::prostate_like_model_test
