#include "ProofCells.h"

#include "SurfacePhantoms.h"

#include <gtest/gtest.h>
#include <memory>

namespace palpate::proof_cells_test
{
namespace
{
using test::Random;
using Cells = ProofCells<CenteredSurface>;
using Search = ClosestPointSearchOf<CenteredSurface>;

std::shared_ptr<const CenteredSurface> Tube()
{
  Random random(9521);
  return std::make_shared<CenteredSurface>(test::BumpyTube(random));
}

class ProofCellsOfATube : public testing::Test
{
protected:
  ProofCellsOfATube() : Shape(Tube()), Searched(Shape), Cut(std::make_unique<Cells>())
  {
    this->Cut->Begin(this->Searched);
  }

  std::shared_ptr<const CenteredSurface> Shape;
  Search Searched;
  std::unique_ptr<Cells> Cut;
};

TEST_F(ProofCellsOfATube, PartsTakeOverTheClearance)
{
  this->Cut->ClearUntil[5] = 0.75;
  const std::size_t group = this->Cut->CutNode(5);
  for (std::size_t part = 0; part < Cells::Count; ++part)
  {
    EXPECT_EQ(this->Cut->ClearUntil[Cells::Count * group + part], 0.75);
  }
  EXPECT_EQ(this->Cut->ClearUntil[5], std::numeric_limits<double>::infinity());
}

TEST_F(ProofCellsOfATube, AJoinedCellHasTheLeastClearanceOfItsParts)
{
  const std::size_t group = this->Cut->CutNode(5);
  for (std::size_t part = 0; part < Cells::Count; ++part)
  {
    this->Cut->ClearUntil[Cells::Count * group + part] = 4.0 - static_cast<double>(part);
  }
  this->Cut->Join(1.5);
  EXPECT_EQ(this->Cut->ClearUntil[5], std::numeric_limits<double>::infinity());
  this->Cut->Join(0.5);
  EXPECT_EQ(this->Cut->ClearUntil[5], 1.0);
}

TEST_F(ProofCellsOfATube, WithoutMemoryNothingIsCut)
{
  std::size_t cuts = 0;
  std::size_t index = 0;
  for (; index != Cells::Capacity && this->Cut->Parts.FreeGroups() != 0; ++index)
  {
    cuts += this->Searched.Tree().IsInner(this->Cut->Nodes[index]) ? 1 : 0;
    this->Cut->CutNode(index);
  }
  ASSERT_EQ(cuts, index) << "inner nodes only";
  const double before = this->Cut->ClearUntil[index];
  EXPECT_EQ(this->Cut->CutNode(index), Cells::Groups);
  EXPECT_EQ(this->Cut->ClearUntil[index], before);
}
} // namespace
} // namespace palpate::proof_cells_test
