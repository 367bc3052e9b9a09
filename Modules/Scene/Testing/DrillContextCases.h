#pragma once

#include "DrillContext.h"
#include "ImageWriter.h"
#include "LabelImages.h"
#include "RemovalBytes.h"
#include "SceneBuilder.h"
#include "TemporaryFolder.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace palpate::test
{
inline bool GoOn(double, const std::string&)
{
  return true;
}

/// A sphere of bone around the origin as an integer CT on an oblique grid, an off-centre nerve as a
/// label on a coarser grid, and the bone as a label on that grid too.
class BoneFiles
{
public:
  static constexpr double Iso = 500.0;
  static constexpr double BoneRadius = 8.0;  // mm
  static constexpr double NerveRadius = 1.5; // mm
  static constexpr int BoneLabel = 2;
  static constexpr int OtherLabel = 3;

  explicit BoneFiles(unsigned seed = 71)
  {
    std::mt19937_64 random(seed);
    LabelGrid grid;
    grid.Size = {{58, 54, 50}};
    grid.Spacing = {{0.35, 0.4, 0.45}};
    grid.Direction = RandomRotation(random);
    grid.CenterOnOrigin();
    this->Ct = MakeLabelImage<short>(grid, [](double, double, double) { return false; });
    for (vtkIdType voxel = 0; voxel < this->Ct->GetNumberOfPoints(); ++voxel)
    {
      const double depth = BoneRadius - Vector3(this->Ct->GetPoint(voxel)).norm();
      static_cast<short*>(this->Ct->GetScalarPointer())[voxel] =
          static_cast<short>(std::lround(1000.0 * std::clamp(0.5 + 0.5 * depth, 0.0, 1.0)));
    }
    grid.Size = {{50, 50, 50}};
    grid.Spacing = {{0.5, 0.5, 0.5}};
    grid.Direction = RandomRotation(random);
    grid.CenterOnOrigin();
    this->Nerve = MakeLabelImage(grid, [](double x, double y, double)
                                 { return std::hypot(x - 3.0, y) < NerveRadius; });
    this->Labels = MakeLabelImage(
        grid, [](double x, double y, double z) { return Vector3(x, y, z).norm() < BoneRadius; },
        BoneLabel);
    // With a core that is another structure.
    for (vtkIdType voxel = 0; voxel < this->Labels->GetNumberOfPoints(); ++voxel)
    {
      if (Vector3(this->Labels->GetPoint(voxel)).norm() < 2.0)
      {
        static_cast<unsigned char*>(this->Labels->GetScalarPointer())[voxel] = OtherLabel;
      }
    }
    WriteImage(this->CtPath, this->Ct);
    WriteImage(this->NervePath, this->Nerve);
    WriteImage(this->LabelsPath, this->Labels);
  }

  /// The bone of the CT, drilled by a sphere of 2 mm.
  SceneSettings Scene() const
  {
    SceneStructure bone;
    bone.Name = "bone";
    bone.File = this->CtPath;
    bone.Iso = Iso;
    bone.Drill.Wear = 0.1;
    SceneSettings settings;
    settings.Structures = {bone};
    settings.Tool.Points = 0;
    return settings;
  }
  SceneSettings SceneWithNerve() const
  {
    SceneSettings settings = this->Scene();
    SceneStructure nerve;
    nerve.Name = "nerve";
    nerve.File = this->NervePath;
    nerve.IsTouchable = false;
    nerve.IsVisible = false;
    nerve.IsForbidden = true;
    nerve.AlarmDistance = 1.25;
    settings.Structures.push_back(nerve);
    return settings;
  }
  /// The same with the label.
  SceneSettings SceneOfLabels() const
  {
    SceneSettings settings = this->Scene();
    settings.Structures[0].File = this->LabelsPath;
    settings.Structures[0].Iso.reset();
    settings.Structures[0].Labels = {std::to_string(BoneLabel)};
    settings.Structures[0].Representation = TouchRepresentation::SubVoxel;
    return settings;
  }

  TemporaryFolder Folder;
  vtkSmartPointer<vtkImageData> Ct;
  vtkSmartPointer<vtkImageData> Nerve;
  vtkSmartPointer<vtkImageData> Labels;
  std::filesystem::path CtPath = Folder / "ct.nrrd";
  std::filesystem::path NervePath = Folder / "nerve.nrrd";
  std::filesystem::path LabelsPath = Folder / "labels.nrrd";
};

inline std::shared_ptr<DrillContext> BenchOf(const SceneSettings& settings)
{
  const BuiltScene built = BuildScene(settings, GoOn);
  return DrillContext::Make(built.Settings, built.Contacts, built.Protections);
}

/// Issues cut orders as a servo does.
class ContextCuts
{
public:
  explicit ContextCuts(std::shared_ptr<DrillContext> context) : Context(std::move(context)) {}

  void Cut(const Vector3& from, const Vector3& to, int site = 0)
  {
    CutOrder order;
    order.Number = this->Number++;
    order.Site = site;
    order.From.PositionWorld = from;
    order.To.PositionWorld = to;
    ASSERT_TRUE(this->Context->Editor().Link()->Orders.Push(order));
    this->Context->Editor().Take();
    ASSERT_EQ(this->Context->Editor().Newest().Problem, "");
  }
  void CutAtRandom(std::mt19937_64& random, int count)
  {
    std::uniform_real_distribution<double> part(-6.0, 6.0);
    const auto place = [&] { return Vector3(part(random), part(random), part(random)); };
    for (int n = 0; n < count; ++n)
    {
      const Vector3 from = place();
      this->Cut(from, from + 0.3 * place());
    }
  }

private:
  std::shared_ptr<DrillContext> Context;
  std::uint64_t Number = 0;
};

inline std::vector<std::byte> StateOf(const DrillContext& context, std::size_t site = 0)
{
  return BytesOf(*context.Editor().Removed()[site]);
}
} // namespace palpate::test
