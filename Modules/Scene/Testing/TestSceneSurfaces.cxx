#include "SceneSurfaces.h"

#include "ImageWriter.h"
#include "LabelImages.h"
#include "ModelFile.h"
#include "SurfaceFile.h"
#include "TemporaryFolder.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::scene_surfaces_test
{
namespace
{
bool GoOn(double, const std::string&)
{
  return true;
}

// A sphere of radius 5 mm as a model, round the origin, and one of 4 mm as label 1.
class DisplayedSurfacesTest : public testing::Test
{
protected:
  void SetUp() override
  {
    WriteModel(this->Folder / "ball.json",
               {RadialModel(0, {5.0 * std::sqrt(4.0 * M_PI)}, Vector3::Zero()), {}});
    test::LabelGrid grid;
    grid.Size = {{12, 12, 12}};
    WriteImage(this->Folder / "mask.nii.gz",
               test::MakeLabelImage(grid, [](double x, double y, double z)
                                    { return std::hypot(x - 5.5, y - 5.5, z - 5.5) < 4.0; }));
  }
  void Add(const char* file, int id)
  {
    SceneStructure structure;
    structure.Id = id;
    structure.File = this->Folder / file;
    if (this->Folder / file == this->Folder / "mask.nii.gz")
    {
      structure.Labels = {"1"};
    }
    this->Scene.Structures.push_back(structure);
  }

  test::TemporaryFolder Folder;
  SceneSettings Scene;
};

TEST_F(DisplayedSurfacesTest, AreThoseOfModelsAndMasksInTheirOrder)
{
  this->Add("mask.nii.gz", 1);
  this->Add("ball.json", 2);
  const auto surfaces = DisplayedSurfaces(this->Scene, GoOn);
  ASSERT_EQ(surfaces.size(), 2U);
  // A mask's voxels reach half a voxel beyond 4 mm at most.
  EXPECT_NEAR(surfaces[0]->GetLength(), 8.0 * std::sqrt(3.0), 2.0);
  EXPECT_NEAR(surfaces[1]->GetLength(), 10.0 * std::sqrt(3.0), 0.2);
}

TEST_F(DisplayedSurfacesTest, HiddenStructureHasNone)
{
  this->Add("ball.json", 1);
  this->Add("ball.json", 2);
  this->Scene.Structures.front().IsVisible = false;
  EXPECT_EQ(DisplayedSurfaces(this->Scene, GoOn).size(), 1U);
}
} // namespace
} // namespace palpate::scene_surfaces_test
