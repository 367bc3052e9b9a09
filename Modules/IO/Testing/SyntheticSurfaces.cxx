#include "SyntheticSurfaces.h"

#include "DataUri.h"
#include "StoredImages.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataWriter.h"

#include <sstream>

namespace palpate::test
{
namespace
{
template <typename T>
std::vector<T> InOrder(const std::vector<T>& triples, bool byColumns)
{
  std::vector<T> ordered;
  for (std::size_t i = 0; i < triples.size(); ++i)
  {
    const std::size_t count = triples.size() / 3;
    ordered.push_back(byColumns ? triples[3 * (i % count) + i / count] : triples[i]);
  }
  return ordered;
}

template <typename T>
std::string Encoded(const GiftiSpec& spec, const std::vector<T>& triples)
{
  const std::vector<T> values = InOrder(triples, spec.ByColumns);
  if (spec.Encoding == "ASCII")
  {
    std::ostringstream text;
    for (const T value : values)
    {
      text << value << "\n";
    }
    return text.str();
  }
  const std::string bytes = spec.IsBigEndian ? BigEndian(values) : BytesOf(values);
  const std::string uri = DataUri("", spec.Encoding == "Base64Binary" ? bytes : Deflated(bytes));
  return uri.substr(uri.find(',') + 1);
}

template <typename T>
std::string Array(const GiftiSpec& spec, const std::string& intent, const std::string& type,
                  const std::vector<T>& triples, const std::string& inside)
{
  return "<DataArray Intent=\"NIFTI_INTENT_" + intent + "\" DataType=\"NIFTI_TYPE_" + type +
         "\" ArrayIndexingOrder=\"" + (spec.ByColumns ? "ColumnMajorOrder" : "RowMajorOrder") +
         "\" Dimensionality=\"2\" Dim0=\"" + std::to_string(triples.size() / 3) +
         "\" Dim1=\"3\" Encoding=\"" + spec.Encoding + "\" Endian=\"" +
         (spec.IsBigEndian ? "BigEndian" : "LittleEndian") +
         "\" ExternalFileName=\"\" ExternalFileOffset=\"\">\n"
         "<MetaData><MD><Name><![CDATA[Name]]></Name><Value>Jane Doe</Value></MD></MetaData>\n" +
         inside + "<Data>" + Encoded(spec, triples) + "</Data>\n</DataArray>\n";
}
} // namespace

std::string GiftiBytes(const GiftiSpec& spec)
{
  const std::string transform =
      "<CoordinateSystemTransformMatrix>\n<DataSpace><![CDATA[NIFTI_XFORM_UNKNOWN]]></DataSpace>\n"
      "<TransformedSpace><![CDATA[" +
      spec.Space + "]]></TransformedSpace>\n<MatrixData>" + spec.Matrix +
      "</MatrixData>\n</CoordinateSystemTransformMatrix>\n";
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE GIFTI SYSTEM "
         "\"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n<GIFTI Version=\"1.0\" "
         "NumberOfDataArrays=\"2\">\n<MetaData/>\n<LabelTable/>\n" +
         Array(spec, "POINTSET", "FLOAT32", spec.Points, transform) +
         Array(spec, "TRIANGLE", "INT32", spec.Triangles, "") + "</GIFTI>\n";
}

std::string LegacyVtkBytes(vtkPolyData* surface, int version, bool isBinary)
{
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetInputData(surface);
  writer->SetFileVersion(version);
  writer->SetFileType(isBinary ? VTK_BINARY : VTK_ASCII);
  writer->WriteToOutputStringOn();
  writer->Write();
  return writer->GetOutputStdString();
}
} // namespace palpate::test
