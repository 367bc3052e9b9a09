#include "OpenCells.h"

#include "RandomShapes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace palpate::open_cells_test
{
namespace
{
constexpr std::size_t Capacity = 400;
using Cells = OpenCells<Capacity>;

// What each cell lacks, mm: from far below any tolerance to the size of an organ.
std::vector<double> RandomLacks(std::size_t count, test::Random& random)
{
  std::uniform_real_distribution<double> exponent(-9.0, 2.0);
  std::vector<double> lacks;
  for (std::size_t i = 0; i < count; ++i)
  {
    lacks.push_back(std::pow(10.0, exponent(random)));
  }
  return lacks;
}

std::vector<std::size_t> Sorted(const std::vector<double>& lacks, bool isMostLast)
{
  Cells cells;
  for (std::size_t i = 0; i < lacks.size(); ++i)
  {
    cells.Add(i, lacks[i]);
  }
  cells.Sort(isMostLast);
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < cells.Count(); ++i)
  {
    order.push_back(cells[i]);
  }
  return order;
}

class OpenCellsOrder : public testing::TestWithParam<std::size_t>
{
};

TEST_P(OpenCellsOrder, CellsAreInOrderUpToAQuarterWhereTheyLackMuch)
{
  test::Random random(9501);
  for (int trial = 0; trial < 20; ++trial)
  {
    const std::vector<double> lacks = RandomLacks(GetParam(), random);
    std::vector<std::size_t> order = Sorted(lacks, trial % 2 == 1);
    if (trial % 2 == 1)
    {
      std::reverse(order.begin(), order.end());
    }
    const double most = lacks.empty() ? 0.0 : *std::max_element(lacks.begin(), lacks.end());
    double least = most; // of those before
    for (const std::size_t cell : order)
    {
      // A quarter of an octave begins with 4/4, 5/4, 6/4 or 7/4 of a power of two.
      EXPECT_TRUE(lacks[cell] <= 1.25 * least || lacks[cell] < most / 128.0) << lacks[cell];
      least = std::min(least, lacks[cell]);
    }
  }
}

TEST_P(OpenCellsOrder, EveryCellIsKept)
{
  test::Random random(9502);
  for (const bool isMostLast : {false, true})
  {
    std::vector<std::size_t> order = Sorted(RandomLacks(GetParam(), random), isMostLast);
    std::sort(order.begin(), order.end());
    ASSERT_EQ(order.size(), GetParam());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      EXPECT_EQ(order[i], i);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Counts, OpenCellsOrder, testing::Values(0, 1, 2, 33, Capacity));

TEST(OpenCells, CellsThatLackNothingAreLeftOut)
{
  Cells cells;
  const std::vector<double> lacks{-1.0,    2.0,    0.0,
                                  -1e-300, 1e-300, -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < lacks.size(); ++i)
  {
    cells.Add(i, lacks[i]);
  }
  cells.Sort(false);
  ASSERT_EQ(cells.Count(), 2u);
  EXPECT_EQ(cells[0], 1u);
  EXPECT_EQ(cells[1], 4u);
}

TEST(OpenCells, ThereIsRoomForOneThatIsLeftOut)
{
  Cells cells;
  for (int trial = 0; trial < 2; ++trial)
  {
    cells.Clear();
    EXPECT_EQ(cells.Count(), 0u);
    for (std::size_t i = 0; i < Capacity; ++i)
    {
      cells.Add(i, 1.0);
    }
    cells.Add(3071, -1.0);
    cells.Sort(false);
    EXPECT_EQ(cells.Count(), Capacity);
  }
}

TEST(OpenCells, BoundlessLacksComeFirst)
{
  Cells cells;
  cells.Add(7, 3.0);
  cells.Add(3071, std::numeric_limits<double>::infinity()); // of cells without any bound
  cells.Sort(false);
  EXPECT_EQ(cells[0], 3071u);
  EXPECT_EQ(cells[1], 7u);
}
} // namespace
} // namespace palpate::open_cells_test
