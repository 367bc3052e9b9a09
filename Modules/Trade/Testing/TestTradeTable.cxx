#include "TradeTable.h"

#include "InputError.h"
#include "TemporaryFolder.h"
#include "WholeFile.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
TradeRow SomeRow()
{
  TradeRow row;
  row.Structure = "left, \"lower\" pole";
  row.Setting.Representation = TouchRepresentation::Facets;
  row.Setting.Facets = 2000;
  row.Knob = TradeKnob::Facets;
  row.Represented = "2000 facets";
  row.Truth = "its own triangles";
  row.Key = "0123456789abcdef/facets/2000";
  double number = 0.1;
  for (const TradeColumn& column : TradeColumns())
  {
    row.*column.Number = number;
    number *= 1.7;
  }
  return row;
}

TEST(TradeTable, ComesBackToTheBit)
{
  const test::TemporaryFolder folder;
  TradeTable table;
  table.Add(SomeRow());
  TradeRow refused = SomeRow();
  refused.State = TradeRow::Outcome::Refused;
  refused.Message = "is not star-shaped:\nreally";
  refused.PositionRare = NAN;
  refused.Key = "other";
  table.Add(refused);
  table.Write(folder / "tradeoff.csv");
  const TradeTable read = TradeTable::Read(folder / "tradeoff.csv");
  ASSERT_EQ(read.Rows().size(), 2U);
  const TradeRow& first = read.Rows().front();
  EXPECT_EQ(first.Structure, SomeRow().Structure);
  EXPECT_TRUE(first.Setting == SomeRow().Setting);
  EXPECT_EQ(first.Knob, TradeKnob::Facets);
  for (const TradeColumn& column : TradeColumns())
  {
    EXPECT_EQ(first.*column.Number, SomeRow().*column.Number) << column.Name;
  }
  const TradeRow* second = read.Find("other");
  ASSERT_NE(second, nullptr);
  EXPECT_EQ(second->State, TradeRow::Outcome::Refused);
  EXPECT_EQ(second->Message, refused.Message);
  EXPECT_TRUE(std::isnan(second->PositionRare));
}

TEST(TradeTable, IsEmptyWhereThereIsNone)
{
  const test::TemporaryFolder folder;
  EXPECT_TRUE(TradeTable::Read(folder / "tradeoff.csv").Rows().empty());
}

TEST(TradeTable, AnotherFileIsRefused)
{
  const test::TemporaryFolder folder;
  WriteWholeFile(folder / "tradeoff.csv", "case,label\na,1\n");
  EXPECT_THROW(TradeTable::Read(folder / "tradeoff.csv"), InputError);
}

TEST(TradeTable, ADamagedNumberIsRefused)
{
  const test::TemporaryFolder folder;
  TradeTable table;
  table.Add(SomeRow());
  table.Write(folder / "tradeoff.csv");
  std::string text = ReadWholeFile(folder / "tradeoff.csv", 1U << 20U);
  const std::size_t place = text.rfind(",0.1,");
  ASSERT_NE(place, std::string::npos);
  text.replace(place, 5, ",0.1x,");
  WriteWholeFile(folder / "tradeoff.csv", text);
  EXPECT_THROW(TradeTable::Read(folder / "tradeoff.csv"), InputError);
}
} // namespace
} // namespace palpate
