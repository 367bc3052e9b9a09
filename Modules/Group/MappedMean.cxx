#include "MappedMean.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>

namespace palpate
{
namespace
{
std::string NameForXml(std::string name)
{
  std::replace_if(
      name.begin(), name.end(),
      [](char c) { return std::string("&<>\"'").find(c) != std::string::npos; }, '_');
  return name;
}
} // namespace

vtkSmartPointer<vtkPolyData> MeanSurface(const NormalDisplacement& mean)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < mean.Points.size(); ++i)
  {
    points->InsertNextPoint(mean.Points[i].data());
    normals->InsertNextTuple(mean.Normals[i].data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const std::array<int, 3>& triangle : mean.Triangles)
  {
    triangles->InsertNextCell({triangle[0], triangle[1], triangle[2]});
  }
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  surface->GetPointData()->SetNormals(normals);
  return surface;
}

void AddPointMap(vtkPolyData* surface, const std::string& name,
                 const Eigen::Ref<const Eigen::VectorXd>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(NameForXml(name).c_str());
  array->SetNumberOfTuples(values.size());
  std::copy(values.data(), values.data() + values.size(), array->GetPointer(0));
  surface->GetPointData()->AddArray(array);
}
} // namespace palpate
