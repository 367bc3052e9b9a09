#include "CheckCases.h"
#include "CheckGroup.h"

#include <gtest/gtest.h>

namespace palpate::checked_case_test
{
namespace
{
using namespace palpate::test;

CheckedOrgan OrganAt(const std::string& name, const Vector3& place, double milliliters)
{
  CheckedOrgan organ;
  organ.Name = name;
  organ.Measured.Centroid = place;
  organ.Measured.Milliliters = milliliters;
  return organ;
}

// Pairs on both sides of x = 5.
CheckedCase Head()
{
  CheckedCase head;
  double y = 0.0;
  for (const char* name : {"Putamen", "Pallidum", "Caudate", "Hippocampus", "Amygdala"})
  {
    const double x = 10.0 + 0.3 * y;
    head.Organs.push_back(OrganAt(std::string(name) + "_L", {5.0 + x, y, 0.5 * y}, 4.0));
    head.Organs.push_back(OrganAt(std::string(name) + "_R", {5.0 - x, y, 0.5 * y}, 4.2));
    y += 20.0;
  }
  head.Organs.push_back(OrganAt("Vermis", {5, 0, 0}, 9.0));
  return head;
}

double ValueOf(const CheckedCase& patient, std::size_t organ, const char* key)
{
  return Find(patient.Organs[organ].Measured.Statistics, key).Value;
}

TEST(CheckedCase, SidesAreReadFromNames)
{
  for (const char* name :
       {"Putamen_L", "left putamen", "putamen-left", "LeftPutamen", "lh.Putamen"})
  {
    EXPECT_EQ(SideOfName(name).Side, 1) << name;
    EXPECT_EQ(SideOfName(name).Rest.find("putamen") != std::string::npos, true) << name;
  }
  EXPECT_EQ(SideOfName("kidney_right").Side, -1);
  EXPECT_EQ(SideOfName("kidney_right").Rest, SideOfName("kidney_left").Rest);
  for (const char* name : {"liver", "Lobule", "bright", "Lumbar_1", "cleft"})
  {
    EXPECT_EQ(SideOfName(name).Side, 0) << name;
  }
}

TEST(CheckedCase, RightSidesAreUnsuspicious)
{
  CheckedCase head = Head();
  MeasureSides(head);
  for (std::size_t n = 0; n < 10; ++n)
  {
    EXPECT_EQ(ValueOf(head, n, "side"), 0.0);
    EXPECT_LT(ValueOf(head, n, "pair"), 0.1);
    EXPECT_EQ(JudgeByRules(head.Organs[n]).Is, OrganJudgement::Verdict::Plausible);
  }
  EXPECT_TRUE(head.Organs[10].Measured.Statistics.empty());
}

TEST(CheckedCase, SwappedSidesAreImplausible)
{
  CheckedCase head = Head();
  std::swap(head.Organs[2].Measured.Centroid, head.Organs[3].Measured.Centroid);
  MeasureSides(head);
  for (std::size_t n = 0; n < 10; ++n)
  {
    EXPECT_EQ(ValueOf(head, n, "side"), n == 2 || n == 3 ? 1.0 : 0.0) << n;
  }
  EXPECT_EQ(JudgeByRules(head.Organs[2]).Is, OrganJudgement::Verdict::Implausible);
  EXPECT_EQ(JudgeByRules(head.Organs[2]).Reason.Key, "side");
}

TEST(CheckedCase, SwappedNeighboursDifferFromTheOtherSide)
{
  CheckedCase head = Head();
  std::swap(head.Organs[0].Measured.Centroid, head.Organs[2].Measured.Centroid);
  MeasureSides(head);
  EXPECT_GT(ValueOf(head, 0, "pair"), 1.0);
  EXPECT_GT(ValueOf(head, 2, "pair"), 1.0);
  EXPECT_LT(ValueOf(head, 6, "pair"), 0.5);
}

TEST(CheckedCase, MajorityOfPairsDecidesWhichWayIsLeft)
{
  CheckedCase head = Head();
  for (CheckedOrgan& organ : head.Organs)
  {
    organ.Measured.Centroid.x() *= -1.0; // in an image whose axes are mirrored
  }
  std::swap(head.Organs[2].Measured.Centroid, head.Organs[3].Measured.Centroid);
  MeasureSides(head);
  EXPECT_EQ(ValueOf(head, 2, "side"), 1.0);
  EXPECT_EQ(ValueOf(head, 0, "side"), 0.0);
}

TEST(CheckedCase, OnePairIsJudgedByThePatientsAxes)
{
  CheckedCase pair;
  pair.Organs = {OrganAt("kidney_left", {-50, 0, 0}, 150),
                 OrganAt("kidney_right", {50, 0, 0}, 150)};
  CheckedCase unknown = pair;
  unknown.IsOriented = false;
  MeasureSides(pair);
  MeasureSides(unknown);
  EXPECT_EQ(ValueOf(pair, 0, "side"), 1.0);
  EXPECT_EQ(ValueOf(unknown, 0, "side"), 0.0);
}
} // namespace
} // namespace palpate::checked_case_test
