#include "ProofCells.h"

#include "CenteredSurfaceSample.h"
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

// Cuts the cell of this number, and one of the parts at random, down to a finest node; returns its
// group.
std::size_t CutToFinest(Cells& cells, const Search& search, std::size_t root, Random& random)
{
  std::size_t index = root;
  while (search.Tree().IsInner(cells.Nodes[index]))
  {
    index = Cells::Count * cells.CutNode(index) + random() % Cells::Count;
  }
  return index / Cells::Count;
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

TEST_F(ProofCellsOfATube, FinestNodesAreExpandedWithoutBeingEvaluated)
{
  Random random(9522);
  const auto& descent = this->Searched.Descent();
  std::uniform_real_distribution<double> height(0.5, 8.0); // mm
  for (std::size_t root = 0; root < SurfacePatchTreeOf<CenteredSurface>::RootCount; ++root)
  {
    EXPECT_EQ(this->Cut->ExpandedOf(root / Cells::Count), nullptr);
    const std::size_t group = CutToFinest(*this->Cut, this->Searched, root, random);
    const ExpandedParts* expanded = this->Cut->ExpandedOf(group);
    ASSERT_NE(expanded, nullptr);
    for (std::size_t part = 0; part < Cells::Count; ++part)
    {
      const SphericalCap cap = this->Cut->CapOf(Cells::Count * group + part);
      const auto sample = this->Shape->EvaluateSecondOrder(cap.Center);
      const Vector3 place = sample.Point + height(random) * NormalOf(sample);
      alignas(sizeof(FourLanes)) FourLanes lower;
      expanded->LowerDistance(place, FastestInstructionSet(), lower);
      const double alone = descent.LowerDistance(place, cap.Center, sample, cap.Radius);
      EXPECT_GT(alone, 0.1) << root << " " << part;
      EXPECT_NEAR(lower[part], alone, 1e-10) << root << " " << part;
    }
  }
}

TEST_F(ProofCellsOfATube, TrianglesAreExpandedOnceTheyAreEvaluated)
{
  Random random(9523);
  const std::size_t finest = Cells::Count * CutToFinest(*this->Cut, this->Searched, 3, random);
  this->Cut->Separate(finest);
  const ExpandedParts* known = this->Cut->ExpandedOf(finest / Cells::Count);
  this->Cut->Evaluate(finest);
  EXPECT_EQ(this->Cut->ExpandedOf(finest / Cells::Count), known); // the tree's
  const std::size_t group = this->Cut->CutTriangle(finest);
  EXPECT_EQ(this->Cut->ExpandedOf(group), nullptr);
  EXPECT_FALSE(this->Cut->HasBounds(group));
  this->Cut->Evaluate(Cells::Count * group + 2);
  const ExpandedParts* expanded = this->Cut->ExpandedOf(group);
  ASSERT_NE(expanded, nullptr);
  EXPECT_TRUE(this->Cut->HasBounds(group));
  const auto& triangle = this->Cut->Triangles[Cells::Count * group + 2];
  EXPECT_EQ(expanded->PointOf(2), triangle.Sample.Point);
  EXPECT_EQ(expanded->ExtentOf(2), triangle.Bounds.Extent(triangle.Cap.Radius));
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
