#pragma once

#include <array>
#include <string>
#include <vector>

class vtkPolyData;

/// Surface files for tests that the project does not write itself.
namespace palpate::test
{
/// A tetrahedron of 10 mm edges along the axes, with outward triangles.
struct GiftiSpec
{
  std::vector<float> Points{0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 10}; ///< RAS, mm
  std::vector<int> Triangles{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  std::string Encoding = "GZipBase64Binary";
  bool IsBigEndian = false;
  bool ByColumns = false;
  std::string Space = "NIFTI_XFORM_TALAIRACH"; ///< to which the matrix leads
  std::string Matrix = "1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1";
};
std::string GiftiBytes(const GiftiSpec& spec);

/// A legacy VTK file as VTK writes it: version 42 or 51.
std::string LegacyVtkBytes(vtkPolyData* surface, int version, bool isBinary);
} // namespace palpate::test
