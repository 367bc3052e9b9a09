#include "CsvCell.h"
#include "DecimalText.h"

#include <gtest/gtest.h>
#include <random>

namespace palpate::csv_cell_test
{
namespace
{
TEST(CsvCell, KeepsNumbers)
{
  for (const char* number : {"-1.5", "+2", "1e-3", "-0", "0.1", ""})
  {
    EXPECT_EQ(InertCell(number), number);
  }
}

TEST(CsvCell, KeepsOrdinaryText)
{
  for (const char* text : {"Prostate", "sub-01", "a=b", "it's", "'quoted'", " =1"})
  {
    EXPECT_EQ(InertCell(text), text);
    EXPECT_EQ(TextOfCell(text), text);
  }
}

TEST(CsvCell, DisarmsFormulas)
{
  for (const char* text :
       {"=1+1", "+cmd|' /C calc'!A0", "-2+3", "@SUM(A1)", "\t=1", "\r=1", "=", "-", "-inf"})
  {
    EXPECT_EQ(InertCell(text), "'" + std::string(text));
  }
}

TEST(CsvCell, RoundTripsTextAndDisarmsFormulas)
{
  const std::string letters = "=+-@\t\r\n',;\"1.e5ax \xC3";
  std::mt19937 random(11);
  for (int n = 0; n < 20000; ++n)
  {
    std::string text(random() % 7, ' ');
    for (char& letter : text)
    {
      letter = letters[random() % letters.size()];
    }
    const std::string cell = InertCell(text);
    ASSERT_EQ(TextOfCell(cell), text);
    ASSERT_TRUE(cell.empty() || palpate::ParseNumber(cell) ||
                std::string("=+-@\t\r").find(cell[0]) == std::string::npos)
        << cell;
  }
}
} // namespace
} // namespace palpate::csv_cell_test
