#include "DrillCases.h"

#include "RandomShapes.h"

namespace palpate::drill_editor_test
{
namespace
{
using test::DrilledBlock;

// A stroke of random cuts, ended if `isEnded`.
std::vector<CutOrder> Stroke(test::Random& random, bool isEnded = true)
{
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  std::vector<CutOrder> orders(6);
  Vector3 place(5.0 * part(random), 5.0 * part(random), 5.0);
  for (CutOrder& order : orders)
  {
    order.Site = 0;
    order.From.PositionWorld = place;
    place += 0.5 * test::RandomDirection(random);
    order.To.PositionWorld = place;
  }
  orders.back().Command = isEnded ? DrillCommand::EndStroke : DrillCommand::None;
  return orders;
}

void Send(DrilledBlock& block, std::uint64_t& number, std::vector<CutOrder> orders)
{
  for (CutOrder& order : orders)
  {
    order.Number = number++;
    ASSERT_TRUE(block.Editor->Link()->Orders.Push(order));
  }
}

void Send(DrilledBlock& block, std::uint64_t& number, DrillCommand command)
{
  CutOrder order;
  order.Command = command;
  Send(block, number, {order});
}

TEST(DrillEditor, FieldIsIndependentOfBatching)
{
  std::vector<std::vector<std::byte>> states;
  for (const std::uint64_t portion : {1, 3, 1000})
  {
    test::Random random(17);
    DrilledBlock block;
    std::uint64_t number = 0;
    for (int stroke = 0; stroke < 8; ++stroke)
    {
      Send(block, number, Stroke(random));
      Send(block, number, stroke % 3 == 1 ? DrillCommand::Undo : DrillCommand::EndStroke);
    }
    for (std::uint64_t until = portion; until < number + portion; until += portion)
    {
      EXPECT_TRUE(block.Editor->Take(until));
      EXPECT_EQ(block.Editor->Newest().Number, std::min(until, number));
    }
    EXPECT_FALSE(block.Editor->Take());
    states.push_back(block.State());
  }
  EXPECT_EQ(states[0], states[1]);
  EXPECT_EQ(states[0], states[2]);
}

TEST(DrillEditor, UndoesRedoesAndResetsWholeStrokes)
{
  test::Random random(18);
  DrilledBlock block;
  std::uint64_t number = 0;
  std::vector<std::vector<std::byte>> states{block.State()};
  EXPECT_FALSE(block.Editor->Newest().CanUndo);
  for (int stroke = 0; stroke < 4; ++stroke)
  {
    Send(block, number, Stroke(random));
    block.Editor->Take();
    states.push_back(block.State());
    ASSERT_NE(states.back(), states[states.size() - 2]);
  }
  for (std::size_t n = states.size() - 1; n-- > 0;)
  {
    EXPECT_TRUE(block.Editor->Newest().CanUndo);
    Send(block, number, DrillCommand::Undo);
    block.Editor->Take();
    EXPECT_EQ(block.State(), states[n]);
    EXPECT_TRUE(block.Editor->Newest().CanRedo);
  }
  EXPECT_FALSE(block.Editor->Newest().CanUndo);
  Send(block, number, DrillCommand::Undo);
  for (std::size_t n = 1; n < states.size(); ++n)
  {
    Send(block, number, DrillCommand::Redo);
    block.Editor->Take();
    EXPECT_EQ(block.State(), states[n]);
  }
  EXPECT_FALSE(block.Editor->Newest().CanRedo);
  Send(block, number, DrillCommand::Reset);
  block.Editor->Take();
  EXPECT_EQ(block.State(), states[0]);
  EXPECT_EQ(block.Editor->RemovedVolumes()[0], 0.0);
  Send(block, number, DrillCommand::Undo);
  block.Editor->Take();
  EXPECT_EQ(block.State(), states.back());
}

TEST(DrillEditor, UndoesAnOpenStroke)
{
  test::Random random(19);
  DrilledBlock block;
  std::uint64_t number = 0;
  const auto before = block.State();
  Send(block, number, Stroke(random, false));
  block.Editor->Take();
  EXPECT_TRUE(block.Editor->Newest().CanUndo);
  Send(block, number, DrillCommand::Undo);
  block.Editor->Take();
  EXPECT_EQ(block.State(), before);
}

TEST(DrillEditor, RestoresRemoval)
{
  test::Random random(20);
  DrilledBlock block;
  std::uint64_t number = 0;
  Send(block, number, Stroke(random));
  block.Editor->Take();
  const double volume = block.Editor->RemovedVolumes()[0];
  DrilledBlock other;
  ASSERT_TRUE(other.Editor->Restore(block.Editor->Removed()).IsOk());
  EXPECT_EQ(other.State(), block.State());
  EXPECT_EQ(other.Editor->RemovedVolumes()[0], volume);
  EXPECT_FALSE(other.Editor->Restore({}).IsOk());
}

TEST(DrillEditor, ReportsAndSkipsOrdersForMissingSitesOrTools)
{
  DrilledBlock block;
  std::uint64_t number = 0;
  CutOrder site;
  site.Site = 7;
  CutOrder tool;
  tool.Site = 0;
  tool.Tool = 3;
  for (const CutOrder& order : {site, tool})
  {
    Send(block, number, {order});
    block.Editor->Take();
    EXPECT_NE(block.Editor->Newest().Problem, "");
    EXPECT_EQ(block.Editor->RemovedVolumes()[0], 0.0);
  }
}

TEST(DrillEditor, RejectsInvalidTool)
{
  DrilledBlock block;
  int number = 0;
  EXPECT_FALSE(block.Editor->AddTool(CutTool::Sphere(-1.0), number).IsOk());
  EXPECT_TRUE(block.Editor->AddTool(CutTool::Cylinder(1.0, 4.0), number).IsOk());
  EXPECT_EQ(number, 1);
}

// Views and a servo that hold versions for long delay the editor, which then continues by itself.
TEST(DrillEditor, LongHeldVersionsOnlyDelayNewOnes)
{
  test::Random random(21);
  DrilledBlock block;
  std::uint64_t number = 0;
  std::vector<DrillReading> kept;
  for (int n = 0; n < 60; ++n)
  {
    Send(block, number, Stroke(random));
    block.Editor->Take();
    kept.push_back(block.Editor->Newest());
  }
  kept.clear();
  block.Editor->Take();
  EXPECT_EQ(block.Editor->Newest().Number, number);
  EXPECT_EQ(block.Editor->Newest().Problem, "");
}
} // namespace
} // namespace palpate::drill_editor_test
