#include "CNumericLocale.h"
#include "CommaLocale.h"
#include "FractionalImages.h"
#include "ImageContent.h"
#include "ImageGrid.h"
#include "ImageWriter.h"
#include "MessageOf.h"
#include "ModelFile.h"
#include "RandomModels.h"
#include "SurfaceFile.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLPolyDataWriter.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <thread>

namespace palpate::cnumeric_locale_test
{
namespace
{
using namespace palpate::test;

constexpr CommaLocale::Scope Scopes[] = {CommaLocale::Scope::OnlyC, CommaLocale::Scope::Streams};

// MetaImage's and VTP's libraries use C++ streams, which cannot have a locale per thread; a test
// below shows that they are refused.
bool StreamFormatsIn(CommaLocale::Scope scope)
{
  return scope == CommaLocale::Scope::OnlyC;
}

vtkSmartPointer<vtkPolyData> Triangle()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1.5, -2.25, 3.125);
  points->InsertNextPoint(4000.75, 5.5, -6.25);
  points->InsertNextPoint(-7.5, 8.75, 9.875);
  vtkNew<vtkCellArray> faces;
  faces->InsertNextCell({0, 1, 2});
  auto triangle = vtkSmartPointer<vtkPolyData>::New();
  triangle->SetPoints(points);
  triangle->SetPolys(faces);
  return triangle;
}

void WriteTextVtp(const std::filesystem::path& file)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetDataModeToAscii();
  writer->SetFileName(file.c_str());
  writer->SetInputData(Triangle());
  ASSERT_EQ(writer->Write(), 1);
}

ModelDocument Model()
{
  std::mt19937_64 random(5);
  return {RandomModel(random, 3), {"palpate", "a.nii", "1", "", {{"smoothing", "0.5"}}}};
}

std::string BitsOf(vtkImageData* image)
{
  const ImageGrid grid = GridOf(image);
  std::vector<double> numbers(grid.Direction.data(), grid.Direction.data() + 9);
  for (int k = 0; k < 3; ++k)
  {
    numbers.push_back(grid.Spacing[k]);
    numbers.push_back(grid.OriginWorld[k]);
  }
  vtkDataArray* voxels = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < voxels->GetNumberOfValues(); ++i)
  {
    numbers.push_back(voxels->GetTuple1(i));
  }
  return BytesOf(numbers);
}

std::string BitsOf(const ImageContent& content)
{
  if (!content.Labels)
  {
    return BitsOf(content.Image->Image);
  }
  std::string bits = BitsOf(content.Labels->Layers[0]);
  for (const Segment& segment : content.Labels->Segments)
  {
    bits += BytesOf(std::vector<double>(segment.Color.begin(), segment.Color.end()));
  }
  return bits;
}

std::string BitsOf(vtkPolyData* surface)
{
  std::vector<double> numbers;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    numbers.insert(numbers.end(), surface->GetPoint(i), surface->GetPoint(i) + 3);
  }
  return BytesOf(numbers);
}

std::string BitsOf(const ModelDocument& document)
{
  const auto& model = std::get<RadialModel>(document.Surface);
  const double* const center = model.CenterWorld().data();
  return BytesOf(model.Coefficients()) + BytesOf(std::vector<double>(center, center + 3));
}

// Results of reading under the locale of the process.
std::map<std::string, std::string> ReadAllOf(const TemporaryFolder& folder,
                                             bool withStreamFormats = true)
{
  std::map<std::string, std::string> bits;
  if (withStreamFormats)
  {
    bits["a.mha"] = BitsOf(ReadImageContent(folder / "a.mha"));
    bits["a.vtp"] = BitsOf(ReadSurface(folder / "a.vtp"));
    bits["text.vtp"] = BitsOf(ReadSurface(folder / "text.vtp"));
  }
  for (const char* name : {"a.nii", "a.seg.nrrd", "b.nrrd", "dicom", "seg.dcm"})
  {
    bits[name] = BitsOf(ReadImageContent(folder / name));
  }
  for (const char* name : {"text.stl", "text.ply", "text.obj", "a.stl", "a.ply"})
  {
    bits[name] = BitsOf(ReadSurface(folder / name));
  }
  bits["a.json"] = BitsOf(ReadModel(folder / "a.json"));
  const ModelDocument document = ReadModel(folder / "a.coef");
  for (const int coordinate : {0, 1, 2})
  {
    bits["a.coef"] += BytesOf(std::get<SurfaceModel>(document.Surface).Coefficients(coordinate));
  }
  return bits;
}

// All written files, by content.
void WriteAllOf(const TemporaryFolder& folder, vtkImageData* image, bool withStreamFormats = true)
{
  if (withStreamFormats)
  {
    WriteImage(folder / "w.mha", image);
  }
  for (const char* name : {"w.nii", "w.nii.gz", "w.nrrd"})
  {
    WriteImage(folder / name, image);
  }
  for (const char* name : {"a.vtp", "a.stl", "a.ply", "a.obj", "a.gltf", "a.glb", "a.x3d"})
  {
    WriteSurface(folder / name, Triangle());
  }
  for (const char* name : {"a.json", "a.csv", "a.coef"})
  {
    WriteModel(folder / name, Model());
  }
}

void WriteInputs(const TemporaryFolder& folder)
{
  WriteFractionalImages(folder.Path());
  WriteTextVtp(folder / "text.vtp");
  const std::string vertices = "1.5 -2.25 3.125\n4000.75 5.5 -6.25\n-7.5 8.75 9.875\n";
  WriteAll(folder / "text.ply",
           "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
           "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
           "end_header\n" +
               vertices + "3 0 1 2\n");
  WriteAll(folder / "text.obj",
           "v 1.5 -2.25 3.125\nv 4000.75 5.5 -6.25\nv -7.5 8.75 9.875\nf 1 2 3\n");
  WriteAll(folder / "text.stl",
           "solid a\nfacet normal 0 0.5 0.5\nouter loop\nvertex 1.5 -2.25 3.125\n"
           "vertex 4000.75 5.5 -6.25\nvertex -7.5 8.75 9.875\nendloop\nendfacet\nendsolid a\n");
  WriteAllOf(folder, ReadImageContent(folder / "a.mha").Labels->Layers[0]);
}

TEST(CNumericLocale, SetsDecimalPointForThreadDuringLifetime)
{
  const CommaLocale comma;
  ASSERT_EQ(std::strtod("3.5", nullptr), 3.0);
  {
    const CNumericLocale numbers;
    EXPECT_EQ(std::strtod("3.5", nullptr), 3.5);
    double elsewhere = 0.0;
    std::thread([&elsewhere] { elsewhere = std::strtod("3.5", nullptr); }).join();
    EXPECT_EQ(elsewhere, 3.0);
  }
  EXPECT_EQ(std::strtod("3.5", nullptr), 3.0);
}

TEST(CNumericLocale, ReadsAllFormatsUnderDecimalComma)
{
  const TemporaryFolder folder;
  WriteInputs(folder);
  const auto expected = ReadAllOf(folder);
  for (const CommaLocale::Scope scope : Scopes)
  {
    const CommaLocale comma(scope);
    const auto read = ReadAllOf(folder, StreamFormatsIn(scope));
    EXPECT_EQ(read.size() + (StreamFormatsIn(scope) ? 0 : 3), expected.size());
    for (const auto& [name, bits] : read)
    {
      EXPECT_EQ(bits, expected.at(name)) << name << ", scope " << static_cast<int>(scope);
    }
  }
}

TEST(CNumericLocale, WritesAllFormatsUnderDecimalComma)
{
  const TemporaryFolder folder;
  WriteFractionalImages(folder.Path());
  const auto image = ReadImageContent(folder / "a.mha").Labels->Layers[0];
  const TemporaryFolder expected;
  WriteAllOf(expected, image);
  for (const CommaLocale::Scope scope : Scopes)
  {
    const CommaLocale comma(scope);
    const TemporaryFolder written;
    WriteAllOf(written, image, StreamFormatsIn(scope));
    EXPECT_EQ(written.EntryCount() + (StreamFormatsIn(scope) ? 0 : 1), expected.EntryCount());
    for (const auto& entry : std::filesystem::directory_iterator(written.Path()))
    {
      const std::string name = entry.path().filename().string();
      EXPECT_EQ(ReadAll(entry.path()), ReadAll(expected / name))
          << name << ", scope " << static_cast<int>(scope);
    }
  }
}

TEST(CNumericLocale, RejectsStreamFormatsIfStreamsUseDecimalComma)
{
  const TemporaryFolder folder;
  WriteFractionalImages(folder.Path());
  const auto image = ReadImageContent(folder / "a.mha").Labels->Layers[0];
  const CommaLocale comma(CommaLocale::Scope::Streams);
  const std::string fact = "C++ streams use the number format of the locale de_DE.UTF-8";
  EXPECT_TRUE(Contains(MessageOf([&] { ReadImageContent(folder / "a.mha"); }), fact));
  EXPECT_TRUE(Contains(MessageOf([&] { WriteImage(folder / "w.mha", image); }), fact));
  WriteSurface(folder / "a.vtp", Triangle());
  EXPECT_TRUE(Contains(MessageOf([&] { ReadSurface(folder / "a.vtp"); }), fact));
  EXPECT_FALSE(std::filesystem::exists(folder / "w.mha"));
}
} // namespace
} // namespace palpate::cnumeric_locale_test
