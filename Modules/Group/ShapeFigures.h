#pragma once

#include "AnatomicalView.h"
#include "OrganModel.h"
#include "PalpateGroupModule.h"
#include "ReportPage.h"
#include "SoftwareRenderer.h"

#include "vtkLookupTable.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace palpate
{
/// A shape's triangles, with a number at each point.
struct ColoredShape
{
  vtkSmartPointer<vtkPolyData> Mesh;
  std::vector<double> Values;

  /// The largest coordinate, whatever its sign (mm).
  double Extent() const;
  /// The largest value, whatever its sign.
  double LargestValue() const;
};

/// A model of a group with the distance of each point outside the mean (mm).
PALPATEGROUP_EXPORT ColoredShape DrawOffsets(const OrganModel& shape, const OrganModel& mean);

/// Draws shapes at the same scale, with the common centre in the image's centre.
class PALPATEGROUP_EXPORT ShapeFigures
{
public:
  /// `halfWidth` of the images (mm), which are `size` pixels wide; the colours of values reach from
  /// -`limit` to `limit`.
  ShapeFigures(double halfWidth, double limit, int size = 260);

  /// The value of full colour.
  double Limit() const { return this->Colors->GetRange()[1]; }
  /// Points where `isPale` (one entry per point, or none) is set have little colour.
  ReportFigure Figure(const ColoredShape& shape, ViewSide side, const std::string& caption,
                      const std::vector<bool>& isPale = {}) const;
  /// With a colour for each point.
  ReportFigure Figure(vtkPolyData* mesh, std::vector<SoftwareRenderer::Color> colors, ViewSide side,
                      const std::string& caption) const;

private:
  double HalfWidth;
  int Size;
  vtkSmartPointer<vtkLookupTable> Colors;
};
} // namespace palpate
