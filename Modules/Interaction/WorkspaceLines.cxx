#include "WorkspaceLines.h"

#include "vtkWorkspaceRepresentation.h"

#include "vtkActor.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

namespace palpate
{
namespace
{
constexpr double LineWidth = 1.0;
constexpr double Opacity = 0.8;

std::vector<SurfaceCurve> EdgesOf(vtkWorkspaceRepresentation* workspace)
{
  std::vector<SurfaceCurve> edges;
  for (int corner = 0; corner < 8; ++corner)
  {
    for (int axis = 1; axis < 8; axis *= 2)
    {
      if ((corner & axis) == 0)
      {
        Vector3 from;
        Vector3 to;
        workspace->GetCorner(corner, from.data());
        workspace->GetCorner(corner | axis, to.data());
        edges.push_back({{from, to}, false});
      }
    }
  }
  return edges;
}
} // namespace

void WorkspaceLines::AddTo(vtkRenderer* renderer) const
{
  renderer->AddViewProp(this->Lines.Actor());
}

void WorkspaceLines::RemoveFrom(vtkRenderer* renderer) const
{
  renderer->RemoveViewProp(this->Lines.Actor());
}

bool WorkspaceLines::Show(vtkWorkspaceRepresentation* workspace, double width)
{
  const bool isShown = workspace != nullptr && workspace->GetVisibility();
  this->Lines.SetVisible(isShown);
  if (isShown)
  {
    const double* color = workspace->GetColor();
    this->Lines.SetStyle({{color[0], color[1], color[2]}}, Opacity, width);
  }
  return isShown;
}

void WorkspaceLines::Update(vtkWorkspaceRepresentation* workspace)
{
  if (this->Show(workspace, LineWidth))
  {
    this->Lines.SetCurves(EdgesOf(workspace), Vector3::Zero());
  }
}

void WorkspaceLines::Update(vtkWorkspaceRepresentation* workspace, const SlicePosition& slice)
{
  if (this->Show(workspace, LineWidth * slice.PointPixels))
  {
    this->Lines.SetCurves(
        CutSurface(workspace->GetBox(), slice.CenterWorld, slice.Frame.TowardsViewerWorld),
        slice.Lift(ContourLayer));
  }
}
} // namespace palpate
