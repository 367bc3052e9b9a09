#include "SceneTool.h"

#include "DrilledField.h"
#include "FieldBuilder.h"
#include "InputError.h"
#include "RandomOrientation.h"
#include "SceneTool.h"
#include "SurfaceFile.h"
#include "TemporaryFolder.h"

#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkReverseSense.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>

namespace palpate::drill_tool_test
{
namespace
{
using Shape = TouchToolSettings::Shape;

class DrillTool : public testing::Test
{
protected:
  // Writes the triangles of a source to a file.
  std::filesystem::path Write(vtkPolyDataAlgorithm* source, const std::string& name) const
  {
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputConnection(source->GetOutputPort());
    triangles->Update();
    std::filesystem::path path = this->Folder / name;
    WriteSurface(path, triangles->GetOutput());
    return path;
  }
  TouchToolSettings Box(const std::string& name) const
  {
    vtkNew<vtkCubeSource> box;
    box->SetXLength(BoxSides[0]);
    box->SetYLength(BoxSides[1]);
    box->SetZLength(BoxSides[2]);
    TouchToolSettings settings;
    settings.Kind = Shape::Surface;
    settings.File = this->Write(box, name);
    settings.Points = 200;
    return settings;
  }
  // Every shape, of at least 2 mm.
  std::vector<TouchToolSettings> Tools() const
  {
    std::vector<TouchToolSettings> tools(4);
    tools[1].Kind = Shape::Capsule;
    tools[2].Kind = Shape::Ellipsoid;
    tools[3].Kind = Shape::Cylinder;
    for (TouchToolSettings& tool : tools)
    {
      tool.Length = 5.0;
      tool.SemiAxes = Vector3(4.0, 3.0, 2.0);
      tool.Points = 200;
    }
    tools.push_back(this->Box("box.stl"));
    return tools;
  }

  static constexpr std::array<double, 3> BoxSides{{6.0, 4.0, 8.0}}; // mm
  test::TemporaryFolder Folder;
};

// Volume that a tool removes from the centre of a block, mm^3; the mean of several poses.
class DrillToolBlock
{
public:
  DrillToolBlock()
  {
    std::vector<float> samples;
    for (std::size_t node = 0; node < this->Grid.NodeCount(); ++node)
    {
      const auto n = static_cast<int>(node);
      const std::array<int, 3> index{n % Side, n / Side % Side, n / (Side * Side)};
      const auto [least, most] = std::minmax_element(index.begin(), index.end());
      samples.push_back(*least > 0 && *most < Side - 1 ? 1000.0F : 0.0F);
    }
    FieldBuilder builder(this->Grid);
    builder.KeepInside(builder.AddMaterial(
        {builder.AddChannel(SamplesOfGrid(samples.data(), this->Grid)), 500.0}));
    std::shared_ptr<const ScalarField> field;
    Status status = builder.Build(field);
    if (status.IsOk())
    {
      status = DrilledField::Make(*field, 0, this->Drilled);
    }
    EXPECT_TRUE(status.IsOk()) << status.Message();
  }

  double RemovedBy(const CutTool& tool)
  {
    constexpr int Poses = 6;
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> part(-0.5, 0.5);
    double sum = 0.0;
    for (int pose = 0; pose < Poses; ++pose)
    {
      const Vector3 middle = Vector3::Constant(0.5 * Spacing * (Side - 1)) +
                             Spacing * Vector3(part(random), part(random), part(random));
      const CutPose place{middle, Eigen::Quaterniond(test::RandomOrientation(random))};
      EXPECT_TRUE(this->Drilled->Cut(tool, place, place).IsOk());
      sum += this->Drilled->RemovedVolume();
      this->Drilled->Reset();
    }
    return sum / Poses;
  }

private:
  static constexpr double Spacing = 0.3; // mm
  static constexpr int Side = 50;
  FieldGrid Grid{
      {Side, Side, Side}, Vector3::Zero(), Vector3::Constant(Spacing), Matrix3::Identity()};
  std::unique_ptr<DrilledField> Drilled;
};

// Each volume within the tolerance of spheres, though edges are rounded by half a voxel.
TEST_F(DrillTool, RemovesItsVolumeWithinOnePercent)
{
  const std::vector<double> volumes{4.0 / 3.0 * M_PI * 8.0,
                                    4.0 / 3.0 * M_PI * 8.0 + M_PI * 4.0 * 5.0,
                                    4.0 / 3.0 * M_PI * 4.0 * 3.0 * 2.0, M_PI * 4.0 * 5.0,
                                    BoxSides[0] * BoxSides[1] * BoxSides[2]};
  const std::vector<TouchToolSettings> tools = this->Tools();
  DrillToolBlock block;
  for (std::size_t n = 0; n < tools.size(); ++n)
  {
    EXPECT_NEAR(block.RemovedBy(MakeCutTool(tools[n])) / volumes[n], 1.0, 0.01) << n;
  }
}

// Contact and cutting shapes agree, also if the triangles of a file face inwards, and for every
// format.
TEST_F(DrillTool, TouchesWhereItCuts)
{
  vtkNew<vtkCubeSource> box;
  vtkNew<vtkReverseSense> inside;
  inside->SetInputConnection(box->GetOutputPort());
  inside->ReverseCellsOn();
  TouchToolSettings reversed;
  reversed.Kind = Shape::Surface;
  reversed.File = this->Write(inside, "inside.vtp");
  std::vector<TouchToolSettings> tools = this->Tools();
  tools.push_back(reversed);
  tools.push_back(this->Box("box.ply"));
  for (const TouchToolSettings& settings : tools)
  {
    const CutTool cut = MakeCutTool(settings);
    const ToolShape touch = MakeTool(settings);
    ASSERT_TRUE(touch.Check().IsOk());
    ASSERT_FALSE(touch.Points().empty());
    // Edges are rounded by half the diagonal of the distance samples.
    constexpr double Edges = 0.2;
    for (std::size_t n = 0; n < touch.Points().size(); ++n)
    {
      EXPECT_NEAR(cut.Distance(touch.Points()[n]), 0.0, Edges) << n;
      EXPECT_LT(cut.Distance(touch.Points()[n] + 0.4 * touch.Normals()[n]), 0.0) << n;
      EXPECT_GT(cut.Distance(touch.Points()[n] - 0.4 * touch.Normals()[n]), 0.0) << n;
    }
  }
}

TEST_F(DrillTool, ClearToolIsSmallerByTheClearance)
{
  for (const TouchToolSettings& settings : this->Tools())
  {
    const ToolShape touch = MakeTool(settings);
    const ToolShape clear = touch.Variant(static_cast<int>(touch.Points().size()), 0.1);
    // Points of a tool that is given by lengths are spread anew, and an ellipsoid with shorter axes
    // is not smaller by the same everywhere.
    const double error = settings.Kind == Shape::Surface ? 1e-12 : 0.01;
    ASSERT_EQ(clear.Points().size(), touch.Points().size());
    for (std::size_t n = 0; n < touch.Points().size(); ++n)
    {
      EXPECT_NEAR((clear.Points()[n] - touch.Points()[n]).dot(touch.Normals()[n]), 0.1, error);
    }
  }
  EXPECT_DOUBLE_EQ(ToolShape::Sphere(2.0).Variant(0, 0.1).Radius(), 1.9);
  EXPECT_EQ(ToolShape::Sphere(0.05).Variant(0, 0.1).Radius(), 0.0);
}

TEST_F(DrillTool, RejectsToolsWithoutVolume)
{
  vtkNew<vtkPlaneSource> plane;
  TouchToolSettings open;
  open.Kind = Shape::Surface;
  open.File = this->Write(plane, "plane.stl");
  TouchToolSettings missing = open;
  missing.File = this->Folder / "missing.stl";
  TouchToolSettings point;
  point.Radius = 0.0;
  TouchToolSettings disc;
  disc.Kind = Shape::Cylinder;
  disc.Length = 0.0;
  TouchToolSettings flat;
  flat.Kind = Shape::Ellipsoid;
  flat.SemiAxes = Vector3(3.0, 0.0, 2.0);
  for (const TouchToolSettings& settings : {open, missing, point, disc, flat})
  {
    EXPECT_THROW(MakeCutTool(settings), InputError);
  }
  EXPECT_THROW(MakeTool(open), InputError);
  EXPECT_THROW(MakeTool(missing), InputError);
  try
  {
    MakeCutTool(open);
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find("plane.stl"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("closed"), std::string::npos) << error.what();
  }
}

// Merged, such triangles are lines and points, and leave no edge open.
TEST_F(DrillTool, RejectsSurfacesOfTrianglesWithoutArea)
{
  TouchToolSettings settings;
  settings.Kind = Shape::Surface;
  settings.File = this->Folder / "lines.ply";
  std::ofstream(settings.File) << "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                                  "property float y\nproperty float z\nelement face 2\n"
                                  "property list uchar int vertex_indices\nend_header\n"
                                  "0 0 0\n1 0 0\n1 0 0\n0 0 0\n3 0 1 2\n3 1 2 3\n";
  EXPECT_THROW(MakeTool(settings), InputError);
  EXPECT_THROW(MakeCutTool(settings), InputError);
}

TEST_F(DrillTool, OffsetSurfaceCutsWhereItLies)
{
  vtkNew<vtkCubeSource> box;
  box->SetCenter(10.0, -2.0, 3.0);
  TouchToolSettings settings;
  settings.Kind = Shape::Surface;
  settings.File = this->Write(box, "beside.stl");
  const CutTool tool = MakeCutTool(settings);
  EXPECT_LT(tool.Distance(Vector3(10.0, -2.0, 3.0)), -0.4);
  EXPECT_GT(tool.Distance(Vector3::Zero()), 5.0);
}
} // namespace
} // namespace palpate::drill_tool_test
