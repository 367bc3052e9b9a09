#include "ImageFormat.h"
#include "ImageWriter.h"
#include "InputError.h"
#include "MessageOf.h"
#include "SurfaceFile.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace palpate::file_format_test
{
namespace
{
using namespace palpate::test;

// A format of a test: 2 x 2 rows of bytes, after their length.
class RowFile : public ImageFile
{
public:
  explicit RowFile(const std::filesystem::path& file) : ImageFile(file)
  {
    this->Stream.open(file, std::ios::binary);
    this->Stream >> this->FileGrid.Size[0];
    this->Stream.get();
    this->FileGrid.Size[1] = 2;
    this->FileGrid.Size[2] = 2;
    this->Header.Components = 1;
    this->Header.VtkType = VTK_UNSIGNED_CHAR;
  }

  void ReadInto(void* buffer) override
  {
    this->Stream.read(static_cast<char*>(buffer), this->FileGrid.VoxelCount());
  }

private:
  std::ifstream Stream;
};

void WriteRow(const std::filesystem::path& file, vtkImageData*, vtkDataArray* voxels)
{
  std::ofstream stream(file, std::ios::binary);
  stream << voxels->GetNumberOfTuples() / 4 << "\n";
  stream.write(static_cast<const char*>(voxels->GetVoidPointer(0)), voxels->GetNumberOfTuples());
}

// The corners of one triangle.
vtkSmartPointer<vtkPolyData> ReadTriangle(const std::filesystem::path& file)
{
  std::ifstream stream(file);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (double x = 0, y = 0, z = 0; stream >> x >> y >> z;)
  {
    points->InsertNextPoint(x, y, z);
  }
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({0, 1, 2});
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  return surface;
}

std::string WriteTriangle(const TriangleMesh& mesh, vtkPolyData*, const std::filesystem::path&)
{
  std::ostringstream text;
  for (const int corner : mesh.Triangles.front())
  {
    text << mesh.PointsWorld[static_cast<std::size_t>(corner)].transpose() << "\n";
  }
  return text.str();
}

// With the formats of the test, which remain until the process ends.
class FileFormats : public testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    ImageFormats().Add({{"Row", {".row", ".row.test"}, {".row"}},
                        [](const std::filesystem::path& file)
                        { return std::make_unique<RowFile>(file); },
                        &WriteRow});
    SurfaceFormats().Add(
        {{"Triangle", {".triangle"}, {".triangle"}}, &ReadTriangle, &WriteTriangle});
  }

  TemporaryFolder Folder;
};

bool Holds(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

TEST_F(FileFormats, AddedImagesAreWrittenAndRead)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 2, 2);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* voxels = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 20; ++i)
  {
    voxels[i] = static_cast<unsigned char>(7 * i);
  }
  ASSERT_TRUE(IsWritableImage("a.ROW"));
  WriteImage(this->Folder / "a.row", image);
  const Volume back = ReadVolume(this->Folder / "a.row");
  ASSERT_EQ(back.Image->GetNumberOfPoints(), 20);
  for (int i = 0; i < 20; ++i)
  {
    EXPECT_EQ(back.Image->GetPointData()->GetScalars()->GetTuple1(i), 7 * i);
  }
}

TEST_F(FileFormats, AddedSurfacesAreWrittenAndRead)
{
  std::ofstream(this->Folder / "a.triangle") << "0 0 0\n1 0 0\n0 2 0\n";
  ASSERT_TRUE(IsSurfaceFile("a.triangle"));
  WriteSurface(this->Folder / "b.triangle", ReadSurface(this->Folder / "a.triangle"));
  const auto back = ReadSurface(this->Folder / "b.triangle");
  ASSERT_EQ(back->GetNumberOfPoints(), 3);
  EXPECT_EQ(back->GetPoint(2)[1], 2.0);
}

TEST_F(FileFormats, AddedFormatsAreListedInDialogsAndMessages)
{
  EXPECT_TRUE(Holds(PatternsOf(ReadableImageEndings()), "*.row"));
  EXPECT_TRUE(Holds(PatternsOf(SurfaceFormats().WrittenEndings()), "*.triangle"));
  std::ofstream(this->Folder / "a.txt") << "nothing";
  EXPECT_TRUE(Holds(MessageOf([&] { ReadVolume(this->Folder / "a.txt"); }), "Row (.row or"));
  EXPECT_TRUE(Holds(MessageOf([&] { ReadSurface(this->Folder / "a.txt"); }), "or .triangle"));
}

TEST(FileFormat, UsesLongestEnding)
{
  EXPECT_EQ(EndingOf("a/Mask.SEG.nrrd", {".nrrd", ".seg.nrrd"}), ".seg.nrrd");
  EXPECT_EQ(EndingOf("a/.nrrd", {".nrrd"}), "");
  EXPECT_EQ(EndingOf("a/b.nrrd.txt", {".nrrd"}), "");
  EXPECT_EQ(ListOfEndings({".a", ".b", ".c"}), ".a, .b or .c");
  EXPECT_EQ(PatternsOf({".a", ".b"}), "*.a *.b");
}
} // namespace
} // namespace palpate::file_format_test
