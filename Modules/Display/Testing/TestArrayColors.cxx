#include "ArrayColors.h"

#include "vtkLookupTable.h"

#include <gtest/gtest.h>

TEST(ArrayColors, ZeroIsWhiteAndCentredForBothSigns)
{
  const auto table = palpate::MakeArrayColors(-0.3, 0.9);
  EXPECT_DOUBLE_EQ(table->GetRange()[0], -1.0);
  EXPECT_DOUBLE_EQ(table->GetRange()[1], 1.0);
  double color[3];
  table->GetColor(0.0, color);
  for (const double part : color)
  {
    EXPECT_NEAR(part, 247.0 / 255.0, 0.01); // the centre of the map
  }
}

TEST(ArrayColors, OneSignUsesWholeRange)
{
  EXPECT_EQ(palpate::MakeArrayColors(0.0, 0.9)->GetRange()[0], 0.0);
  EXPECT_EQ(palpate::MakeArrayColors(-0.9, 0.0)->GetRange()[1], 0.0);
}

TEST(ArrayColors, OwnArraysHaveUnit)
{
  EXPECT_EQ(palpate::ArrayTitle("DistanceToSurface"), "Distance to the surface, mm");
  EXPECT_EQ(palpate::ArrayTitle("Thickness"), "Thickness");
}
