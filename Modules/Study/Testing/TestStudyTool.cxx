#include "ForbiddenPhantom.h"
#include "ManualClock.h"
#include "MeshFormats.h"
#include "Study.h"
#include "SurfaceFile.h"

#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>
#include <thread>

namespace palpate::study_tool_test
{
namespace
{
// A study touched by a cube from a file.
class StudyToolTest : public testing::Test
{
protected:
  static RealtimeRequest Ordinary()
  {
    RealtimeRequest request;
    request.Priority = 0; // the servo runs as fast as it can, in virtual time
    return request;
  }
  void WriteCube(double side) const
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetXLength(side);
    cube->SetYLength(side);
    cube->SetZLength(side);
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputConnection(cube->GetOutputPort());
    triangles->Update();
    WriteSurface(this->File, triangles->GetOutput());
  }
  void SetUp() override
  {
    this->WriteCube(2.0);
    this->Open.OpenSegmentation(this->Phantom.File);
    this->Settle();
    StudyState next = this->Open.State();
    next.Tool.Kind = TouchToolSettings::Shape::Surface;
    next.Tool.File = this->File;
    next.Structures.at(0).Representation = TouchRepresentation::SubVoxel;
    this->Open.Change("Touch by a cube", next);
  }
  void Settle()
  {
    while (this->Open.Jobs().WaitForResult())
    {
      this->Open.Deliver();
    }
  }
  void ChangeStiffness(double stiffness)
  {
    StudyState next = this->Open.State();
    next.Structures.at(0).Stiffness = stiffness;
    this->Open.Change("Change the stiffness", next);
    EXPECT_EQ(this->Open.TouchProblem(), "");
  }
  std::uint64_t Scene() { return this->Open.Touch().Poll().Newest.Scene; }
  // Waits until the servo uses it; returns immediately if it was not published.
  void WaitForScene(std::uint64_t scene)
  {
    while (this->Scene() < scene && this->Open.TouchProblem().empty())
    {
      std::this_thread::yield();
    }
  }

  test::ForbiddenPhantom Phantom;
  std::filesystem::path File = Phantom.Folder / "cube.stl";
  ManualClock Time;
  Study Open{this->Time, Ordinary()};
};

TEST_F(StudyToolTest, ReadsFileOnceAndKeepsTheTool)
{
  this->Settle();
  const auto read = this->Open.Pipeline().Newest<SurfaceTool>(SceneStep::Tool);
  ASSERT_NE(read, nullptr);
  EXPECT_NE(this->Open.Pipeline().Newest<TouchCost>(SceneStep::Cost, 1), nullptr);
  this->Open.StartTouch();
  this->Settle();
  ASSERT_TRUE(this->Open.Touch().IsRunning()) << this->Open.TouchProblem();
  this->WaitForScene(1);
  const std::uint64_t started = this->Open.Pipeline().StartedCount();
  this->ChangeStiffness(1.0);
  this->WaitForScene(2);
  EXPECT_EQ(this->Open.Pipeline().StartedCount(), started);
  EXPECT_EQ(this->Open.Pipeline().Newest<SurfaceTool>(SceneStep::Tool), read);
  std::filesystem::remove(this->File);
  this->ChangeStiffness(1.5);
  this->WaitForScene(3);
  this->Settle();
  EXPECT_EQ(this->Open.Pipeline().StateOf(SceneStep::Tool).Is, StudyStepState::Kind::Failed);
  this->ChangeStiffness(2.0);
  this->WaitForScene(4);
}

TEST_F(StudyToolTest, ChangedFileGivesAnotherTool)
{
  this->Settle();
  const auto read = this->Open.Pipeline().Newest<SurfaceTool>(SceneStep::Tool);
  const auto cost = this->Open.Pipeline().Newest<TouchCost>(SceneStep::Cost, 1);
  this->WriteCube(3.0);
  std::filesystem::last_write_time(this->File, std::filesystem::last_write_time(this->File) +
                                                   std::chrono::seconds(2));
  this->ChangeStiffness(1.0);
  this->Settle();
  EXPECT_NE(this->Open.Pipeline().Newest<SurfaceTool>(SceneStep::Tool), read);
  EXPECT_NE(this->Open.Pipeline().Newest<TouchCost>(SceneStep::Cost, 1), cost);
}

TEST_F(StudyToolTest, TouchWaitsForTheTool)
{
  this->Settle();
  StudyState next = this->Open.State();
  std::filesystem::rename(this->File, this->Phantom.Folder / "moved.stl");
  next.Structures.at(0).Stiffness = 1.0;
  this->Open.Change("step", next);
  this->Settle();
  this->Open.StartTouch();
  this->Settle();
  EXPECT_FALSE(this->Open.Touch().IsRunning());
  EXPECT_NE(this->Open.TouchProblem().find("cube.stl"), std::string::npos)
      << this->Open.TouchProblem();
  this->Open.RelocateFile(this->File, this->Phantom.Folder / "moved.stl");
  this->Settle();
  this->Open.StartTouch();
  this->Settle();
  EXPECT_TRUE(this->Open.Touch().IsRunning()) << this->Open.TouchProblem();
}
} // namespace
} // namespace palpate::study_tool_test
