#include "SceneMove.h"

#include "FitStructure.h"
#include "ImageGrid.h"
#include "ImageWriter.h"
#include "InputError.h"
#include "LabelImages.h"
#include "ModelFile.h"
#include "SceneFile.h"
#include "SceneReading.h"
#include "SurfaceFile.h"
#include "TemporaryFolder.h"
#include "TransformFile.h"

#include "vtkNew.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>

namespace palpate::scene_move_test
{
namespace
{
const Vector3 Shift(3.0, -2.0, 5.0);

Eigen::Affine3d Rigid()
{
  return Eigen::Translation3d(Shift) *
         Eigen::Affine3d(Eigen::AngleAxisd(0.4, Vector3(1.0, 2.0, -2.0).normalized()));
}

// A ball of 6 mm at (5, 0, 0) as each kind of file.
class SceneMoveTest : public testing::Test
{
protected:
  SceneMove Written(const Eigen::Affine3d& map, const std::string& name = "moved.tfm") const
  {
    WriteTransform(this->Folder / name, map);
    return {this->Folder / name, {}};
  }
  std::string RefusalOf(const SceneMove& move) const
  {
    try
    {
      ReadMove(move, this->Folder / "moving.nii");
    }
    catch (const InputError& error)
    {
      return error.what();
    }
    return {};
  }
  template <typename T>
  static std::shared_ptr<const T> Made(const SceneNode& node)
  {
    const SceneProduct product = node.Make({}, {});
    return ProductAs<T>(&product);
  }

  test::TemporaryFolder Folder;
  const Vector3 Center = Vector3(5.0, 0.0, 0.0);
};

TEST_F(SceneMoveTest, RefusesTransformsOfNoPatient)
{
  EXPECT_EQ(this->RefusalOf(this->Written(Rigid())), "");
  for (const Vector3& scales : {Vector3(-1.0, 1.0, 1.0), Vector3(1.0, 1.0, 150.0),
                                Vector3(1.0, 0.005, 1.0), Vector3(200.0, 200.0, 200.0)})
  {
    const std::string refusal =
        this->RefusalOf(this->Written(Eigen::Affine3d(scales.asDiagonal())));
    EXPECT_NE(refusal.find("moved.tfm"), std::string::npos) << scales.transpose();
  }
  std::ofstream(this->Folder / "bad.tfm") << "#Insight Transform File V1.0\nTransform: ";
  EXPECT_NE(this->RefusalOf({this->Folder / "bad.tfm", {}}).find("bad.tfm"), std::string::npos);
  EXPECT_NE(this->RefusalOf({this->Folder / "none.lta", {}}).find("none.lta"), std::string::npos);
}

TEST_F(SceneMoveTest, SurfaceAndModelMoveExactly)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(this->Center.data());
  ball->SetRadius(6.0);
  ball->Update();
  WriteSurface(this->Folder / "ball.ply", ball->GetOutput());
  const SceneMove move = this->Written(Rigid());
  const auto still = Made<FitSurface>(SurfaceNode(this->Folder / "ball.ply", {}));
  const auto moved = Made<FitSurface>(SurfaceNode(this->Folder / "ball.ply", {}, move));
  for (vtkIdType i = 0; i < still->Found.Surface->GetNumberOfPoints(); ++i)
  {
    const Vector3 from(still->Found.Surface->GetPoint(i));
    const Vector3 to(moved->Found.Surface->GetPoint(i));
    EXPECT_LT((to - Rigid() * from).norm(), 1e-5); // single precision
  }
  ModelDocument document{RadialModel(0, {6.0 * std::sqrt(4.0 * M_PI)}, this->Center), {}, {}};
  WriteModel(this->Folder / "ball.json", document);
  const auto model = Made<FitResult>(ModelNode(this->Folder / "ball.json", {}, move));
  EXPECT_LT((CenterOf(model->Model) - Rigid() * this->Center).norm(), 1e-9);
}

TEST_F(SceneMoveTest, SegmentationKeepsVoxelsUnlessSheared)
{
  test::LabelGrid grid;
  grid.CenterOnOrigin();
  WriteImage(
      this->Folder / "mask.nii.gz",
      test::MakeLabelImage(
          grid, [](double x, double y, double z) { return std::hypot(x - 5.0, y, z) < 6.0; }, 1));
  const auto read = [&](const SceneMove& move)
  {
    return Made<Segmentation>(
        SegmentationNode(this->Folder / "mask.nii.gz", LeftHandedAxes::Reverse, {}, move));
  };
  const auto still = read({});
  const auto moved = read(this->Written(Rigid()));
  EXPECT_TRUE(moved->Notes.empty());
  EXPECT_LT((GridOf(moved->Layers[0]).OriginWorld - Rigid() * GridOf(still->Layers[0]).OriginWorld)
                .norm(),
            1e-9);
  Eigen::Affine3d shear = Rigid();
  shear.linear() *= (Eigen::Matrix3d() << 1.0, 0.3, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0).finished();
  const auto sheared = read(this->Written(shear));
  EXPECT_EQ(sheared->Notes.size(), 1U);
  ASSERT_EQ(sheared->Segments.size(), 1U);
}

TEST_F(SceneMoveTest, KeysDifferByTransformAndStamp)
{
  const SceneMove move{"/a/one.tfm", {}};
  const auto key = [](const SceneMove& by, const SceneStamps& stamps)
  { return VolumeNode("/a/v.nii", {}, LeftHandedAxes::Reverse, stamps, by).Key; };
  EXPECT_NE(key({}, {}), key(move, {}));
  EXPECT_NE(key(move, {}), key(move, {{"/a/one.tfm", "later"}}));
  EXPECT_NE(key(move, {}), key({"/a/one.tfm", "/a/fixed.nii"}, {}));
  EXPECT_EQ(key({}, {}), key({}, {{"/a/one.tfm", "later"}}));
}

TEST_F(SceneMoveTest, SceneFileKeepsTransforms)
{
  SceneSettings scene;
  scene.Structures.emplace_back();
  scene.Structures[0].File = this->Folder / "ball.ply";
  scene.Structures[0].Move = {this->Folder / "moved.mat", this->Folder / "fixed.nii.gz"};
  std::ofstream(this->Folder / "scene.json") << SceneText(scene, this->Folder.Path());
  EXPECT_EQ(ReadScene(this->Folder / "scene.json").Structures, scene.Structures);
  std::ofstream(this->Folder / "bad.json")
      << R"({"format":"palpate-scene","version":1,)"
         R"("structures":[{"file":"ball.ply","transform_fixed":"fixed.nii.gz"}]})";
  EXPECT_THROW(ReadScene(this->Folder / "bad.json"), InputError);
}
} // namespace
} // namespace palpate::scene_move_test
