#include "SceneFile.h"

#include "InputError.h"
#include "TemporaryFolder.h"
#include "WholeFile.h"

#include <gtest/gtest.h>

namespace palpate::scene_file_test
{
namespace
{
class TouchSceneFile : public testing::Test
{
protected:
  SceneSettings Read(const std::string& text)
  {
    const std::filesystem::path path = this->Folder / "a.scene.json";
    WriteWholeFile(path, text);
    return ReadScene(path);
  }
  std::string Refusal(const std::string& text)
  {
    try
    {
      this->Read(text);
    }
    catch (const InputError& error)
    {
      return error.what();
    }
    return {};
  }

  test::TemporaryFolder Folder;
};

TEST_F(TouchSceneFile, LabelsAreNumbersOrNames)
{
  const auto labels = [this](const std::string& label)
  {
    return this
        ->Read(R"({"format": "palpate-scene", "structures": [{"file": "a.nrrd", "label": )" +
               label + "}]}")
        .Structures.front()
        .Labels;
  };
  using Words = std::vector<std::string>;
  EXPECT_EQ(labels("1"), Words{"1"});
  EXPECT_EQ(labels("\"1\""), Words{"1"});
  EXPECT_EQ(labels("\"tumour\""), Words{"tumour"});
  EXPECT_EQ(labels("[2, \"tumour\", \"3\"]"), (Words{"2", "tumour", "3"}));
}

TEST_F(TouchSceneFile, RoundTripsAllSettings)
{
  SceneSettings settings;
  SceneStructure gland;
  gland.Name = "gland";
  gland.File = this->Folder / "models/gland.json";
  gland.Mode = RadialContactMode::Radial;
  gland.Stiffness = 1.25;
  gland.Damping = 0.002;
  SceneStructure bone;
  bone.File = this->Folder / "ct.nrrd";
  bone.Iso = -300.5;
  bone.Representation = TouchRepresentation::SubVoxel;
  bone.Interpolation = FieldInterpolation::TricubicBSpline;
  bone.Smoothing = 2.5;
  bone.Friction = {0.4, 0.3};
  bone.SetNumber("viscosity_ns_per_mm", 0.003);
  bone.SetNumber("texture_n", 0.25);
  bone.SetImage("texture_image", this->Folder / "images/mr.nii.gz");
  bone.SetNumber("stiffness_from_n_per_mm", 0.3);
  bone.SetNumber("stiffness_from_value", -1000.5);
  bone.SetNumber("stiffness_to_n_per_mm", 2.0);
  bone.SetNumber("stiffness_to_value", 1500.25);
  bone.SetImage("stiffness_image", this->Folder / "images/ct.nii.gz");
  bone.SetNumber("gradient_n_mm", 0.8);
  bone.SetNumber("gradient_from_value", -20.25);
  bone.SetNumber("gradient_to_value", 1500.0);
  bone.SetNumber("gradient_largest_n", 0.3);
  bone.SetNumber("gradient_smoothing_mm", 1.5);
  bone.SetImage("gradient_image", this->Folder / "images/t2.nii.gz");
  SceneStructure mask;
  mask.File = this->Folder / "mask.nii.gz";
  mask.Labels = {"1", "tumour, left"};
  mask.Representation = TouchRepresentation::Facets;
  mask.Degree = 20;
  bone.IsVisible = false;
  bone.Opacity = 0.25;
  mask.IsTouchable = false;
  settings.Structures = {gland, bone, mask};
  settings.Tool.Kind = TouchToolSettings::Shape::Ellipsoid;
  settings.Tool.SemiAxes = Vector3(3.0, 2.0, 1.0);
  settings.Tool.Points = 77;
  settings.Guides = {{GuideShape::Path, {{1.5, 2.0, 3.0}, {4.0, 5.0, -6.25}}, 0.3, 12.0, 0.25},
                     {GuideShape::Point, {{7.0, 8.0, 9.0}}},
                     {GuideShape::Outside, {}, 0.4, 6.0, 1.5, 12, 2.5},
                     {GuideShape::Surface, {}, 0.2, 10.0, 0.5, 7, -3.0}};
  settings.Device = "replay:old.touch";
  settings.Rate = 2500.0;
  settings.ModelInterval = 4;
  settings.Placement.Scale = 0.5;
  const std::string text = SceneText(settings, this->Folder.Path());
  const SceneSettings back = this->Read(text);
  EXPECT_EQ(SceneText(back, this->Folder.Path()), text);
  EXPECT_EQ(back.Guides, settings.Guides);
  ASSERT_EQ(back.Structures.size(), 3U);
  EXPECT_EQ(back.Structures[0].File.lexically_normal(), gland.File.lexically_normal());
  EXPECT_EQ(back.Structures[0].Mode, RadialContactMode::Radial);
  EXPECT_EQ(back.Structures[1].Iso, -300.5);
  EXPECT_EQ(back.Structures[1].Opacity, 0.25);
  EXPECT_EQ(back.Structures[0].Opacity, 1.0) << "the default, which is not written";
  EXPECT_EQ(back.Structures[1].Friction.Dynamic, 0.3);
  EXPECT_EQ(back.Structures[1].Number("viscosity_ns_per_mm"), 0.003);
  EXPECT_EQ(back.Structures[1].Number("texture_n"), 0.25);
  EXPECT_EQ(back.Structures[1].Image("texture_image").lexically_normal(),
            bone.Image("texture_image").lexically_normal());
  EXPECT_EQ(back.Structures[1].Number("stiffness_from_value"), -1000.5);
  EXPECT_EQ(back.Structures[1].Number("stiffness_to_n_per_mm"), 2.0);
  EXPECT_EQ(back.Structures[1].Numbers, bone.Numbers);
  EXPECT_EQ(back.Structures[1].Image("stiffness_image").lexically_normal(),
            bone.Image("stiffness_image").lexically_normal());
  EXPECT_TRUE(back.Structures[0].Images.empty());
  EXPECT_EQ(back.Structures[2].Labels, mask.Labels);
  EXPECT_EQ(back.Structures[2].Degree, 20);
  EXPECT_TRUE(back.Structures[0].IsVisible && back.Structures[0].IsTouchable);
  EXPECT_TRUE(!back.Structures[1].IsVisible && back.Structures[1].IsTouchable);
  EXPECT_TRUE(back.Structures[2].IsVisible && !back.Structures[2].IsTouchable);
  EXPECT_EQ(back.Tool.SemiAxes, settings.Tool.SemiAxes);
  EXPECT_EQ(back.Rate, 2500.0);
  EXPECT_EQ(back.ModelInterval, 4);
  EXPECT_EQ(back.Placement.Scale, 0.5);
}

TEST_F(TouchSceneFile, RoundTripsALimitedIsoValue)
{
  SceneSettings settings;
  SceneStructure bone;
  bone.File = this->Folder / "ct";
  bone.Series = "2";
  bone.Iso = 300.0;
  bone.IsoUpper = 1200.5;
  bone.WithinFile = this->Folder / "masks/skull.nii.gz";
  bone.WithinLabel = "temporal bone, left";
  settings.Structures = {bone};
  const std::string text = SceneText(settings, this->Folder.Path());
  EXPECT_NE(text.find("\"masks/skull.nii.gz\""), std::string::npos) << text;
  const SceneSettings back = this->Read(text);
  EXPECT_EQ(SceneText(back, this->Folder.Path()), text);
  const SceneStructure& read = back.Structures.front();
  EXPECT_EQ(read.Series, "2");
  EXPECT_EQ(read.IsoUpper, 1200.5);
  EXPECT_EQ(read.WithinFile.lexically_normal(), bone.WithinFile.lexically_normal());
  EXPECT_EQ(read.WithinLabel, "temporal bone, left");
  EXPECT_EQ(read.Source(), SceneSource::IsoValue);
  EXPECT_TRUE(read.IsLimited());
}

TEST_F(TouchSceneFile, RejectsContradictoryLimits)
{
  const auto refusal = [this](const std::string& entries)
  {
    return this->Refusal(R"({"format": "palpate-scene", "structures": [{"file": "a.nrrd", )" +
                         entries + "}]}");
  };
  EXPECT_NE(refusal(R"("iso_upper": 5)").find("has no iso-value"), std::string::npos);
  EXPECT_NE(refusal(R"("within": "m.nrrd", "within_label": "1")").find("has no iso-value"),
            std::string::npos);
  EXPECT_NE(refusal(R"("iso": 5, "iso_upper": 5)").find("not above"), std::string::npos);
  EXPECT_NE(refusal(R"("iso": 5, "within": "m.nrrd")").find("only one of"), std::string::npos);
  EXPECT_NE(refusal(R"("iso": 5, "iso_upper": "6")").find("iso_upper"), std::string::npos);
  EXPECT_NE(refusal(R"("iso": 5, "within": "m.nrrd", "within_label": [1, 2])").find("several"),
            std::string::npos);
  EXPECT_EQ(refusal(R"("iso": 5, "iso_upper": 6, "within": "m.nrrd", "within_label": 1)"), "");
}

TEST_F(TouchSceneFile, WritesNamesOfAnyLength)
{
  const std::string name(5000, 'a');
  const SceneSettings settings =
      this->Read(R"({"format": "palpate-scene", "structures": [{"file": ")" + name + R"("}]})");
  EXPECT_NE(SceneText(settings, this->Folder.Path()).find(name), std::string::npos);
}

TEST_F(TouchSceneFile, MissingEntriesHaveDefaults)
{
  const SceneSettings settings =
      this->Read(R"({"format": "palpate-scene", "structures": [{"file": "a.json"}]})");
  const SceneStructure usual;
  ASSERT_EQ(settings.Structures.size(), 1U);
  EXPECT_EQ(settings.Structures[0].File, this->Folder / "a.json");
  EXPECT_EQ(settings.Structures[0].Stiffness, usual.Stiffness);
  EXPECT_EQ(settings.Structures[0].Representation, TouchRepresentation::Automatic);
  EXPECT_FALSE(settings.Structures[0].Iso.has_value());
  EXPECT_TRUE(settings.Structures[0].IsVisible);
  EXPECT_TRUE(settings.Structures[0].IsTouchable);
  EXPECT_FALSE(settings.Structures[0].IsDrilled());
  EXPECT_FALSE(settings.Structures[0].IsForbidden);
  EXPECT_EQ(settings.Device, "simulated");
  EXPECT_FALSE(settings.Placement.Scale.has_value());
}

TEST_F(TouchSceneFile, DropsRetiredKeys)
{
  const SceneSettings settings = this->Read(R"({"format": "palpate-scene", "structures": [
      {"file": "a.json", "precision": "float", "brick_cells": 16}], "memory_mb": 50})");
  const std::string text = SceneText(settings, this->Folder.Path());
  for (const char* key : {"precision", "brick_cells", "memory_mb"})
  {
    EXPECT_EQ(text.find(key), std::string::npos) << key;
  }
}

TEST_F(TouchSceneFile, RoundTripsDrillSettings)
{
  SceneSettings settings;
  SceneStructure bone;
  bone.File = this->Folder / "ct.nrrd";
  bone.Iso = 300.0;
  bone.Drill.Wear = 0.125;
  bone.Drill.Drag = 0.003;
  bone.Drill.Vibration = 0.25;
  SceneStructure nerve;
  nerve.File = this->Folder / "nerve.nrrd";
  nerve.IsForbidden = true;
  nerve.AlarmDistance = 1.5;
  settings.Structures = {bone, nerve};
  settings.Drill.Turns = 700.0;
  settings.Drill.VibrationFrequency = 90.0;
  settings.Tool.Kind = TouchToolSettings::Shape::Surface;
  settings.Tool.File = this->Folder / "tools/burr.stl";
  const std::string text = SceneText(settings, this->Folder.Path());
  const SceneSettings back = this->Read(text);
  EXPECT_EQ(SceneText(back, this->Folder.Path()), text);
  ASSERT_EQ(back.Structures.size(), 2U);
  EXPECT_EQ(back.Structures[0].Drill.Wear, 0.125);
  EXPECT_EQ(back.Structures[0].Drill.Drag, 0.003);
  EXPECT_EQ(back.Structures[0].Drill.Vibration, 0.25);
  EXPECT_TRUE(back.Structures[0].IsDrilled() && !back.Structures[0].IsForbidden);
  EXPECT_TRUE(!back.Structures[1].IsDrilled() && back.Structures[1].IsForbidden);
  EXPECT_EQ(back.Structures[1].AlarmDistance, 1.5);
  EXPECT_EQ(back.Drill.Turns, 700.0);
  EXPECT_EQ(back.Drill.VibrationFrequency, 90.0);
  EXPECT_EQ(back.Tool.Kind, TouchToolSettings::Shape::Surface);
  EXPECT_EQ(back.Tool.File.lexically_normal(), settings.Tool.File.lexically_normal());
}

// Each with a word that its error message must contain.
TEST_F(TouchSceneFile, RejectsInvalidEntriesByName)
{
  const std::string begin = R"({"format": "palpate-scene", "structures": [{"file": "a.json")";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"no JSON", "JSON"},
      {"[]", "object"},
      {"{}", "format"},
      {R"({"format": "palpate-model"})", "format"},
      {R"({"format": "palpate-scene"})", "structures"},
      {R"({"format": "palpate-scene", "structures": []})", "structures"},
      {R"({"format": "palpate-scene", "structures": [{}]})", "file"},
      {R"({"format": "palpate-scene", "structures": [3]})", "structures[0]"},
      {begin + R"(, "stiffness": 1}]})", "stiffness"},
      {begin + R"(, "stiffness_n_per_mm": -1}]})", "stiffness_n_per_mm"},
      {begin + R"(, "stiffness_n_per_mm": "stiff"}]})", "stiffness_n_per_mm"},
      {begin + R"(, "degree": 2.5}]})", "degree"},
      {begin + R"(, "iso": null}]})", "iso"},
      {begin + R"(, "representation": "voxels"}]})", "sub-voxel"},
      {begin + R"(, "label": )" + std::string(1000000, '[') + std::string(1000000, ']') + "}]}",
       "nested more than 64 deep"},
      {begin + R"(, "label": [1.5]}]})", "label"},
      {begin + R"(, "label": 0}]})", "a label's number from 1"},
      {begin + R"(, "label": -1}]})", "label"},
      {begin + R"(, "label": 3000000000}]})", "label"},
      {begin + R"(, "label": true}]})", "label"},
      {begin + R"(, "seen": 1}]})", "seen"},
      {begin + R"(, "opacity": 1.5}]})", "opacity"},
      {begin + R"(, "touched": "no"}]})", "touched"},
      {begin + R"(, "viscosity_ns_per_mm": -1}]})", "viscosity_ns_per_mm"},
      {begin + R"(, "texture_n": 0.1}]})", "texture_image"},
      {begin + R"(, "texture_image": "mr.nrrd"}]})", "texture_n"},
      {begin + R"(, "stiffness_from_n_per_mm": 1}]})", "stiffness_image"},
      {begin + R"(, "stiffness_image": "mr.nrrd"}]})", "stiffness_from_n_per_mm"},
      {begin + R"(, "stiffness_from_n_per_mm": -1, "stiffness_image": "mr.nrrd"}]})",
       "stiffness_from_n_per_mm"},
      {begin + R"(, "stiffness_to_n_per_mm": 1e5}]})", "stiffness_to_n_per_mm"},
      {begin + R"(, "stiffness_to_value": -1e7}]})", "stiffness_to_value"},
      {begin + R"(, "gradient_n_mm": 1}]})", "gradient_image"},
      {begin + R"(, "gradient_image": "mr.nrrd"}]})", "gradient_n_mm"},
      {begin + R"(, "gradient_n_mm": 101, "gradient_image": "mr.nrrd"}]})", "gradient_n_mm"},
      {begin + R"(, "gradient_largest_n": 3.5}]})", "gradient_largest_n"},
      {begin + R"(, "gradient_smoothing_mm": -1}]})", "gradient_smoothing_mm"},
      {begin + R"(, "modulus_kpa": -1}]})", "modulus_kpa"},
      {begin + R"(, "modulus_kpa": 1e7}]})", "modulus_kpa"},
      {begin + R"(, "poisson_ratio": 0.5}]})", "poisson_ratio"},
      {begin + R"(, "free_side": "backwards"}]})", "posterior"},
      {begin + R"(, "free_side": 3}]})", "free_side"},
      {begin + R"(, "free_degrees": 180}]})", "free_degrees"},
      {begin + R"(, "elements_across": 4.5}]})", "elements_across"},
      {begin + R"(, "elastography_image": 1}]})", "elastography_image"},
      {begin + R"(, "inclusion_kpa": 60}]})", "inclusion_kpa"},
      {begin + R"(, "holds_kpa_per_mm": 2}]})", "holds_kpa_per_mm"},
      {begin + R"(, "drill": {"wear_mm_per_nm": 0.1}, "representation": "elastic"}]})",
       "sub-voxel"},
      {begin + R"(}], "tool": {"semi_axes_mm": [1, 2]}})", "semi_axes_mm"},
      {begin + R"(}], "tool": {"points": 100000}})", "points"},
      {begin + R"(}], "tool": {"shape": "cone"}})", "cylinder"},
      {begin + R"(}], "tool": {"shape": "surface"}})", "file"},
      {begin + R"(}], "tool": {"shape": "sphere", "file": "burr.stl"}})", "file"},
      {begin + R"(, "drill": 0.1}]})", "structures[0].drill"},
      {begin + R"(, "drill": {"wear": 0.1}}]})", "wear_mm_per_nm"},
      {begin + R"(, "drill": {"wear_mm_per_nm": -0.1}}]})", "wear_mm_per_nm"},
      {begin + R"(, "drill": {"wear_mm_per_nm": 0.1, "vibration": 2}}]})", "vibration"},
      {begin + R"(, "drill": {"wear_mm_per_nm": 0.1}, "forbidden": true}]})", "forbidden"},
      {begin + R"(, "drill": {"wear_mm_per_nm": 0.1}, "touched": false}]})", "touched"},
      {begin + R"(, "drill": {"wear_mm_per_nm": 0.1}, "representation": "facets"}]})", "sub-voxel"},
      {begin + R"(, "drill": {"wear_mm_per_nm": 0.1}, "representation": "elastic"}]})",
       "sub-voxel"},
      {begin + R"(, "drill": {"wear_mm_per_nm": 0.1}, "interpolation": "cubic"}]})",
       "interpolation"},
      {begin + R"(, "forbidden": true, "alarm_mm": -1}]})", "alarm_mm"},
      {begin + R"(}], "drill": {"turns_per_s": -1}})", "turns_per_s"},
      {begin + R"(}], "drill": {"vibration_hz": 1000}})", "vibration_hz"},
      {begin + R"(}], "drill": {"rpm": 1000}})", "turns_per_s"},
      {begin + R"(}], "guides": 3})", "guides"},
      {begin + R"(}], "guides": [{"points": []}]})", "guides[0]"},
      {begin + R"(}], "guides": [{"shape": "line"}]})", "plane"},
      {begin + R"(}], "guides": [{"points": [{"position_mm": [1, 2]}]}]})", "position_mm"},
      {begin + R"(}], "guides": [{"shape": "path", "points": [{"position_mm": [1, 2, 3]}]}]})",
       "guides[0]"},
      {begin + R"(}], "guides": [{"points": [{"position_mm": [1, 2, 3]}], "range_mm": 0}]})",
       "positive"},
      {begin + R"(}], "guides": [{"points": [{"position_mm": [1, 2, 3]}], "largest_n": 4}]})",
       "largest_n"},
      {begin + R"(}], "guides": [{"shape": "inside"}]})", "number of a label"},
      {begin + R"(}], "guides": [{"shape": "inside", "structure": -1}]})", "structure"},
      {begin + R"(}], "guides": [{"shape": "surface", "structure": 1, "distance_mm": 1e5}]})",
       "distance_mm"},
      {begin + R"(, "stiffness_n_per_mm": 101}]})", "stiffness_n_per_mm"},
      {begin + R"(}], "tool": {"radius_mm": 101}})", "radius_mm"},
      {begin + R"(}], "device": 4})", "device"},
      {begin + R"(}], "rate_hz": 0})", "rate_hz"},
      {begin + R"(}], "scale": 1e9})", "scale"},
      {begin + R"(}], "rate": 1000})", "rate_hz"}};
  for (const auto& [text, word] : cases)
  {
    const std::string refusal = this->Refusal(text);
    EXPECT_NE(refusal.find(word), std::string::npos) << text << ": " << refusal;
    EXPECT_NE(refusal.find("a.scene.json"), std::string::npos) << refusal;
  }
}
} // namespace
} // namespace palpate::scene_file_test
