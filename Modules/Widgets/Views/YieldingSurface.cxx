#include "YieldingSurface.h"

#include "FeltStiffness.h"
#include "IcosahedronDirections.h"
#include "ModelSurface.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <cstddef>
#include <utility>

namespace palpate
{
namespace
{
constexpr int Frequency = 30; // triangles of about 1 mm on a gland, so that none cuts into a ball
}

YieldingSurface::YieldingSurface(const RadialModel& model,
                                 std::shared_ptr<const ComplianceMaps> maps)
    : Model(model), Compliance(std::move(maps)), Drawn(vtkSmartPointer<vtkPolyData>::New())
{
  const IcosahedronDirections sphere(Frequency);
  this->Directions = sphere.Directions();
  this->Triangles = sphere.Triangles();
  this->Drawn->DeepCopy(DrawModel(OrganModel(model), Frequency));
  vtkDataArray* normals = this->Drawn->GetPointData()->GetNormals();
  std::vector<Vector3> points;
  for (vtkIdType p = 0; p < this->Drawn->GetNumberOfPoints(); ++p)
  {
    points.emplace_back(this->Drawn->GetPoint(p));
    this->RestNormals.emplace_back(normals->GetTuple(p));
  }
  this->RestOfTriangles = this->NormalsOf(points);
  if (!this->Compliance->LongWaves.IsEmpty())
  {
    this->Dented =
        std::make_unique<DentedSurface>(this->Model, *this->Compliance, this->Directions);
  }
}

void YieldingSurface::Press(const Vector3& proxyWorld, const Vector3& probeWorld, double ballRadius)
{
  constexpr double Above = 0.01; // mm
  const Vector3 push = proxyWorld - probeWorld;
  if (push.norm() > 0.0 && this->HasHand(ballRadius))
  {
    this->PressFrom(proxyWorld + Above * push.normalized(), probeWorld);
  }
  else
  {
    this->Release();
  }
}

void YieldingSurface::Press(const Vector3& probeWorld, double ballRadius)
{
  const Vector3 center = this->Model.CenterWorld();
  const Vector3 from = probeWorld - center;
  if (!(from.norm() > 0.0) || !this->HasHand(ballRadius))
  {
    this->Release();
    return;
  }
  const double outside = this->Farthest + 2.0 * ballRadius;
  this->PressFrom(center + std::max(1.0, outside / from.norm()) * from, probeWorld);
}

// Whether the dent of such a ball can be drawn.
bool YieldingSurface::HasHand(double ballRadius)
{
  if (this->Dented == nullptr || !(ballRadius > 0.0))
  {
    return false;
  }
  if (this->Hand != nullptr && this->HandRadius == ballRadius)
  {
    return true;
  }
  std::shared_ptr<const TouchableRadialModel> surface;
  const Status status =
      TouchableRadialModel::Make(std::make_shared<const RadialModel>(this->Model), surface);
  if (!status.IsOk())
  {
    return false;
  }
  this->Hand = std::make_unique<ElasticTracker>(
      surface, std::make_shared<const ComplianceAtlas>(*this->Compliance), ballRadius,
      SurfaceFriction());
  this->HandRadius = ballRadius;
  this->Farthest = surface->LargestRadius();
  return true;
}

// As the hand does that is drawn.
void YieldingSurface::PressFrom(const Vector3& startWorld, const Vector3& probeWorld)
{
  this->Hand->Release();
  this->Hand->Follow({startWorld, Eigen::Quaterniond::Identity()});
  if (!this->Hand->Follow({probeWorld, Eigen::Quaterniond::Identity()}).IsTouching)
  {
    this->Release();
    return;
  }
  const PressedPlace* places = this->Hand->Places();
  this->Move(this->Dented->PointsWorld(
      {probeWorld, this->HandRadius, {places, places + this->Hand->PlaceCount()}}));
  this->IsPressed = true;
}

void YieldingSurface::Release()
{
  if (this->IsPressed)
  {
    this->Move(this->Dented->RestWorld());
    this->IsPressed = false;
  }
}

// Normals turn as those of the triangles do: so the surface stays smooth, and does not change where
// it does not move.
void YieldingSurface::Move(const std::vector<Vector3>& points)
{
  const std::vector<Vector3> ofTriangles = this->NormalsOf(points);
  vtkPoints* drawn = this->Drawn->GetPoints();
  vtkDataArray* normals = this->Drawn->GetPointData()->GetNormals();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto p = static_cast<vtkIdType>(i);
    const Vector3 normal =
        (this->RestNormals[i] + ofTriangles[i] - this->RestOfTriangles[i]).normalized();
    drawn->SetPoint(p, points[i].data());
    normals->SetTuple(p, normal.data());
  }
  drawn->Modified();
  normals->Modified();
  this->Drawn->Modified();
}

std::vector<Vector3> YieldingSurface::NormalsOf(const std::vector<Vector3>& points) const
{
  std::vector<Vector3> normals(points.size(), Vector3::Zero());
  for (const auto& [a, b, c] : this->Triangles)
  {
    const Vector3& first = points[static_cast<std::size_t>(a)];
    const Vector3 area = (points[static_cast<std::size_t>(b)] - first)
                             .cross(points[static_cast<std::size_t>(c)] - first);
    for (const int corner : {a, b, c})
    {
      normals[static_cast<std::size_t>(corner)] += area;
    }
  }
  for (Vector3& normal : normals)
  {
    normal.normalize();
  }
  return normals;
}

void YieldingSurface::MapStiffness(double ballRadius)
{
  if (!(ballRadius > 0.0) || ballRadius == this->MappedRadius)
  {
    return;
  }
  this->MappedRadius = ballRadius;
  const FeltStiffness felt =
      FeltStiffness::Of(this->Model, *this->Compliance, ballRadius, this->Directions);
  vtkNew<vtkFloatArray> values;
  values->SetName(StiffnessArray);
  for (const double noticed : felt.Noticed)
  {
    values->InsertNextValue(static_cast<float>(noticed));
  }
  this->Drawn->GetPointData()->AddArray(values);
  this->Drawn->Modified();
}
} // namespace palpate
