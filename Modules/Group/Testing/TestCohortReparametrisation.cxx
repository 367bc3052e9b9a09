#include "CohortReparametrisation.h"

#include "MessageOf.h"
#include "Progress.h"
#include "ReportPage.h"
#include "SurfacePhantoms.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace palpate::cohort_reparametrisation_test
{
namespace
{
constexpr int Cases = 4;

// Ellipsoids that differ in one axis, about the origin.
CohortGroup Ellipsoids()
{
  CohortGroup group;
  for (int i = 0; i < Cases; ++i)
  {
    CohortRow row;
    row.Case = "case " + std::to_string(i);
    group.Rows.push_back(row);
    group.Models.emplace_back(test::EllipsoidPhantom(Vector3(20.0 + 2.0 * i, 15.0, 12.0), 6)
                                  .Transformed(Matrix3::Identity(), Vector3(-12.0, 7.0, -40.0)));
  }
  EXPECT_TRUE(FindShapeModes(CoefficientsOf(group), group.Modes).IsOk());
  return group;
}

TEST(CohortReparametrisation, ChangesModelsAndModesAndTellsWhatItDid)
{
  CohortGroup group = Ellipsoids();
  const ShapeModes before = group.Modes;
  const CohortReparametrisation made = ReparametriseCohortGroup(group, {});
  EXPECT_LT(made.Result.LengthAfter, made.Result.LengthBefore);
  ASSERT_EQ(group.Models.size(), static_cast<std::size_t>(Cases));
  EXPECT_LT(group.Modes.Deviations.squaredNorm(), before.Deviations.squaredNorm());
  EXPECT_LT(made.After.Compactness.Values.tail(1)[0], made.Before.Compactness.Values.tail(1)[0]);
  const std::string table = ReparametrisationTable(group, made);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + Cases);
  EXPECT_NE(table.find("case 3"), std::string::npos);
  EXPECT_NE(ReparametrisationText(made).find("of 4 surfaces"), std::string::npos);
  ReportPage page;
  AddReparametrisation(page, made);
  EXPECT_NE(page.Body().find("description length"), std::string::npos);
}

TEST(CohortReparametrisation, RefusesRadialModels)
{
  CohortGroup group = Ellipsoids();
  group.Models.assign(Cases, RadialModel(1, {30.0, 0.0, 1.0, 0.0}, Vector3::Zero()));
  const std::string message = test::MessageOf([&] { ReparametriseCohortGroup(group, {}); });
  EXPECT_NE(message.find("--model surface"), std::string::npos) << message;
}

TEST(CohortReparametrisation, CanBeCancelled)
{
  CohortGroup group = Ellipsoids();
  EXPECT_THROW(ReparametriseCohortGroup(group, {}, [](double) { return false; }), Cancelled);
}
} // namespace
} // namespace palpate::cohort_reparametrisation_test
