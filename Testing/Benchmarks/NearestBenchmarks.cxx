#include "NearestBenchmarks.h"

#include "ClosestPointSearch.h"
#include "IcosahedronDirections.h"
#include "RandomShapes.h"
#include "SurfaceCurvature.h"

#include "vtkCellArray.h"
#include "vtkCurvatures.h"
#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkImplicitPolyDataDistance.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

namespace palpate::bench
{
namespace
{
constexpr int NearestTicks = 4000;

std::shared_ptr<const RadialModel> MakeModel()
{
  test::Random random(12);
  return std::make_shared<const RadialModel>(test::RandomOrgan(random, 12));
}

// A probe that slides over the surface, 0.05 mm per tick: 50 mm/s at 1 kHz.
std::vector<Vector3> MakePath(const RadialModel& model)
{
  test::Random random(14);
  std::vector<Vector3> path;
  Vector3 query = model.PointWorld(Vector3::UnitX());
  Vector3 velocity = test::RandomDirection(random);
  while (path.size() < NearestTicks)
  {
    const Vector3 outwards = query - model.CenterWorld();
    const Vector3 u = outwards.normalized();
    const double ratio = outwards.norm() / model.Radius(u);
    const double back = ratio > 1.1 ? -0.2 : ratio < 0.95 ? 0.2 : 0.0;
    velocity = (velocity + back * u + 0.05 * test::RandomDirection(random)).normalized();
    query += 0.05 * velocity;
    path.push_back(query);
  }
  return path;
}

void MakeMesh(const RadialModel& model, vtkPolyData* mesh)
{
  const IcosahedronDirections sphere(20);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector3& u : sphere.Directions())
  {
    points->InsertNextPoint(model.PointWorld(u).data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& [a, b, c] : sphere.Triangles())
  {
    triangles->InsertNextCell({a, b, c});
  }
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
}

// Largest difference; infinite once one is NaN.
double Worst(const std::vector<double>& a, const std::vector<double>& b)
{
  double worst = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const double difference = std::abs(a[i] - b[i]);
    worst = std::isnan(difference) ? INFINITY : std::max(worst, difference);
  }
  return worst;
}

class NearestCase
{
public:
  NearestCase()
      : Search(MakeModel()), Path(MakePath(Search.Model())), Start(Search.Nearest(Path.front())),
        Ours(Path.size()), Theirs(Path.size())
  {
    MakeMesh(this->Search.Model(), this->Mesh);
    this->Locator->SetDataSet(this->Mesh);
    this->Locator->BuildLocator();
    this->Distance->SetInput(this->Mesh);
  }

  void Track()
  {
    ClosestPoint point = this->Start;
    for (std::size_t i = 0; i < this->Path.size(); ++i)
    {
      point = this->Search.Track(this->Path[i], point);
      this->Ours[i] = std::abs(point.SignedDistance);
    }
  }
  void Locate()
  {
    for (std::size_t i = 0; i < this->Path.size(); ++i)
    {
      double found[3];
      vtkIdType triangle = 0;
      int part = 0;
      double square = 0.0;
      this->Locator->FindClosestPoint(this->Path[i].data(), found, this->Cell, triangle, part,
                                      square);
      this->Theirs[i] = std::sqrt(square);
    }
  }
  // Tracking by VTK: no farther than the last point found.
  void LocateFromLast()
  {
    Vector3 last = Vector3(this->Start.PointWorld);
    for (std::size_t i = 0; i < this->Path.size(); ++i)
    {
      Vector3 query = this->Path[i];
      const double radius =
          (query - last).norm() * (1.0 + 1e-9) + 0.1; // facets are off the surface
      vtkIdType triangle = 0;
      int part = 0;
      double square = 0.0;
      this->Locator->FindClosestPointWithinRadius(query.data(), radius, last.data(), this->Cell,
                                                  triangle, part, square);
      this->Theirs[i] = std::sqrt(square);
    }
  }
  void FindNearest()
  {
    for (std::size_t i = 0; i < this->Path.size(); ++i)
    {
      this->Ours[i] = this->Search.Nearest(this->Path[i]).SignedDistance;
    }
  }
  void FindSignedDistance()
  {
    for (std::size_t i = 0; i < this->Path.size(); ++i)
    {
      this->Theirs[i] = this->Distance->EvaluateFunction(this->Path[i].data());
    }
  }

  // The facets lie up to some hundredths of a millimetre inside the surface.
  std::string Disagreement() const
  {
    const double worst = Worst(this->Ours, this->Theirs);
    if (worst <= 0.1)
    {
      return {};
    }
    std::ostringstream text;
    text << "distances differ by " << worst << " mm";
    return text.str();
  }

private:
  ClosestPointSearch Search;
  std::vector<Vector3> Path;
  ClosestPoint Start;
  std::vector<double> Ours;
  std::vector<double> Theirs;
  vtkNew<vtkPolyData> Mesh;
  vtkNew<vtkStaticCellLocator> Locator;
  vtkNew<vtkGenericCell> Cell;
  vtkNew<vtkImplicitPolyDataDistance> Distance;
};

class CurvatureCase
{
public:
  CurvatureCase()
      : Model(MakeModel()), Directions(IcosahedronDirections(20).Directions()),
        Ours(Directions.size()), Theirs(Directions.size())
  {
    MakeMesh(*this->Model, this->Mesh);
  }

  void Evaluate()
  {
    for (std::size_t i = 0; i < this->Directions.size(); ++i)
    {
      const Vector3& u = this->Directions[i];
      this->Ours[i] = CurvatureAt(u, this->Model->EvaluateSecondOrder(u)).Mean;
    }
  }
  void EvaluateMesh()
  {
    vtkNew<vtkCurvatures> curvatures;
    curvatures->SetInputData(this->Mesh);
    curvatures->SetCurvatureTypeToMean();
    curvatures->Update();
    vtkDataArray* mean = curvatures->GetOutput()->GetPointData()->GetArray("Mean_Curvature");
    for (std::size_t i = 0; i < this->Theirs.size(); ++i)
    {
      this->Theirs[i] = mean->GetTuple1(static_cast<vtkIdType>(i));
    }
  }

  std::string Disagreement() const
  {
    const double worst = Worst(this->Ours, this->Theirs);
    // The mesh's is an estimate; the curvatures are around 0.05 / mm.
    if (worst <= 0.02)
    {
      return {};
    }
    std::ostringstream text;
    text << "mean curvatures differ by " << worst << " / mm";
    return text.str();
  }

  double Items() const { return static_cast<double>(this->Directions.size()); }

private:
  std::shared_ptr<const RadialModel> Model;
  std::vector<Vector3> Directions;
  std::vector<double> Ours;
  std::vector<double> Theirs;
  vtkNew<vtkPolyData> Mesh;
};
} // namespace

std::vector<PairedBenchmark> NearestBenchmarks()
{
  const auto nearest = std::make_shared<NearestCase>();
  const auto curvature = std::make_shared<CurvatureCase>();
  const auto agree = [nearest] { return nearest->Disagreement(); };
  return {{"sh/nearest/degree12/warm",
           "vtkStaticCellLocator within the last distance, 8,000 triangles",
           [nearest] { nearest->Track(); }, [nearest] { nearest->LocateFromLast(); }, agree,
           NearestTicks},
          {"sh/nearest/degree12/cold", "vtkImplicitPolyDataDistance, 8,000 triangles",
           [nearest] { nearest->FindNearest(); }, [nearest] { nearest->FindSignedDistance(); },
           agree, NearestTicks},
          {"sh/curvature/degree12", "vtkCurvatures, 8,000 triangles",
           [curvature] { curvature->Evaluate(); }, [curvature] { curvature->EvaluateMesh(); },
           [curvature] { return curvature->Disagreement(); }, curvature->Items()}};
}
} // namespace palpate::bench
