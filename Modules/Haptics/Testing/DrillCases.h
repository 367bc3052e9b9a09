#pragma once

#include "DrillEditor.h"
#include "FieldContactCases.h"
#include "RemovalBytes.h"
#include "TouchScene.h"

#include <algorithm>
#include <vector>

namespace palpate::test
{
/// A block of bone with its top at z = 6 mm, in a grid of 0.5 mm around the origin, and a sphere of
/// 2 mm that drills it, with its editor.
class DrilledBlock
{
public:
  static constexpr double Spacing = 0.5; // mm
  static constexpr double Top = 6.0;     // mm
  static constexpr double Radius = 2.0;  // mm, of the tool
  static constexpr double Clearance = 0.1 * Spacing;
  static constexpr double Stiffness = 0.5;

  DrilledBlock() : Field(BlockField())
  {
    std::vector<std::unique_ptr<DrilledField>> fields(1);
    Status status = DrilledField::Make(*this->Field, 0, fields[0]);
    EXPECT_TRUE(status.IsOk()) << status.Message();
    status = DrillEditor::Make(std::move(fields), this->Editor);
    EXPECT_TRUE(status.IsOk()) << status.Message();
    int tool = -1;
    EXPECT_TRUE(this->Editor->AddTool(CutTool::Sphere(Radius), tool).IsOk());
    EXPECT_EQ(tool, 0);
  }

  /// Wears by `wear` at 1,000 turns a second (DrillLaw::Wear).
  TouchScene Scene(double wear = 0.5) const
  {
    TouchScene scene;
    scene.Tool = ToolShape::Sphere(Radius - Clearance);
    scene.Structures.push_back({"bone", FieldContact(this->Field), {Stiffness, 0.0}, {}});
    scene.Structures[0].Id = 1;
    scene.Structures[0].Site = 0;
    scene.Structures[0].Drill.Wear = wear;
    scene.Drill.Link = this->Editor->Link();
    scene.Drill.Motion.Radius = Radius;
    scene.Drill.Clearance = Clearance;
    scene.Drill.Motion.Turns = 1000.0;
    return scene;
  }
  /// Fraction of its depth that the tool loses per second, in such a scene.
  static double FeedConstant(double wear = 0.5)
  {
    return wear * 2e-3 * M_PI * Radius * 1000.0 * Stiffness;
  }

  /// The removed region as bytes.
  std::vector<std::byte> State() const { return BytesOf(*this->Editor->Removed()[0]); }

private:
  static std::shared_ptr<const ScalarField> BlockField()
  {
    constexpr int Size = 49;
    const FieldGrid grid({Size, Size, Size}, Vector3::Constant(-0.5 * Spacing * (Size - 1)),
                         Vector3::Constant(Spacing), Matrix3::Identity());
    std::vector<float> samples(grid.NodeCount());
    for (std::size_t n = 0; n < samples.size(); ++n)
    {
      const double depth = Top - grid.PointWorld(NodeIndex(grid.Size(), n))[2];
      samples[n] = static_cast<float>(1000.0 * std::clamp(0.5 + 0.5 * depth / Spacing, 0.0, 1.0));
    }
    FieldBuilder builder(grid);
    const int channel = builder.AddChannel(SamplesOfGrid(samples.data(), grid));
    builder.KeepInside(builder.AddMaterial({channel, 500.0}));
    std::shared_ptr<const ScalarField> field;
    const Status status = builder.Build(field);
    EXPECT_TRUE(status.IsOk()) << status.Message();
    return field;
  }

  std::shared_ptr<const ScalarField> Field;

public:
  std::unique_ptr<DrillEditor> Editor;
};
} // namespace palpate::test
