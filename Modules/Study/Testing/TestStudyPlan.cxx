#include "StudyPlan.h"

#include "StudyPhantoms.h"

#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace palpate::study_plan_test
{
namespace
{
using Place = std::pair<SceneStep, int>;
using Places = std::set<Place>;
using Step = SceneStep;

// Structures of every representation, one drilled and one forbidden.
enum Label
{
  Whole = 0,
  Harmonics = 1,
  Facets = 2,
  Field = 3,
  Bone = 4,
  Nerve = 5
};

struct Inputs
{
  StudyState State;
  SceneStamps Stamps{{"/volume.nii.gz", "v"}, {"/mask.nii.gz", "s"}, {"/tool.stl", "t"}};
  int Outside = 0; // id of an inclusion that lies in no structure
};

Inputs Base()
{
  Inputs base;
  base.State.VolumeFile = "/volume.nii.gz";
  base.State.SegmentationFile = "/mask.nii.gz";
  const auto add = [&](int label, const std::string& representation) -> SceneStructure&
  {
    base.State.Structures.push_back(
        test::StudyPhantom::Structure(label, representation, base.State.SegmentationFile));
    return base.State.Structures.back();
  };
  add(Harmonics, TouchRepresentation::Harmonics);
  add(Facets, TouchRepresentation::Facets);
  add(Field, TouchRepresentation::SubVoxel);
  add(Bone, TouchRepresentation::SubVoxel).Drill.Wear = 0.1;
  SceneStructure& nerve = add(Nerve, TouchRepresentation::Automatic);
  nerve.IsVisible = false;
  nerve.IsTouchable = false;
  nerve.IsForbidden = true;
  base.State.Tool.Kind = TouchToolSettings::Shape::Surface;
  base.State.Tool.File = "/tool.stl";
  return base;
}

// As if nothing had been made but the comparisons of inclusions, with every inclusion within every
// structure that yields except `Outside`.
std::map<Place, std::string> KeysOf(const Inputs& inputs)
{
  auto placed = std::make_shared<SceneInclusions>();
  for (const SceneStructure& structure : inputs.State.Structures)
  {
    const double inside = structure.Id == inputs.Outside ? 0.0 : 1.0;
    placed->Shares.emplace_back(structure.Id, InclusionShare{"inclusion", 1.0, inside});
  }
  const SceneProduct inclusions{std::shared_ptr<const SceneInclusions>(placed)};
  const SceneLookup lookup = [&inclusions](const std::string& key)
  { return key.find("|inclusions") != std::string::npos ? &inclusions : nullptr; };
  std::map<Place, std::string> keys;
  for (const SceneNode& node : PlanStudy(inputs.State, inputs.Stamps, lookup))
  {
    keys[{node.Step, node.Id}] = node.Key;
  }
  return keys;
}

Places Without(Places all, const Places& some)
{
  for (const Place& one : some)
  {
    all.erase(one);
  }
  return all;
}

Places And(Places some, const Places& others)
{
  some.insert(others.begin(), others.end());
  return some;
}

struct Change
{
  const char* Name;
  std::function<void(Inputs&)> Do;
  Places Changed; ///< the products that depend on it
};

void ExpectChanges(const Inputs& base, const std::vector<Change>& changes)
{
  const std::map<Place, std::string> before = KeysOf(base);
  for (const Change& change : changes)
  {
    Inputs next = base;
    change.Do(next);
    const std::map<Place, std::string> after = KeysOf(next);
    ASSERT_EQ(after.size(), before.size()) << change.Name;
    for (const auto& [place, key] : before)
    {
      EXPECT_EQ(after.at(place) != key, change.Changed.count(place) > 0)
          << change.Name << ": " << NameOf(place.first) << " of " << place.second;
    }
  }
}

Places AllPlaces(const Inputs& inputs)
{
  Places places;
  for (const auto& [place, key] : KeysOf(inputs))
  {
    places.insert(place);
  }
  return places;
}

const Places ModelPlaces{
    {Step::Model, Harmonics}, {Step::Touch, Harmonics}, {Step::Cost, Harmonics}};
const Places SamplePlaces = And(ModelPlaces, {{Step::Samples, Harmonics}});
const Places SurfacePlaces = And(SamplePlaces, {{Step::Surface, Harmonics},
                                                {Step::Surface, Facets},
                                                {Step::Touch, Facets},
                                                {Step::Cost, Facets}});
const Places FieldPlaces{{Step::Field, Field}, {Step::Touch, Field}, {Step::Cost, Field}};
const Places BonePlaces{
    {Step::Field, Bone}, {Step::Touch, Bone}, {Step::Cost, Bone}, {Step::Protection, Nerve}};
const Places CostPlaces{
    {Step::Cost, Harmonics}, {Step::Cost, Facets}, {Step::Cost, Field}, {Step::Cost, Bone}};
const Places ToolPlaces = And(CostPlaces, {{Step::Tool, Whole}});

// Changes every structure.
std::function<void(Inputs&)> OfEach(const std::function<void(SceneStructure&)>& change)
{
  return [change](Inputs& inputs)
  {
    for (SceneStructure& one : inputs.State.Structures)
    {
      change(one);
    }
  };
}

TEST(StudyPlan, EveryInputOfAProductIsInItsKey)
{
  const Inputs base = Base();
  const Places ofMask = Without(AllPlaces(base), {{Step::Volume, Whole}, {Step::Tool, Whole}});
  const auto fit = [](auto member, auto value)
  { return [=](Inputs& inputs) { inputs.State.Fit.*member = value; }; };
  const auto tool = [](auto member, auto value)
  { return [=](Inputs& inputs) { inputs.State.Tool.*member = value; }; };
  const auto first = [](auto member, auto value)
  { return [=](Inputs& inputs) { inputs.State.Structures[0].*member = value; }; };
  ExpectChanges(
      base,
      {{"volume", [](Inputs& i) { i.State.VolumeFile = "/b.nii"; }, {{Step::Volume, Whole}}},
       {"volume's content",
        [](Inputs& i) { i.Stamps["/volume.nii.gz"] = "w"; },
        {{Step::Volume, Whole}}},
       {"series", [](Inputs& i) { i.State.DicomSeries = "2"; }, {{Step::Volume, Whole}}},
       {"axes",
        [](Inputs& i)
        {
          i.State.LeftHanded = i.State.LeftHanded == LeftHandedAxes::Refuse
                                   ? LeftHandedAxes::Reverse
                                   : LeftHandedAxes::Refuse;
        },
        And(ofMask, {{Step::Volume, Whole}})},
       {"mask",
        [](Inputs& i)
        {
          i.State.SegmentationFile = "/b.nii";
          OfEach([](SceneStructure& s) { s.File = "/b.nii"; })(i);
        },
        ofMask},
       {"mask's content", [](Inputs& i) { i.Stamps["/mask.nii.gz"] = "r"; }, ofMask},
       {"method", fit(&FitSettings::Method, FitSettings::SurfaceMethod::Plain), SurfacePlaces},
       {"smoothing", fit(&FitSettings::Smoothing, 0.25), SurfacePlaces},
       {"component", fit(&FitSettings::Component, 2), SurfacePlaces},
       {"rules", fit(&FitSettings::Rules, 1), SamplePlaces},
       {"kind of model", fit(&FitSettings::Model, FitSettings::ModelKind::Surface), SamplePlaces},
       {"component alone", fit(&FitSettings::IsAlone, true), SamplePlaces},
       {"repair", fit(&FitSettings::Repairs, true), SamplePlaces},
       {"frequency", fit(&FitSettings::Frequency, 11), SamplePlaces},
       {"centre", fit(&FitSettings::Center, FitSettings::CenterChoice::MostVisible), SamplePlaces},
       {"given centre", fit(&FitSettings::GivenCenterWorld, std::array<double, 3>{{1.0, 2.0, 3.0}}),
        SamplePlaces},
       {"hidden", fit(&FitSettings::MaximumHiddenPercent, 50.0), SamplePlaces},
       {"degree", first(&SceneStructure::Degree, 9), ModelPlaces},
       {"tolerance", fit(&FitSettings::Tolerance, 0.5), ModelPlaces},
       {"highest degree", fit(&FitSettings::MaximumDegree, 7), ModelPlaces},
       {"weight", fit(&FitSettings::Weight, FitSettings::SampleWeight::Uniform), ModelPlaces},
       {"penalty", fit(&FitSettings::PenaltyKind, FitSettings::Penalty::Given), ModelPlaces},
       {"roughness", fit(&FitSettings::Roughness, 1e-3), ModelPlaces},
       {"robust", fit(&FitSettings::IsRobust, true), ModelPlaces},
       {"Dice", fit(&FitSettings::MinimumDice, 0.5), SamplePlaces},
       {"interpolation",
        OfEach([](SceneStructure& s) { s.Interpolation = FieldInterpolation::TricubicBSpline; }),
        FieldPlaces},
       {"field's smoothing", OfEach([](SceneStructure& s) { s.Smoothing = 0.5; }),
        And(FieldPlaces, BonePlaces)},
       {"mode",
        first(&SceneStructure::Mode, RadialContactMode::Radial),
        {{Step::Touch, Harmonics}, {Step::Cost, Harmonics}}},
       {"tool's shape", tool(&TouchToolSettings::Radius, 1.5), CostPlaces},
       {"tool's length", tool(&TouchToolSettings::Length, 1.5), CostPlaces},
       {"tool's axes", tool(&TouchToolSettings::SemiAxes, Vector3(1.0, 2.0, 3.0)), CostPlaces},
       {"tool's points", tool(&TouchToolSettings::Points, 600), ToolPlaces},
       {"tool's file", tool(&TouchToolSettings::File, std::filesystem::path("/b.stl")), ToolPlaces},
       {"tool's content", [](Inputs& i) { i.Stamps["/tool.stl"] = "u"; }, ToolPlaces}});
}

// A limited iso-value is made again for each of its limits.
TEST(StudyPlan, EveryLimitOfAnIsoValueIsInItsKeys)
{
  Inputs base;
  SceneStructure bone;
  bone.Id = Bone;
  bone.File = "/volume.nii.gz";
  bone.Iso = 300.0;
  bone.IsoUpper = 900.0;
  bone.WithinFile = "/mask.nii.gz";
  bone.WithinLabel = "1";
  bone.Appearance = SceneAppearance::Surface;
  base.State.Structures = {bone};
  const Places made{
      {Step::Surface, Bone}, {Step::Field, Bone}, {Step::Touch, Bone}, {Step::Cost, Bone}};
  const auto expectRemade = [&](const char* name, const auto& change, const Places& read)
  {
    Inputs next = base;
    change(next);
    const auto before = KeysOf(base);
    const auto after = KeysOf(next);
    for (const Place& place : And(made, read))
    {
      EXPECT_NE(before.at(place), after.at(place)) << name << ": " << NameOf(place.first);
    }
  };
  const auto of = [](auto member, auto value)
  { return [=](Inputs& inputs) { inputs.State.Structures[0].*member = value; }; };
  expectRemade("lower", of(&SceneStructure::Iso, 301.0), {});
  expectRemade("upper", of(&SceneStructure::IsoUpper, 901.0), {});
  expectRemade("no upper", of(&SceneStructure::IsoUpper, std::optional<double>()), {});
  expectRemade("label", of(&SceneStructure::WithinLabel, std::string("2")), {});
  expectRemade("series", of(&SceneStructure::Series, std::string("2")), {});
  expectRemade("mask", [](Inputs& i) { i.Stamps["/mask.nii.gz"] = "r"; },
               {{Step::Segmentation, Bone}});
  expectRemade("image", [](Inputs& i) { i.Stamps["/volume.nii.gz"] = "w"; }, {});
}

// Settings of the view or of the force law alone do not remake products.
TEST(StudyPlan, KeysOmitIrrelevantSettings)
{
  ExpectChanges(Base(), {{"stiffness", OfEach([](SceneStructure& s) { s.Stiffness = 1.25; }), {}},
                         {"friction",
                          OfEach(
                              [](SceneStructure& s) {
                                s.Friction = {0.4, 0.3};
                              }),
                          {}},
                         {"name", OfEach([](SceneStructure& s) { s.Name = "other"; }), {}},
                         {"colour",
                          OfEach(
                              [](SceneStructure& s) {
                                s.Color = {{0.0, 0.0, 1.0}};
                              }),
                          {}},
                         {"opacity", OfEach([](SceneStructure& s) { s.Opacity = 0.5; }), {}},
                         {"alarm", OfEach([](SceneStructure& s) { s.AlarmDistance = 7.0; }), {}},
                         {"drag", OfEach([](SceneStructure& s) { s.Drill.Drag = 0.01; }), {}},
                         {"turns", [](Inputs& i) { i.State.Drill.Turns = 5.0; }, {}},
                         {"view", [](Inputs& i) { i.State.View.OverlayOpacity = 0.125; }, {}},
                         {"device", [](Inputs& i) { i.State.Device = "falcon"; }, {}},
                         {"placement", [](Inputs& i) { i.State.Placement.Scale = 2.0; }, {}}});
}

// Structures 1 and 2 yield; 2, 3 and 4 have moduli as inclusions.
Inputs Yielding()
{
  Inputs inputs = Base();
  inputs.State.Structures[0].Representation = TouchRepresentation::Elastic;
  inputs.State.Structures[0].SetImage("elastography_image", "/mre.nii.gz");
  inputs.State.Structures[1].Representation = TouchRepresentation::Elastic;
  inputs.State.Structures[1].SetNumber("inclusion_kpa", 50.0);
  inputs.State.Structures[2].SetNumber("inclusion_kpa", 60.0);
  inputs.State.Structures[3].SetNumber("inclusion_kpa", 70.0);
  inputs.Stamps["/mre.nii.gz"] = "m";
  inputs.Stamps["/lesion.nii.gz"] = "l";
  return inputs;
}

TEST(StudyPlan, ElasticityIsMadeAgainOnlyForWhatItDependsOn)
{
  const Places first{
      {Step::Elasticity, Harmonics}, {Step::Touch, Harmonics}, {Step::Cost, Harmonics}};
  const Places second{{Step::Elasticity, Facets}, {Step::Touch, Facets}, {Step::Cost, Facets}};
  const auto set = [](std::size_t structure, const char* key, double number)
  { return [=](Inputs& inputs) { inputs.State.Structures[structure].SetNumber(key, number); }; };
  ExpectChanges(
      Yielding(),
      {{"modulus", set(0, "modulus_kpa", 30.0), first},
       {"Poisson's ratio", set(0, "poisson_ratio", 0.4), first},
       {"support", set(0, "support_kpa_per_mm", 2.0), first},
       {"free side", set(0, "free_side", 2.0), first},
       {"angle", set(0, "free_degrees", 30.0), first},
       {"elements", set(0, "elements_across", 8.0), first},
       {"degree of compliance", set(0, "compliance_degree", 8.0), first},
       {"degree of the usual maps",
        set(0, "map_degree", 12.0),
        {{Step::Touch, Harmonics}, {Step::Cost, Harmonics}}},
       {"degree of finer maps", set(0, "map_degree", 24.0), first},
       {"elastography", [](Inputs& i) { i.Stamps["/mre.nii.gz"] = "n"; },
        And(first, {{Step::Image, Harmonics}})},
       {"modulus of the other", set(1, "modulus_kpa", 30.0), second},
       {"the other as an inclusion", set(1, "inclusion_kpa", 70.0), first},
       {"inclusion of both", set(2, "inclusion_kpa", 70.0), And(first, second)},
       {"no inclusion", set(2, "inclusion_kpa", 0.0),
        And(And(first, second), {{Step::Inclusions, Harmonics}, {Step::Inclusions, Facets}})},
       {"colour of an inclusion",
        [](Inputs& i) {
          i.State.Structures[2].Color = {{0.0, 0.0, 1.0}};
        },
        {}}});
}

TEST(StudyPlan, InclusionElsewhereDoesNotCount)
{
  Inputs inputs = Yielding();
  inputs.Outside = Field;
  const auto set = [](const char* key, double number)
  { return [=](Inputs& i) { i.State.Structures[2].SetNumber(key, number); }; };
  ExpectChanges(inputs, {{"modulus", set("inclusion_kpa", 70.0), {}},
                         {"none",
                          set("inclusion_kpa", 0.0),
                          {{Step::Inclusions, Harmonics}, {Step::Inclusions, Facets}}}});
}

TEST(StudyPlan, SofteningWaitsForTheComparisonWithInclusions)
{
  const Inputs inputs = Yielding();
  const SceneLookup nothing = [](const std::string&) { return nullptr; };
  for (const SceneNode& node : PlanStudy(inputs.State, inputs.Stamps, nothing))
  {
    const bool isOfBoth = node.Id == Harmonics || node.Id == Facets;
    const bool isLate = node.Step == Step::Elasticity || node.Step == Step::Touch;
    EXPECT_EQ(node.Key.empty(), isOfBoth && (isLate || node.Step == Step::Cost))
        << NameOf(node.Step) << " of " << node.Id;
    if (isOfBoth && isLate)
    {
      ASSERT_EQ(node.Inputs.size(), 1U);
      EXPECT_NE(node.Inputs.front().find("|inclusions"), std::string::npos);
    }
  }
}

TEST(StudyPlan, ReadsInclusionsThatAreNeitherShownNorTouched)
{
  Inputs inputs = Yielding();
  SceneStructure lesion = test::StudyPhantom::Structure(9, TouchRepresentation::Automatic);
  lesion.File = "/lesion.nii.gz";
  lesion.IsVisible = false;
  lesion.IsTouchable = false;
  inputs.State.Structures.push_back(lesion);
  EXPECT_EQ(KeysOf(inputs).count({Step::Segmentation, 9}), 0U);
  inputs.State.Structures.back().SetNumber("inclusion_kpa", 60.0);
  EXPECT_EQ(KeysOf(inputs).count({Step::Segmentation, 9}), 1U);
  inputs.State.Structures[0].Representation = TouchRepresentation::Harmonics;
  inputs.State.Structures[1].IsTouchable = false;
  EXPECT_EQ(KeysOf(inputs).count({Step::Segmentation, 9}), 0U) << "nothing yields";
}

TEST(StudyPlan, ProtectsForbiddenStructuresWhateverIsShown)
{
  for (int bits = 0; bits < 4; ++bits)
  {
    Inputs inputs = Base();
    inputs.State.Structures.back().IsVisible = (bits & 1) != 0;
    inputs.State.Structures.back().IsTouchable = (bits & 2) != 0;
    EXPECT_EQ(KeysOf(inputs).count({Step::Protection, Nerve}), 1U) << bits;
  }
}

// Names of labels and detached data are read together with their main file.
TEST(SceneStamps, StampsCompanionFiles)
{
  const test::TemporaryFolder folder;
  const std::vector<std::pair<const char*, const char*>> cases{{"aal.nii.gz", "aal.nii.txt"},
                                                               {"aal.nii.gz", "aal.nii.lut"},
                                                               {"mask.mhd", "mask.raw"},
                                                               {"mask.mhd", "mask.zraw"},
                                                               {"mask.nhdr", "mask.raw.gz"}};
  for (const auto& [file, companion] : cases)
  {
    StudyState state;
    state.SegmentationFile = folder / file;
    state.VolumeFile = folder / file;
    test::WriteAll(folder / file, "header");
    const SceneStamps before = StampFiles(state);
    test::WriteAll(folder / companion, "data");
    const SceneStamps after = StampFiles(state);
    EXPECT_NE(after, before) << companion;
    std::filesystem::remove(folder / companion);
  }
}
} // namespace
} // namespace palpate::study_plan_test
