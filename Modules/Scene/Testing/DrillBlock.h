#pragma once

#include "ImageWriter.h"
#include "LabelImages.h"
#include "TemporaryFolder.h"
#include "TouchRun.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace palpate::test
{
inline bool NeverCancels(double, const std::string&)
{
  return true;
}

/// A block of bone as a scan of 0.4 mm voxels, iso-value 750, its top at z = 4 mm and its sides at
/// 7 mm, with a nerve of 1 mm radius round the y axis; and a scene in which a sphere of 1.6 mm
/// drills it.
class DrillBlock
{
public:
  static constexpr double Spacing = 0.4;
  static constexpr double Top = 4.0;
  static constexpr double Sphere = 1.6;
  static constexpr double Iso = 750.0;

  DrillBlock()
  {
    WriteImage(this->Scan, Sampled(
                               [](double x, double y, double z)
                               {
                                 const double depth = std::min(
                                     {7.0 - std::abs(x), 7.0 - std::abs(y), Top - z, z + 7.0});
                                 return std::clamp(Iso + Iso * depth / Spacing, 0.0, 2.0 * Iso);
                               },
                               VTK_SHORT));
    WriteImage(this->Nerve, Sampled([](double x, double y, double z)
                                    { return std::hypot(x, z) < 1.0 && std::abs(y) < 6.0; },
                                    VTK_UNSIGNED_CHAR));
  }

  SceneSettings Settings(bool hasNerve = false) const
  {
    SceneSettings settings;
    SceneStructure bone;
    bone.Name = "bone";
    bone.File = this->Scan;
    bone.Iso = Iso;
    bone.Drill.Wear = 0.5;
    settings.Structures = {bone};
    if (hasNerve)
    {
      SceneStructure nerve;
      nerve.Name = "nerve";
      nerve.File = this->Nerve;
      nerve.IsTouchable = false;
      nerve.IsVisible = false;
      nerve.IsForbidden = true;
      nerve.AlarmDistance = 1.0;
      settings.Structures.push_back(nerve);
    }
    settings.Tool.Radius = Sphere;
    settings.Tool.Points = 0;
    settings.Placement.Scale = 1.0;
    return settings;
  }

  /// Down to a height of the sphere's centre, along x there, and up again; the pedal is down from
  /// the first contact on.
  static TouchScript CanalAt(double height)
  {
    TouchScript script;
    script.Path = HandPath({{0.0, {-3.0, 0.0, 8.0}},
                            {1.0, {-3.0, 0.0, Top + Sphere + 0.2}},
                            {3.0, {-3.0, 0.0, height}},
                            {6.0, {3.0, 0.0, height}},
                            {8.0, {-3.0, 0.0, height}},
                            {9.0, {-3.0, 0.0, 8.0}}});
    script.Actions = {{0.9, DrillAction::Kind::Start}, {8.9, DrillAction::Kind::Stop}};
    return script;
  }

  TemporaryFolder Folder;
  std::filesystem::path Scan = Folder / "ct.nrrd";
  std::filesystem::path Nerve = Folder / "nerve.nrrd";

private:
  template <typename Value>
  static vtkSmartPointer<vtkImageData> Sampled(const Value& value, int type)
  {
    constexpr int Size = 52;
    constexpr double First = -0.5 * Spacing * (Size - 1);
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(Size, Size, Size);
    image->SetSpacing(Spacing, Spacing, Spacing);
    image->SetOrigin(First, First, First);
    image->AllocateScalars(type, 1);
    for (int k = 0; k < Size; ++k)
    {
      for (int j = 0; j < Size; ++j)
      {
        for (int i = 0; i < Size; ++i)
        {
          image->SetScalarComponentFromDouble(
              i, j, k, 0,
              std::round(static_cast<double>(
                  value(First + Spacing * i, First + Spacing * j, First + Spacing * k))));
        }
      }
    }
    return image;
  }
};

inline PreparedTouch Prepare(const SceneSettings& settings, const TouchScript& script)
{
  return PrepareTouch(settings, script, NeverCancels);
}
} // namespace palpate::test
