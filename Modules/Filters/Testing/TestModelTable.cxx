#include "ModelTable.h"

#include "RandomShapes.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

namespace palpate::model_table_test
{
namespace
{

TEST(ModelTable, RoundTripsBitForBit)
{
  palpate::test::Random random(5);
  const RadialModel model(7, palpate::test::RandomCoefficients(random, 7),
                          palpate::Vector3(1.5, -20.25, 1e-3));
  vtkNew<vtkTable> table;
  palpate::ToTable(model, table);
  EXPECT_EQ(table->GetNumberOfRows(), 64);
  RadialModel back;
  ASSERT_TRUE(palpate::FromTable(table, back));
  EXPECT_EQ(back.Coefficients(), model.Coefficients());
  EXPECT_EQ(back.CenterWorld(), model.CenterWorld());
}

TEST(ModelTable, RejectsOtherTables)
{
  RadialModel model;
  vtkNew<vtkTable> table;
  EXPECT_FALSE(palpate::FromTable(table, model));
  palpate::ToTable(RadialModel(), table);
  table->GetFieldData()->RemoveArray("Center");
  EXPECT_FALSE(palpate::FromTable(table, model));
  palpate::ToTable(RadialModel(), table);
  table->SetValueByName(0, "Order", 1); // |m| > l
  EXPECT_FALSE(palpate::FromTable(table, model));
}
} // namespace
} // namespace palpate::model_table_test
