#include "ErrorLog.h"
#include "ModelTable.h"
#include "vtkElasticSurface.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace palpate::vtk_elastic_surface_test
{
namespace
{
class ElasticSurfaceTest : public testing::Test
{
protected:
  void SetUp() override
  {
    ToTable({0, {25.0 * std::sqrt(4.0 * 3.14159265358979323846)}, Vector3(1.0, 2.0, 3.0)},
            this->Table);
    this->Filter->SetInputData(this->Table);
    this->Filter->SetElementsAcross(6);
    this->Filter->SetFrequency(12);
  }
  vtkPolyData* Output()
  {
    this->Filter->Update();
    return this->Filter->GetOutput();
  }
  double BallForce()
  {
    return Vector3(this->Output()->GetFieldData()->GetArray("BallForce")->GetTuple(0)).norm();
  }

  vtkNew<vtkTable> Table;
  vtkNew<vtkElasticSurface> Filter;
};

TEST_F(ElasticSurfaceTest, DentsTheSideThatIsPressed)
{
  this->Filter->SetBallDepth(2.0);
  double lowest = 1e9;
  double other = 1e9;
  for (vtkIdType p = 0; p < this->Output()->GetNumberOfPoints(); ++p)
  {
    const Vector3 from = Vector3(this->Output()->GetPoint(p)) - Vector3(1.0, 2.0, 3.0);
    double& least = from.y() > 0.9 * from.norm() ? lowest : other;
    least = std::min(least, from.norm());
  }
  EXPECT_NEAR(lowest, 23.0, 0.2);
  EXPECT_GT(other, 24.0);
  EXPECT_GT(this->BallForce(), 0.05);
}

TEST_F(ElasticSurfaceTest, StifferImagePushesHarder)
{
  this->Filter->SetBallDepth(2.0);
  const double soft = this->BallForce();
  vtkNew<vtkImageData> moduli;
  moduli->SetDimensions(3, 3, 3);
  moduli->SetOrigin(-49.0, -48.0, -47.0);
  moduli->SetSpacing(50.0, 50.0, 50.0);
  moduli->AllocateScalars(VTK_FLOAT, 1);
  moduli->GetPointData()->GetScalars()->Fill(60.0);
  this->Filter->SetModulusData(moduli);
  // The support yields too.
  EXPECT_GT(this->BallForce(), 2.0 * soft);
}

TEST_F(ElasticSurfaceTest, FeltForceIsEvenOnASphere)
{
  double range[2];
  this->Output()->GetPointData()->GetArray("Force")->GetRange(range);
  EXPECT_GT(range[0], 0.0);
  EXPECT_LT(range[1], 1.1 * range[0]);
  this->Output()->GetPointData()->GetArray("NoticedStiffness")->GetRange(range);
  EXPECT_LT(std::max(-range[0], range[1]), 1.0);
}

TEST_F(ElasticSurfaceTest, AnotherDentDoesNotSoftenAgain)
{
  this->Output();
  vtkNew<vtkCallbackCommand> count;
  int reports = 0;
  count->SetClientData(&reports);
  count->SetCallback([](vtkObject*, unsigned long, void* number, void*)
                     { ++*static_cast<int*>(number); });
  this->Filter->AddObserver(vtkCommand::ProgressEvent, count);
  this->Filter->SetBallDepth(1.0);
  this->Output();
  const int drawn = reports;
  this->Filter->SetTissueModulus(30.0);
  this->Output();
  EXPECT_LE(drawn, 3) << "the start, the end";
  EXPECT_GT(reports - drawn, 10);
}

TEST_F(ElasticSurfaceTest, OtherTablesAreErrors)
{
  const test::ErrorLog errors(this->Filter);
  vtkNew<vtkTable> empty;
  this->Filter->SetInputData(empty);
  EXPECT_EQ(this->Output()->GetNumberOfPoints(), 0);
  EXPECT_FALSE(errors.IsEmpty());
}
} // namespace
} // namespace palpate::vtk_elastic_surface_test
