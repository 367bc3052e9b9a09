#include "SlicePatch.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

namespace palpate
{
SlicePatch::SlicePatch()
{
  this->Texture->SetInputData(this->Pixels);
  this->Texture->SetColorModeToDirectScalars();
  this->Texture->InterpolateOff();
  this->Texture->RepeatOff();
  this->Texture->EdgeClampOn();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(this->Shape);
  mapper->ScalarVisibilityOff();
  this->Polygon->SetMapper(mapper);
  this->Polygon->SetTexture(this->Texture);
  this->Polygon->ForceOpaqueOn();
  this->Polygon->GetProperty()->LightingOff();
}

void SlicePatch::SetInterpolate(bool interpolate)
{
  this->Texture->SetInterpolate(interpolate ? 1 : 0);
}

std::vector<Vector3> SlicePatch::CornersOf(const PixelGrid& grid)
{
  const double right = grid.Width - 0.5;
  const double top = grid.Height - 0.5;
  return {grid.PixelWorld(-0.5, -0.5), grid.PixelWorld(right, -0.5), grid.PixelWorld(right, top),
          grid.PixelWorld(-0.5, top)};
}

void SlicePatch::Place(const PixelGrid& grid, const std::vector<Vector3>& cornersWorld)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("PictureCoordinates");
  coordinates->SetNumberOfComponents(2);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell(static_cast<int>(cornersWorld.size()));
  for (const Vector3& corner : cornersWorld)
  {
    const Vector3 offset = corner - grid.FirstWorld;
    const double column = offset.dot(grid.ColumnWorld) / grid.ColumnWorld.squaredNorm();
    const double row = offset.dot(grid.RowWorld) / grid.RowWorld.squaredNorm();
    coordinates->InsertNextTuple2((column + 0.5) / grid.Width, (row + 0.5) / grid.Height);
    polygons->InsertCellPoint(points->InsertNextPoint(corner.data()));
  }
  this->Shape->SetPoints(points);
  this->Shape->SetPolys(polygons);
  this->Shape->GetPointData()->SetTCoords(coordinates);
}
} // namespace palpate
