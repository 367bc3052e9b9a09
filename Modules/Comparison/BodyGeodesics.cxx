#include "BodyGeodesics.h"

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

namespace palpate
{
namespace
{
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
  const OrganModel* model = file.Model();
  const Status status =
      model != nullptr
          ? SurfaceGeodesics::OfModel(*model, this->Paths)
          : SurfaceGeodesics::OfMesh(file.Body(structure, MaskBody::Shape).Surface(), this->Paths);
  if (!status.IsOk())
  {
    Refuse(file.Path(), status.Message(), "measure another one");
  }
}

BodyGeodesics::Length BodyGeodesics::Find(const Vector3& from, const Vector3& to,
                                          const ProgressFunction& progress) const
{
  KernelWatch watch(progress, "measuring");
  Length length;
  RequirePath(this->Paths.Find(from, to, watch.Of(0.0, 1.0), length), watch);
  return length;
}

vtkSmartPointer<vtkPolyData> BodyGeodesics::Map(const Vector3& from,
                                                const ProgressFunction& progress) const
{
  KernelWatch watch(progress, "measuring");
  std::vector<double> distances;
  RequirePath(this->Paths.Distances(from, watch.Of(0.0, 1.0), distances), watch);
  vtkSmartPointer<vtkPolyData> map = ToPolyData(this->Paths.Mesh());
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
