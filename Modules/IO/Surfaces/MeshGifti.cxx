#include "MeshGifti.h"

#include "DecimalText.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
std::string GiftiDocument(std::size_t arrays, const std::string& content)
{
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<GIFTI Version=\"1.0\" "
         "NumberOfDataArrays=\"" +
         std::to_string(arrays) + "\">\n" + content + "</GIFTI>\n";
}

// `sizes`: rows, and columns if there are several.
std::string DataArray(const std::string& intent, const std::string& type,
                      const std::vector<std::size_t>& sizes, const std::string& head,
                      const std::string& numbers)
{
  std::string text = "<DataArray Intent=\"NIFTI_INTENT_" + intent + "\" DataType=\"NIFTI_TYPE_" +
                     type + "\" ArrayIndexingOrder=\"RowMajorOrder\" Dimensionality=\"" +
                     std::to_string(sizes.size()) + "\"";
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    text += " Dim" + std::to_string(i) + "=\"" + std::to_string(sizes[i]) + "\"";
  }
  return text +
         " Encoding=\"ASCII\" Endian=\"LittleEndian\" ExternalFileName=\"\" "
         "ExternalFileOffset=\"\">\n" +
         head + "<Data>\n" + numbers + "</Data>\n</DataArray>\n";
}
} // namespace

std::string MeshToGifti(const TriangleMesh& mesh)
{
  const std::string space = "NIFTI_XFORM_SCANNER_ANAT";
  const std::string scanner = "<CoordinateSystemTransformMatrix><DataSpace>" + space +
                              "</DataSpace><TransformedSpace>" + space +
                              "</TransformedSpace><MatrixData>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"
                              "</MatrixData></CoordinateSystemTransformMatrix>\n";
  std::string points;
  for (const Vector3& point : mesh.PointsWorld)
  {
    points += ExactText(static_cast<float>(-point[0])) + " " +
              ExactText(static_cast<float>(-point[1])) + " " +
              ExactText(static_cast<float>(point[2])) + "\n";
  }
  std::string triangles;
  for (const auto& [a, b, c] : mesh.Triangles)
  {
    triangles += std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  }
  return GiftiDocument(
      2, DataArray("POINTSET", "FLOAT32", {mesh.PointsWorld.size(), 3}, scanner, points) +
             DataArray("TRIANGLE", "INT32", {mesh.Triangles.size(), 3}, "", triangles));
}

std::string ValuesToGifti(const TriangleMesh& mesh)
{
  std::string arrays;
  for (const TriangleMesh::PointValues& values : mesh.Values)
  {
    std::string numbers;
    for (const double number : values.Numbers)
    {
      numbers += (std::isfinite(number) ? ExactText(static_cast<float>(number)) : "nan") + "\n";
    }
    std::string name = values.Name;
    std::replace_if(
        name.begin(), name.end(),
        [](unsigned char c) { return c < ' ' || c == '<' || c == '&' || c == '>'; }, '_');
    arrays += DataArray(
        "SHAPE", "FLOAT32", {values.Numbers.size()},
        "<MetaData><MD><Name>Name</Name><Value>" + name + "</Value></MD></MetaData>\n", numbers);
  }
  return GiftiDocument(mesh.Values.size(), arrays);
}
} // namespace palpate
