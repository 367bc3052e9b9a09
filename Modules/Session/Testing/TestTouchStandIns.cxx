#include "TouchStandIns.h"

#include "ModelSurface.h"
#include "ProceduralFields.h"
#include "RandomShapes.h"
#include "SceneField.h"
#include "TexturedField.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
bool NeverStops(double, const std::string&)
{
  return true;
}

TouchContact HarmonicOrgan(int degree)
{
  test::Random random(3);
  const SphericalHarmonicModel organ = test::RandomOrgan(random, degree);
  return MakeHarmonicContact(organ, HarmonicContactMode::Nearest, EvaluationPrecision::Double,
                             "organ");
}

TEST(TouchStandIns, HarmonicsAreCutToAHalfAndAQuarterOfTheirDegree)
{
  TouchContact contact = HarmonicOrgan(12);
  AddStandIns(contact, NeverStops);
  ASSERT_EQ(contact.Coarser.size(), 2U);
  EXPECT_EQ(contact.Coarser[0].Says, "degree 6 instead of 12");
  EXPECT_EQ(contact.Coarser[1].Says, "degree 3 instead of 12");
  // They are the same organ, roughly.
  const Vector3 size = contact.Model->BoundsWorld().sizes();
  for (const TouchStandIn& coarser : StandInsFor(contact, ToolShape::Sphere(1.0)))
  {
    EXPECT_LT((coarser.Model->BoundsWorld().sizes() - size).norm(), 0.3 * size.norm());
    EXPECT_FALSE(coarser.Tool.has_value());
  }
}

TEST(TouchStandIns, WhatIsSimpleHasNone)
{
  TouchContact contact = HarmonicOrgan(3);
  AddStandIns(contact, NeverStops);
  EXPECT_TRUE(contact.Coarser.empty());
  TouchContact five = HarmonicOrgan(5);
  AddStandIns(five, NeverStops);
  ASSERT_EQ(five.Coarser.size(), 1U);
  EXPECT_EQ(five.Coarser[0].Says, "degree 2 instead of 5");
}

TEST(TouchStandIns, FacetsBecomeFewer)
{
  const SphericalHarmonicModel ball(0, {20.0 * std::sqrt(4.0 * M_PI)}, Vector3::Zero());
  TouchContact contact = MakeFacetContact(DrawModel(ball, 16), "ball"); // 20 * 16^2 facets
  AddStandIns(contact, NeverStops);
  ASSERT_EQ(contact.Coarser.size(), 2U);
  EXPECT_EQ(contact.Coarser[0].Says, "1280 facets instead of 5120");
  EXPECT_EQ(contact.Coarser[1].Says, "320 facets instead of 5120");
  TouchContact few = MakeFacetContact(DrawModel(ball, 4), "ball");
  AddStandIns(few, NeverStops);
  EXPECT_TRUE(few.Coarser.empty());
}

TEST(TouchStandIns, AFieldIsFeltByFewerPointsOfASphere)
{
  TouchContact contact = MakeFieldContact(test::TexturedField(), 0, "field");
  AddStandIns(contact, NeverStops);
  EXPECT_TRUE(contact.Coarser.empty());
  const auto coarser = StandInsFor(contact, ToolShape::SpherePoints(2.0, 100));
  ASSERT_EQ(coarser.size(), 2U);
  EXPECT_EQ(coarser[0].Says, "a tool of 26 points instead of 100");
  EXPECT_EQ(coarser[0].Tool->Points().size(), 26U);
  EXPECT_EQ(coarser[0].Tool->Radius(), 2.0);
  EXPECT_EQ(coarser[1].Tool->Points().size(), 6U);
  EXPECT_EQ(coarser[1].Model, contact.Model);
  EXPECT_EQ(StandInsFor(contact, ToolShape::SpherePoints(2.0, 26)).size(), 1U);
  EXPECT_TRUE(StandInsFor(contact, ToolShape::Sphere(0.0)).empty());
  EXPECT_TRUE(StandInsFor(contact, ToolShape::Capsule(1.0, 4.0, 100)).empty());
}

TEST(TouchStandIns, TheSentenceIsAboutWhatIsTouched)
{
  TouchScene scene;
  scene.Structures.resize(3);
  scene.Structures[1].Name = "liver";
  scene.Structures[1].Coarser = {{nullptr, {}, "degree 6 instead of 12"}};
  scene.Structures[2].Name = "spleen";
  scene.Structures[2].Coarser = {{nullptr, {}, "degree 4 instead of 8"},
                                 {nullptr, {}, "degree 2 instead of 8"}};
  EXPECT_EQ(LevelText(scene, 0, 1, 1000.0), "");
  EXPECT_EQ(LevelText(scene, 1, 1, 1000.0),
            "liver is felt by degree 6 instead of 12: ticks took longer than 1 ms.");
  EXPECT_EQ(LevelText(scene, 2, 1, 1000.0), LevelText(scene, 1, 1, 1000.0));
  EXPECT_EQ(LevelText(scene, 2, 2, 400.0),
            "spleen is felt by degree 2 instead of 8: ticks took longer than 2.5 ms.");
  EXPECT_EQ(LevelText(scene, 1, -1, 1000.0), LevelText(scene, 1, 1, 1000.0));
  EXPECT_EQ(LevelText(scene, 1, 0, 1000.0), LevelText(scene, 1, 1, 1000.0));
  EXPECT_EQ(LevelText(scene, 1, 99, 1000.0), LevelText(scene, 1, 1, 1000.0));
  EXPECT_EQ(LevelText(TouchScene(), 1, 0, 1000.0), "");
}
} // namespace
} // namespace palpate
