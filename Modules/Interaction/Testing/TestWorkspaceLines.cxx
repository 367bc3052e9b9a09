#include "WorkspaceLines.h"

#include "vtkWorkspaceRepresentation.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <array>
#include <gtest/gtest.h>
#include <limits>

namespace palpate
{
namespace
{
// A box of 20 x 10 x 6 mm around (1, 2, 3), and a slice perpendicular to z.
class WorkspaceLinesTest : public testing::Test
{
protected:
  void SetUp() override
  {
    for (int c = 0; c < 8; ++c)
    {
      const auto at = [c](int bit, double low, double high) { return (c & bit) != 0 ? high : low; };
      double* corner = this->Corners.data() + 3 * c;
      corner[0] = at(1, -9.0, 11.0);
      corner[1] = at(2, -3.0, 7.0);
      corner[2] = at(4, 0.0, 6.0);
    }
    this->Workspace->SetCorners(this->Corners.data());
    this->Workspace->VisibilityOn();
    this->Slice.Frame.RightWorld = Vector3::UnitX();
    this->Slice.Frame.UpWorld = Vector3::UnitY();
    this->Slice.Frame.TowardsViewerWorld = Vector3::UnitZ();
  }
  // Total length of the drawn lines.
  double Length() const
  {
    vtkPolyData* data = this->Lines.Drawn().Data();
    vtkNew<vtkIdList> ids;
    double length = 0.0;
    data->GetLines()->InitTraversal();
    while (data->GetLines()->GetNextCell(ids) != 0)
    {
      for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
      {
        Vector3 from;
        Vector3 to;
        data->GetPoint(ids->GetId(i), from.data());
        data->GetPoint(ids->GetId(i + 1), to.data());
        length += (to - from).norm();
      }
    }
    return length;
  }
  bool IsShown() const { return this->Lines.Drawn().Actor()->GetVisibility() != 0; }

  std::array<double, 24> Corners{};
  vtkNew<vtkWorkspaceRepresentation> Workspace;
  WorkspaceLines Lines;
  SlicePosition Slice;
};

TEST_F(WorkspaceLinesTest, DrawsTwelveEdgesIn3D)
{
  this->Lines.Update(this->Workspace);
  EXPECT_TRUE(this->IsShown());
  EXPECT_NEAR(this->Length(), 4.0 * (20.0 + 10.0 + 6.0), 1e-4); // points are floats
}

TEST_F(WorkspaceLinesTest, DrawsOutlineInSlice)
{
  this->Slice.CenterWorld = Vector3(0.0, 0.0, 2.5);
  this->Lines.Update(this->Workspace, this->Slice);
  EXPECT_NEAR(this->Length(), 2.0 * (20.0 + 10.0), 1e-4);
  this->Slice.CenterWorld = Vector3(0.0, 0.0, 6.5);
  this->Lines.Update(this->Workspace, this->Slice);
  EXPECT_EQ(this->Length(), 0.0);
}

TEST_F(WorkspaceLinesTest, HidesUnknownWorkspace)
{
  this->Lines.Update(nullptr);
  EXPECT_FALSE(this->IsShown());
  this->Workspace->VisibilityOff();
  this->Lines.Update(this->Workspace, this->Slice);
  EXPECT_FALSE(this->IsShown());
}

TEST_F(WorkspaceLinesTest, OnlyNewCornersModifyIt)
{
  const vtkMTimeType before = this->Workspace->GetMTime();
  this->Workspace->SetCorners(this->Corners.data());
  this->Corners[5] = std::numeric_limits<double>::quiet_NaN();
  this->Workspace->SetCorners(this->Corners.data());
  EXPECT_EQ(this->Workspace->GetMTime(), before);
  this->Corners[5] = 1.0;
  this->Workspace->SetCorners(this->Corners.data());
  EXPECT_GT(this->Workspace->GetMTime(), before);
}
} // namespace
} // namespace palpate
