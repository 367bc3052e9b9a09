#include "CohortShapeView.h"

#include "ArrayColors.h"
#include "CohortPage.h"
#include "DecimalText.h"
#include "ModelSurface.h"
#include "SurfaceMaterial.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkLight.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr int ShapeFrequency = 24; // 5,762 points
constexpr double LeastLimit = 0.5; // mm, of full colour

std::vector<Vector3> PointsOf(vtkPolyData* surface)
{
  std::vector<Vector3> points(static_cast<std::size_t>(surface->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    surface->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  return points;
}
} // namespace

CohortShapeView::CohortShapeView(QWidget* parent)
    : QWidget(parent), Drawing(new ViewCanvas(this)), Legend(new QLabel(this))
{
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(this->Drawing, 1);
  column->addWidget(this->Legend);
  this->Legend->setWordWrap(true);
  this->setMinimumSize(220, 130);
  this->Renderer->SetBackground(0.13, 0.14, 0.16);
  this->Drawing->renderWindow()->AddRenderer(this->Renderer);
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  this->Drawing->interactor()->SetInteractorStyle(style);
  this->Shading->SplittingOff();
  this->Shading->ConsistencyOff();
  this->Mapper->SetInputConnection(this->Shading->GetOutputPort());
  this->Actor->SetMapper(this->Mapper);
  SurfaceMaterial::Set(this->Actor->GetProperty());
  for (const SurfaceMaterial::Lamp& lamp : SurfaceMaterial::Lamps)
  {
    vtkNew<vtkLight> light;
    SurfaceMaterial::Set(light.Get(), lamp);
    this->Renderer->AddLight(light);
  }
  // The canvas draws when it is told to (see ViewCanvas).
  this->Requests->Connect(this->Drawing->interactor(), vtkCommand::RenderEvent, this,
                          SLOT(RequestRender()));
  this->Renderer->AddActor(this->Actor);
  this->Actor->VisibilityOff();
}

void CohortShapeView::SetGroup(const CohortGroup* group)
{
  this->Group = group;
  this->Steps.clear();
  this->Actor->SetVisibility(group != nullptr);
  if (group == nullptr)
  {
    return;
  }
  this->Surface = DrawModel(ShapeOf(*group, -1, 0.0), ShapeFrequency);
  this->Mean = PointsOf(this->Surface);
  this->Normals.clear();
  vtkDataArray* normals = this->Surface->GetPointData()->GetNormals();
  for (vtkIdType p = 0; p < normals->GetNumberOfTuples(); ++p)
  {
    Vector3 normal;
    normals->GetTuple(p, normal.data());
    this->Normals.push_back(normal);
  }
  // Points are linear in the coefficients.
  for (int mode = 0; mode < ShownModes(*group); ++mode)
  {
    std::vector<Vector3> step = PointsOf(DrawModel(ShapeOf(*group, mode, 1.0), ShapeFrequency));
    for (std::size_t p = 0; p < step.size(); ++p)
    {
      step[p] -= this->Mean[p];
    }
    this->Steps.push_back(std::move(step));
  }
  this->Surface->GetPointData()->SetNormals(nullptr);
  this->Shading->SetInputData(this->Surface);
  this->ShowModes({});
  // From the front, head up.
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(0.0, -1.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  this->Renderer->ResetCamera();
  this->RequestRender();
}

void CohortShapeView::ShowModes(const std::vector<double>& deviations)
{
  std::vector<Vector3> points = this->Mean;
  for (std::size_t k = 0; k < std::min(deviations.size(), this->Steps.size()); ++k)
  {
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      points[p] += deviations[k] * this->Steps[k][p];
    }
  }
  this->Show(points);
}

void CohortShapeView::ShowCase(std::size_t row)
{
  this->Show(PointsOf(DrawModel(this->Group->Models.at(row), ShapeFrequency)));
}

void CohortShapeView::Show(const std::vector<Vector3>& points)
{
  vtkNew<vtkPoints> moved;
  moved->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> offsets;
  offsets->SetName("OffsetFromMean");
  this->Largest = 0.0;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    const double offset = (points[p] - this->Mean[p]).dot(this->Normals[p]);
    this->Largest = std::max(this->Largest, std::abs(offset));
    moved->InsertNextPoint(points[p].data());
    offsets->InsertNextValue(offset);
  }
  this->Surface->SetPoints(moved);
  this->Surface->GetPointData()->SetScalars(offsets);
  const double limit = std::max(this->Largest, LeastLimit);
  const vtkSmartPointer<vtkLookupTable> colors = MakeArrayColors(-limit, limit);
  this->Mapper->SetLookupTable(colors);
  this->Mapper->UseLookupTableScalarRangeOn();
  this->Legend->setText(
      QString("Red outside of the mean, blue inside; full colour at %1 mm")
          .arg(QString::fromStdString(SignificantText(colors->GetRange()[1], 3))));
  this->Renderer->ResetCameraClippingRange();
  this->RequestRender();
}

void CohortShapeView::RequestRender()
{
  if (this->IsDue)
  {
    return;
  }
  this->IsDue = true;
  QTimer::singleShot(0, this,
                     [this]
                     {
                       this->IsDue = false;
                       if (this->Drawing->isVisible() && this->Drawing->isValid())
                       {
                         this->Drawing->renderWindow()->Render();
                       }
                     });
}
} // namespace palpate
