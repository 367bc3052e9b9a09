#include "BodyBenchmarks.h"

#include "ComparedBody.h"
#include "IcosahedronDirections.h"

#include "vtkCellArray.h"
#include "vtkImplicitPolyDataDistance.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <cmath>
#include <memory>

namespace palpate::bench
{
namespace
{
// An organ's mask in voxels of 0.5 x 0.5 x 3 mm, and points near its boundary.
struct BodyCase
{
  BodyCase()
  {
    VoxelMask mask;
    mask.Size = {110, 100, 16};
    mask.Spacing = {0.5, 0.5, 3.0};
    this->ToWorld.Axes = Vector3(0.5, 0.5, 3.0).asDiagonal();
    const Vector3 center(27.0, 25.0, 22.5);
    const Vector3 semiAxes(24.0, 20.0, 19.0);
    for (int k = 0; k < mask.Size[2]; ++k)
    {
      for (int j = 0; j < mask.Size[1]; ++j)
      {
        for (int i = 0; i < mask.Size[0]; ++i)
        {
          const Vector3 point = this->ToWorld(Vector3(i, j, k)) - center;
          mask.Inside.push_back(point.cwiseQuotient(semiAxes).norm() < 1.0 ? 1 : 0);
        }
      }
    }
    this->IsMade = ComparedBody::OfMask(std::move(mask), this->ToWorld, this->Body).IsOk();
    const IcosahedronDirections sphere(20);
    for (const Vector3& u : sphere.Directions())
    {
      this->Points.emplace_back(center + 1.03 * semiAxes.cwiseProduct(u));
    }
    this->Judge->SetInput(this->Surface());
  }

  vtkSmartPointer<vtkPolyData> Surface() const
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vector3& point : this->Body.Surface().Points)
    {
      points->InsertNextPoint(point.data());
    }
    vtkNew<vtkCellArray> triangles;
    for (const std::array<int, 3>& t : this->Body.Surface().Triangles)
    {
      triangles->InsertNextCell({t[0], t[1], t[2]});
    }
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    surface->SetPoints(points);
    surface->SetPolys(triangles);
    return surface;
  }

  void Run() { this->IsMade &= this->Body.DistancesOf(this->Points, {}, this->Found).IsOk(); }
  void RunAgainst()
  {
    this->Expected.clear();
    for (Vector3 point : this->Points)
    {
      this->Expected.push_back(this->Judge->EvaluateFunction(point.data()));
    }
  }

  // Without signs: VTK's are wrong at some edges of the voxels' steps.
  std::string Disagreement() const
  {
    for (std::size_t i = 0; i < this->Expected.size(); ++i)
    {
      if (!this->IsMade ||
          !(std::abs(std::abs(this->Found[i]) - std::abs(this->Expected[i])) < 1e-4))
      {
        return "the distances of point " + std::to_string(i) + " differ";
      }
    }
    return {};
  }

  IndexToWorld ToWorld;
  ComparedBody Body;
  std::vector<Vector3> Points;
  std::vector<double> Found;
  std::vector<double> Expected;
  vtkNew<vtkImplicitPolyDataDistance> Judge;
  bool IsMade = false;
};
} // namespace

std::vector<PairedBenchmark> BodyBenchmarks()
{
  const auto body = std::make_shared<BodyCase>();
  PairedBenchmark distances;
  distances.Name = "compare/distances/" + std::to_string(body->Points.size());
  distances.Against = "vtkImplicitPolyDataDistance";
  distances.Run = [body] { body->Run(); };
  distances.RunAgainst = [body] { body->RunAgainst(); };
  distances.Disagreement = [body] { return body->Disagreement(); };
  distances.Items = static_cast<double>(body->Points.size());
  return {distances};
}
} // namespace palpate::bench
