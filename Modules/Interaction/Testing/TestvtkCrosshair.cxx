#include "vtkCrosshair.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::vtk_crosshair_test
{
namespace
{
// Counts the ModifiedEvents.
void Observe(vtkCrosshair* crosshair, int& count)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&count);
  command->SetCallback([](vtkObject*, unsigned long, void* counter, void*)
                       { ++*static_cast<int*>(counter); });
  crosshair->AddObserver(vtkCommand::ModifiedEvent, command);
}

TEST(vtkCrosshair, SignalsEachMoveOnce)
{
  vtkNew<vtkCrosshair> crosshair;
  int moves = 0;
  Observe(crosshair, moves);
  crosshair->SetPositionWorld(1.0, 2.0, 3.0);
  EXPECT_EQ(moves, 1);
  crosshair->SetPositionWorld(1.0, 2.0, 3.0);
  EXPECT_EQ(moves, 1);
}

TEST(vtkCrosshair, IgnoresNonFinitePosition)
{
  vtkNew<vtkCrosshair> crosshair;
  crosshair->SetPositionWorld(1.0, 2.0, 3.0);
  int moves = 0;
  Observe(crosshair, moves);
  crosshair->SetPositionWorld(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  crosshair->SetPositionWorld(0.0, std::numeric_limits<double>::infinity(), 0.0);
  EXPECT_EQ(moves, 0);
  EXPECT_EQ(crosshair->GetPositionWorld()[2], 3.0);
}
} // namespace
} // namespace palpate::vtk_crosshair_test
