#include "AllocationCounter.h"
#include "DrillCases.h"
#include "ServoRun.h"

namespace palpate::drill_does_not_allocate_test
{
namespace
{
TEST(DrillDoesNotAllocate, InAnyTick)
{
  test::DrilledBlock block;
  test::ServoRun run(block.Scene());
  run.Loop.RunDrill(true);
  std::size_t editing = 0;
  const std::size_t before = test::AllocationCount();
  for (int n = 0; n < 2000; ++n)
  {
    run.TickAt({2.0 * std::cos(0.01 * n), 0.0, 5.5 + 3.0 * std::sin(0.003 * n)});
    if (n % 500 == 499)
    {
      run.Loop.Command(DrillCommand::Undo);
    }
    const std::size_t start = test::AllocationCount();
    block.Editor->Take();
    editing += test::AllocationCount() - start;
  }
  EXPECT_EQ(test::AllocationCount() - before - editing, 0u);
  EXPECT_GT(run.Loop.Latest().DrillVersion, 50u);
}
} // namespace
} // namespace palpate::drill_does_not_allocate_test
