#include "ElasticCases.h"
#include "ModelFile.h"
#include "WindowTest.h"
#include "YieldingSurface.h"

#include "vtkPointData.h"
#include "vtkProbeRepresentation.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace palpate::yielding_structure_test
{
namespace
{
// A ball of 15 mm like the phantom's, of 20 kPa, with a harder one inside on its left; its modulus
// `inclusion` in N/mm^2.
ModelDocument BallWith(double inclusion, double radius = 4.0, double center = -6.0)
{
  test::ElasticCase organ;
  organ.Model = {0, {15.0 * std::sqrt(4.0 * Pi)}, Vector3(-15.0, 0.0, 0.0)};
  organ.Solid.Tissue.AddInclusion(test::BallFraction(Vector3(center, 0.0, 0.0), radius), inclusion);
  organ.Build(8, 10);
  ComplianceMaps maps;
  const Status status =
      ComplianceMaps::Fit(organ.Model, organ.Solid, organ.Reduced, {12, 0.0}, {}, maps);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return ModelDocument{organ.Model, {}, std::make_shared<const ComplianceMaps>(maps)};
}

const ModelDocument& SoftBall()
{
  static const ModelDocument ball = BallWith(0.2);
  return ball;
}

std::unique_ptr<YieldingSurface> DrawnBall()
{
  return std::make_unique<YieldingSurface>(std::get<RadialModel>(SoftBall().Surface),
                                           SoftBall().Elasticity);
}

std::vector<Vector3> PointsOf(vtkPolyData* surface)
{
  std::vector<Vector3> points;
  for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
  {
    points.emplace_back(surface->GetPoint(p));
  }
  return points;
}

// Least distance (mm) of a surface's points from a place.
double DistanceFrom(const Vector3& place, vtkPolyData* surface)
{
  double least = 1e9;
  for (const Vector3& point : PointsOf(surface))
  {
    least = std::min(least, (point - place).norm());
  }
  return least;
}

TEST(YieldingSurface, FollowsTheBallAndComesBack)
{
  const auto drawn = DrawnBall();
  const auto rest = PointsOf(drawn->Surface());
  const Vector3 top(-15.0, 15.0, 0.0);
  drawn->Press(top + Vector3(0.0, 4.0, 0.0), top + Vector3(0.0, 2.0, 0.0), 4.0);
  EXPECT_NEAR(DistanceFrom(top + Vector3(0.0, 2.0, 0.0), drawn->Surface()), 4.0, 1e-3);
  drawn->Release();
  const auto back = PointsOf(drawn->Surface());
  for (std::size_t p = 0; p < rest.size(); ++p)
  {
    EXPECT_LT((back[p] - rest[p]).norm(), 1e-4) << "coordinates are single";
  }
}

// Also where it is not known from where the ball came, and it only comes near.
TEST(YieldingSurface, BallFromOutsideMakesTheSameDent)
{
  const auto drawn = DrawnBall();
  const auto rest = PointsOf(drawn->Surface());
  const Vector3 proxy(-15.0, 0.0, 19.0);
  const Vector3 probe(-15.0, 0.0, 17.5);
  drawn->Press(proxy, probe, 4.0);
  const auto dented = PointsOf(drawn->Surface());
  drawn->Press(probe, 4.0);
  const auto again = PointsOf(drawn->Surface());
  drawn->Press(proxy + Vector3(0.0, 0.0, 0.5), 4.0);
  const auto left = PointsOf(drawn->Surface());
  for (std::size_t p = 0; p < rest.size(); ++p)
  {
    EXPECT_LT((again[p] - dented[p]).norm(), 1e-4) << "coordinates are single";
    EXPECT_LT((left[p] - rest[p]).norm(), 1e-4);
  }
}

TEST(YieldingSurface, NormalsAreUnitAndTiltAroundTheDent)
{
  const auto drawn = DrawnBall();
  const Vector3 top(-15.0, 15.0, 0.0);
  drawn->Press(top + Vector3(0.0, 4.0, 0.0), top + Vector3(0.0, 2.0, 0.0), 4.0);
  vtkDataArray* normals = drawn->Surface()->GetPointData()->GetNormals();
  double most = 0.0;
  for (vtkIdType p = 0; p < normals->GetNumberOfTuples(); ++p)
  {
    const Vector3 normal(normals->GetTuple(p));
    const Vector3 atRest =
        (Vector3(drawn->Surface()->GetPoint(p)) - Vector3(-15.0, 0.0, 0.0)).normalized();
    EXPECT_NEAR(normal.norm(), 1.0, 1e-5);
    most = std::max(most, std::acos(std::clamp(normal.dot(atRest), -1.0, 1.0)));
    if (drawn->Surface()->GetPoint(p)[1] < -5.0) // the other side
    {
      EXPECT_GT(normal.dot(atRest), 0.999);
    }
  }
  EXPECT_GT(most, 0.25) << "rad, of a ball half its radius deep";
}

TEST(YieldingSurface, MapsTheHarderSide)
{
  const auto drawn = DrawnBall();
  EXPECT_EQ(drawn->Surface()->GetPointData()->GetArray(YieldingSurface::StiffnessArray), nullptr);
  drawn->MapStiffness(4.0);
  vtkDataArray* noticed =
      drawn->Surface()->GetPointData()->GetArray(YieldingSurface::StiffnessArray);
  ASSERT_NE(noticed, nullptr);
  vtkIdType hardest = 0;
  for (vtkIdType p = 0; p < noticed->GetNumberOfTuples(); ++p)
  {
    hardest = noticed->GetTuple1(p) > noticed->GetTuple1(hardest) ? p : hardest;
  }
  EXPECT_GT(noticed->GetTuple1(hardest), 1.0);
  EXPECT_GT(drawn->Surface()->GetPoint(hardest)[0], -3.0) << "the patient's left";
}

class YieldingStructureTest : public test::WindowTest
{
protected:
  // The phantom with the soft ball instead of its structures.
  void OpenSoftBall(const ModelDocument& ball = SoftBall())
  {
    this->OpenPhantom();
    const auto file = this->Phantom.Folder / "soft.json";
    WriteModel(file, ball);
    StudyState next = this->Study->State();
    next.Structures.resize(1);
    next.Structures[0].File = file;
    next.Structures[0].Labels.clear();
    next.Tool.Kind = TouchToolSettings::Shape::Sphere;
    next.Tool.Radius = 4.0;
    this->Study->Change("Open a soft ball", next);
    this->Settle();
    DrawAll(*this->Window->Views());
  }
  // Newtons per millimetre, by the text beside the tool.
  double StiffnessRead() const
  {
    vtkPropCollection* props = this->Window->Views()->Space()->Renderer()->GetViewProps();
    for (int p = 0; p < props->GetNumberOfItems(); ++p)
    {
      auto* text = vtkTextActor::SafeDownCast(props->GetItemAsObject(p));
      double force = 0.0;
      double depth = 0.0;
      if (text != nullptr && text->GetInput() != nullptr &&
          std::sscanf(text->GetInput(), " %lf N, %lf mm deep", &force, &depth) == 2 && depth > 0.0)
      {
        return force / depth;
      }
    }
    return 0.0;
  }
  // Pushes there by the wheel, reads, and lifts.
  double PushAt(const QPointF& place)
  {
    QWidget* canvas = this->Window->Views()->Space()->Canvas();
    Move(canvas, place);
    constexpr int Notches = 8;
    for (int notch = 0; notch < Notches; ++notch)
    {
      Wheel(canvas, place, 1);
    }
    this->FeelUntil([this] { return this->Study->Reading().TouchedId == 1; });
    this->WaitForSteadyForce();
    DrawAll(*this->Window->Views());
    const double read = this->StiffnessRead();
    for (int notch = 0; notch < Notches; ++notch)
    {
      Wheel(canvas, place, -1);
    }
    this->FeelUntil([this] { return this->Study->Reading().TouchedId == 0; });
    return read;
  }
  // For half a second.
  void WaitForSteadyForce()
  {
    constexpr double Steady = 2e-3; // N, below what is written
    std::uint64_t since = this->Study->Reading().Newest.Tick.Number;
    double force = 0.0;
    this->FeelUntil(
        [&]
        {
          const TouchState& now = this->Study->Reading().Newest;
          if (std::abs(test::Norm(now.ForceWorld) - force) > Steady)
          {
            force = test::Norm(now.ForceWorld);
            since = now.Tick.Number;
          }
          return now.Tick.Number > since + 500;
        });
  }
  vtkSurfaceDisplay* Shown() const { return this->Window->Contents().Surfaces().at(1); }
};

TEST_F(YieldingStructureTest, DentIsShownWhereTheToolIs)
{
  this->OpenSoftBall();
  this->BeginTouch();
  this->Press({-15.0, 0.0, 0.0}, 0.2);
  DrawAll(*this->Window->Views());
  const TouchState& newest = this->Study->Reading().Newest;
  EXPECT_GT(newest.PatchRadius, 0.5);
  EXPECT_GT(newest.ElasticEnergy, 0.0);
  ASSERT_GT(newest.Depth, 0.5);
  const Vector3 shown = this->Window->Contents().Probe()->ProxyWorld();
  EXPECT_NEAR(DistanceFrom(shown, this->Shown()->GetSurface()), 4.0, 0.05)
      << "the drawn dent is as exact as that";
  this->Button("start-touch")->click(); // which stops it now
  WaitUntil([this] { return !this->Study->IsTouching(); });
  for (const Vector3& point : PointsOf(this->Shown()->GetSurface()))
  {
    EXPECT_NEAR((point - Vector3(-15.0, 0.0, 0.0)).norm(), 15.0, 1e-3);
  }
}

// Two that the tool is between: no wall is drawn in the tool.
TEST_F(YieldingStructureTest, EachStructureHasItsDent)
{
  this->OpenSoftBall();
  const auto file = this->Phantom.Folder / "second.json";
  ModelDocument second = SoftBall();
  auto& moved = std::get<RadialModel>(second.Surface);
  moved = {0, {15.0 * std::sqrt(4.0 * Pi)}, Vector3(-15.0, 36.0, 0.0)};
  WriteModel(file, second);
  StudyState next = this->Study->State();
  next.Structures.push_back(next.Structures[0]);
  next.Structures[1].Id = 2;
  next.Structures[1].Name = "Second";
  next.Structures[1].File = file;
  this->Study->Change("Add a second one", next);
  this->Settle();
  StudyTouchReading between;
  between.TouchedId = 1;
  between.Newest.HasSample = true;
  between.Newest.Structure = 0;
  between.Newest.ProbeWorld = Vector3(-15.0, 17.8, 0.0);
  between.Newest.ProxyWorld = Vector3(-15.0, 19.0, 0.0);
  ViewContents shown;
  shown.Show(this->Study->State(), this->Study->Current().Pipeline());
  shown.ShowTouch(between, true);
  for (const int id : {1, 2})
  {
    vtkPolyData* drawn = shown.Surfaces().at(id)->GetSurface();
    EXPECT_NEAR(DistanceFrom(between.Newest.ProbeWorld, drawn), 4.0, 0.05) << "structure " << id;
  }
}

TEST_F(YieldingStructureTest, RigidRepresentationHasNoDent)
{
  this->OpenSoftBall();
  StudyState next = this->Study->State();
  next.Structures[0].Representation = TouchRepresentation::Harmonics;
  this->Study->Change("Make it rigid", next);
  this->BeginTouch();
  this->Press({-15.0, 0.0, 0.0}, 0.2);
  DrawAll(*this->Window->Views());
  EXPECT_EQ(this->Study->Reading().Newest.PatchRadius, 0.0);
  for (const Vector3& point : PointsOf(this->Shown()->GetSurface()))
  {
    EXPECT_NEAR((point - Vector3(-15.0, 0.0, 0.0)).norm(), 15.0, 1e-3);
  }
}

TEST_F(YieldingStructureTest, StiffnessMapColoursTheSurface)
{
  this->OpenSoftBall();
  StudyState next = this->Study->State();
  next.Structures[0].Appearance = SceneAppearance::StiffnessMap;
  this->Study->Change("Show stiffness", next);
  this->Settle();
  DrawAll(*this->Window->Views());
  EXPECT_STREQ(this->Shown()->GetColorArray(), YieldingSurface::StiffnessArray);
  EXPECT_NE(this->Shown()->GetSurface()->GetPointData()->GetArray(YieldingSurface::StiffnessArray),
            nullptr);
}

// A lesion of 3 : 1 and 10 mm, 2 mm below the surface, by someone who feels nothing and reads what
// is drawn.
TEST_F(YieldingStructureTest, LesionIsFoundByWhatIsDrawn)
{
  this->OpenSoftBall(BallWith(0.06, 5.0, -7.0));
  this->Window->Views()->Space()->LookFrom(vtkSpaceView::LEFT);
  this->BeginTouch();
  const Vector3 center(-15.0, 0.0, 0.0);
  const auto read = [&](double y, double z)
  { return this->PushAt(this->PlaceOf(center + 15.0 * Vector3(1.0, y, z).normalized())); };
  const double over = read(0.0, 0.0);
  for (const Vector3& beside : {Vector3(0.0, 0.8, 0.0), Vector3(0.0, -0.8, 0.0),
                                Vector3(0.0, 0.0, 0.8), Vector3(0.0, 0.0, -0.8)})
  {
    const double soft = read(beside.y(), beside.z());
    ASSERT_GT(soft, 0.0);
    // Three times what the last digits of the text could make.
    EXPECT_GT(over, 1.04 * soft) << beside.transpose();
  }
}
} // namespace
} // namespace palpate::yielding_structure_test
