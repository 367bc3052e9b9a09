#pragma once

#include "PalpateIOModule.h"
#include "Vector3.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// A surface as plain arrays, as the surface formats need it: points in patient LPS (mm).
struct TriangleMesh
{
  struct PointValues
  {
    std::string Name;
    std::vector<double> Numbers;
  };

  std::vector<Vector3> PointsWorld;
  bool SinglePrecision = false;                     ///< whether the points' own type was float
  std::vector<Vector3> Normals;                     ///< unit vectors, one per point, or none
  std::vector<std::array<unsigned char, 3>> Colors; ///< red, green, blue, one per point, or none
  std::vector<PointValues> Values;                  ///< every one-component point array
  std::vector<std::array<int, 3>> Triangles;        ///< counter-clockwise seen from outside
};

/// The triangles of a surface; larger polygons and strips are triangulated, lines and vertices
/// ignored. Active point scalars of three or four unsigned chars are its colours. Throws
/// InputError, naming `file`, if it has no triangle, a coordinate is not finite, a cell refers to a
/// point that does not exist or a point array has another length.
PALPATEIO_EXPORT TriangleMesh TrianglesOf(vtkPolyData* surface, const std::filesystem::path& file);

/// Makes points with the same coordinates one, which keeps its first number, and drops triangles
/// that this turns into edges. The points must be finite and without values of their own; the
/// indices must be valid.
void MergeEqualPoints(TriangleMesh& mesh);

/// The data set of a mesh; colours become its active point scalars.
PALPATEIO_EXPORT vtkSmartPointer<vtkPolyData> PolyDataOf(const TriangleMesh& mesh);
} // namespace palpate
