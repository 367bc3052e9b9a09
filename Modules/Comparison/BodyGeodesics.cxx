#include "BodyGeodesics.h"

#include "GeodesicDistances.h"
#include "InputError.h"
#include "KernelWatch.h"
#include "MeshConversion.h"
#include "Refusal.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::size_t MostForShortest = 150000; // triangles: some 20 s

void RequirePath(const Status& status, const KernelWatch& watch)
{
  watch.Require();
  if (!status.IsOk())
  {
    throw InputError(status.Message());
  }
}
} // namespace

BodyGeodesics::BodyGeodesics(const ComparedFile& file, const Segment& structure)
{
  Status status = Status::Success();
  if (const OrganModel* model = file.Model())
  {
    std::unique_ptr<const ModelPaths> made;
    status = ModelPaths::Make(*model, made);
    this->OnModel = std::move(made);
  }
  else
  {
    std::unique_ptr<const SurfacePaths> made;
    status = SurfacePaths::Make(file.Body(structure, MaskBody::Shape).Surface(), made);
    this->OnTriangles = std::move(made);
  }
  if (!status.IsOk())
  {
    Refuse(file.Path(), status.Message(), "measure another one");
  }
}

BodyGeodesics::Length BodyGeodesics::Find(const Vector3& from, const Vector3& to,
                                          const ProgressFunction& progress) const
{
  KernelWatch watch(progress, "measuring");
  Length length{};
  if (this->IsOnModel())
  {
    GeodesicCurve curve;
    RequirePath(this->OnModel->Find(from, to, watch.Of(0.0, 1.0), curve), watch);
    length.Along = curve.Length;
    length.Uncertainty = curve.Uncertainty;
    length.Points = std::move(curve.Points);
  }
  else
  {
    SurfacePaths::Path path;
    RequirePath(this->OnTriangles->Find(from, to, path), watch);
    SurfacePaths::Path other = path;
    if (this->OnTriangles->Mesh().Triangles.size() <= MostForShortest)
    {
      RequirePath(this->OnTriangles->FindShortest(from, to, watch.Of(0.0, 1.0), other), watch);
    }
    SurfacePaths::Path& shorter = other.Length < path.Length ? other : path;
    length.Along = shorter.Length;
    length.Points = std::move(shorter.Points);
  }
  length.From = length.Points.front();
  length.To = length.Points.back();
  length.Direct = (length.To - length.From).norm();
  return length;
}

vtkSmartPointer<vtkPolyData> BodyGeodesics::Map(const Vector3& from,
                                                const ProgressFunction& progress) const
{
  KernelWatch watch(progress, "measuring");
  std::vector<double> distances;
  const IndexedMesh& mesh =
      this->IsOnModel() ? this->OnModel->Drawing() : this->OnTriangles->Mesh();
  RequirePath(this->IsOnModel()
                  ? this->OnModel->Distances(from, watch.Of(0.0, 1.0), distances)
                  : FindGeodesicDistances(mesh, this->OnTriangles->Nearest().Find(from),
                                          watch.Of(0.0, 1.0), distances),
              watch);
  vtkSmartPointer<vtkPolyData> map = ToPolyData(mesh);
  vtkNew<vtkDoubleArray> array;
  array->SetName(MapName);
  array->SetNumberOfValues(static_cast<vtkIdType>(distances.size()));
  std::copy(distances.begin(), distances.end(), array->GetPointer(0));
  map->GetPointData()->SetScalars(array);
  return map;
}

vtkSmartPointer<vtkPolyData> LinesOf(const std::vector<BodyGeodesics::Length>& lengths)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const BodyGeodesics::Length& length : lengths)
  {
    lines->InsertNextCell(static_cast<int>(length.Points.size()));
    for (const Vector3& point : length.Points)
    {
      lines->InsertCellPoint(points->InsertNextPoint(point.data()));
    }
  }
  auto drawn = vtkSmartPointer<vtkPolyData>::New();
  drawn->SetPoints(points);
  drawn->SetLines(lines);
  return drawn;
}
} // namespace palpate
