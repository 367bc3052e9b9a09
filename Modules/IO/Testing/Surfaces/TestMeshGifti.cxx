#include "GiftiText.h"
#include "IcosahedronDirections.h"
#include "InputError.h"
#include "SurfaceFile.h"
#include "TemporaryFolder.h"
#include "WholeFile.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

namespace palpate::mesh_gifti_test
{
namespace
{
using namespace palpate::test;

vtkSmartPointer<vtkPolyData> Sphere()
{
  const IcosahedronDirections sphere(5);
  TriangleMesh mesh;
  for (const Vector3& u : sphere.Directions())
  {
    mesh.PointsWorld.push_back(Vector3(10.1, -20.2, 30.3) + 7.0 * u);
  }
  mesh.Triangles = sphere.Triangles();
  return PolyDataOf(mesh);
}

TEST(MeshGifti, SurfaceIsReadBackInLps)
{
  const TemporaryFolder folder;
  const auto written = Sphere();
  WriteSurface(folder / "a.surf.gii", written);
  const auto read = ReadSurface(folder / "a.surf.gii");
  ASSERT_EQ(read->GetNumberOfPoints(), written->GetNumberOfPoints());
  ASSERT_EQ(read->GetNumberOfCells(), written->GetNumberOfCells());
  for (vtkIdType i = 0; i < read->GetNumberOfPoints(); ++i)
  {
    // Single precision of 40 mm.
    ASSERT_LT((Vector3(read->GetPoint(i)) - Vector3(written->GetPoint(i))).norm(), 4e-6);
  }
  const GiftiArrays arrays = GiftiArraysOf(ReadWholeFile(folder / "a.surf.gii", 1U << 20U), "a");
  EXPECT_EQ(arrays.Points->Data.substr(0, 2), "\n-") << "RAS";
  EXPECT_TRUE(arrays.Points->ToScanner);
}

TEST(MeshGifti, ShapeFileHasEveryMapWithItsName)
{
  const TemporaryFolder folder;
  const auto surface = Sphere();
  EXPECT_THROW(WriteSurface(folder / "a.shape.gii", surface), InputError);
  vtkNew<vtkDoubleArray> map;
  map->SetName("thickness <mm>");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    map->InsertNextValue(i == 0 ? 0.5 : std::nan(""));
  }
  surface->GetPointData()->AddArray(map);
  WriteSurface(folder / "a.shape.gii", surface);
  const std::string text = ReadWholeFile(folder / "a.shape.gii", 1U << 20U);
  EXPECT_NE(text.find("NumberOfDataArrays=\"1\""), std::string::npos);
  EXPECT_NE(text.find("<Value>thickness _mm_</Value>"), std::string::npos);
  EXPECT_NE(text.find("<Data>\n0.5\nnan\n"), std::string::npos);
  EXPECT_NE(text.find("Dim0=\"" + std::to_string(surface->GetNumberOfPoints()) + "\""),
            std::string::npos);
}
} // namespace
} // namespace palpate::mesh_gifti_test
