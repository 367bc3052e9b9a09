#pragma once

#include "CohortGroup.h"
#include "ViewPane.h"

#include "vtkActor.h"
#include "vtkEventQtSlotConnect.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <QLabel>
#include <QWidget>

#include <vector>

namespace palpate
{
/// A shape of a group in 3-D, coloured by how far it lies outside of the mean (mm): the mean moved
/// along modes, or a case.
class CohortShapeView : public QWidget
{
  Q_OBJECT

public:
  explicit CohortShapeView(QWidget* parent = nullptr);

  /// Nothing is shown without a group, which the view keeps the address of.
  void SetGroup(const CohortGroup* group);
  /// The mean plus these multiples of the standard deviations of the first modes.
  void ShowModes(const std::vector<double>& deviations);
  void ShowCase(std::size_t row);
  /// The largest distance of what is shown from the mean, mm.
  double LargestOffset() const { return this->Largest; }
  ViewCanvas* Canvas() const { return this->Drawing; }

public Q_SLOTS:
  /// Draws in the next turn of the event loop.
  void RequestRender();

private:
  void Show(const std::vector<Vector3>& points);

  const CohortGroup* Group = nullptr;
  ViewCanvas* Drawing;
  QLabel* Legend;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkPolyDataNormals> Shading; ///< of the shape that is shown
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkSmartPointer<vtkPolyData> Surface; ///< of the mean at first
  std::vector<Vector3> Mean;
  std::vector<Vector3> Normals;
  std::vector<std::vector<Vector3>> Steps; ///< per standard deviation of each shown mode
  double Largest = 0.0;
  bool IsDue = false;
  vtkNew<vtkEventQtSlotConnect> Requests; ///< of the interactor
};
} // namespace palpate
