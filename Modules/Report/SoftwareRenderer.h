#pragma once

#include "AnatomicalView.h"
#include "PalpateReportModule.h"
#include "RasterImage.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

class vtkLookupTable;
class vtkPolyData;

namespace palpate
{
/// Draws a triangle mesh without a graphics system: a depth-buffered rasteriser with lighting per
/// point, a light next to the viewer, 2x2 samples per pixel, and an orthographic view.
///
/// Needed because Debian's VTK ends the process when there is no X server, and reports are also
/// made on machines without one. 80,000 triangles at 320 x 320 pixels take some milliseconds, which
/// is enough for a still image.
class PALPATEREPORT_EXPORT SoftwareRenderer
{
public:
  using Color = std::array<std::uint8_t, 3>;

  /// Copies points (mm, patient LPS), polygons (convex) and point normals of `mesh`; missing
  /// normals are computed from the polygons.
  explicit SoftwareRenderer(vtkPolyData* mesh);

  void SetColor(const Color& color);
  /// One colour per point; ignored if the count differs.
  void SetPointColors(std::vector<Color> colors);
  /// The colours of numbers, one per point.
  static std::vector<Color> ColorsOf(vtkLookupTable* table, const std::vector<double>& numbers);

  /// Half width of an image in mm: the same for all sides, so that their scales can be compared.
  double HalfWidthMillimeters() const { return this->HalfWidth; }

  /// A square image of `size` pixels from one side, centred on the mesh's bounding box, with a
  /// transparent background. Const and thread-safe.
  RasterImage Render(ViewSide side, int size) const;

private:
  struct Projected
  {
    float X; ///< samples from the left and from the top
    float Y;
    float Depth;           ///< mm; larger is nearer
    Eigen::Vector3f Front; ///< colour, 0..255, of a triangle that faces the viewer
    Eigen::Vector3f Back;  ///< of one that shows its inside
  };
  struct Samples;

  void AddTriangles(vtkPolyData* mesh);
  void AddNormals(vtkPolyData* mesh);
  void MakeNormals();
  std::vector<Projected> Project(const ViewFrame& frame, int samplesAcross) const;
  void Rasterise(const std::vector<Projected>& points, Samples& samples) const;
  Eigen::Vector3f ColorAt(int triangle, float x, float y,
                          const std::vector<Projected>& points) const;
  /// Averages a pixel's samples.
  void Resolve(int column, int row, const Samples& samples, const std::vector<Projected>& points,
               std::uint8_t* pixel) const;

  std::vector<Eigen::Vector3f> Points; ///< mm from the centre of the bounding box
  std::vector<Eigen::Vector3f> Normals;
  std::vector<Color> Colors;
  std::vector<std::array<int, 3>> Triangles;
  double HalfWidth = 1.0;
};
} // namespace palpate
