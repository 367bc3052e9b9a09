#include "ComplianceMaps.h"
#include "InputError.h"
#include "ModelJson.h"
#include "RandomModels.h"

#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace palpate::model_json_test
{
namespace
{
using namespace palpate::test;
using Json = nlohmann::ordered_json;

Json SmallFile()
{
  std::mt19937_64 random(1);
  return Json::parse(
      ModelToJson({RandomModel(random, 2), {"palpate 0", "a.nii", "1", "", {}}}, "f"));
}

std::string RefusalOf(const std::string& text)
{
  try
  {
    ModelFromJson(text, "folder/name.json");
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "accepted";
}

void ExpectRefusal(const Json& file, const std::string& fact)
{
  const std::string message = RefusalOf(file.dump());
  EXPECT_NE(message.find("folder/name.json"), std::string::npos) << message;
  EXPECT_NE(message.find(fact), std::string::npos) << message;
  EXPECT_NE(message.find(';'), std::string::npos) << "no way out: " << message;
}

TEST(ModelJson, RoundTripsRadialModelBitForBit)
{
  std::mt19937_64 random(2);
  for (const int degree : {0, 1, 5, 12, 40})
  {
    const std::vector<double> values =
        RandomBits(random, SphericalHarmonicBasis::CoefficientCount(degree));
    const std::vector<double> center = RandomBits(random, 3);
    const RadialModel model(degree, values, {center[0], center[1], center[2]});
    const ModelDocument back = ModelFromJson(ModelToJson({model, {}}, "f"), "f");
    const auto& read = std::get<RadialModel>(back.Surface);
    EXPECT_EQ(read.Degree(), degree);
    EXPECT_TRUE(SameBits(read.Coefficients(), values)) << "degree " << degree;
    EXPECT_TRUE(SameBits(read.CenterWorld(), model.CenterWorld())) << "degree " << degree;
  }
}

TEST(ModelJson, RoundTripsSignedZeroAndSubnormals)
{
  const double smallest = std::numeric_limits<double>::denorm_min();
  const std::vector<double> values{-0.0, 0.0, smallest, -smallest};
  const ModelDocument back =
      ModelFromJson(ModelToJson({RadialModel(1, values, {-0.0, smallest, 0.0}), {}}, "f"), "f");
  EXPECT_TRUE(SameBits(std::get<RadialModel>(back.Surface).Coefficients(), values));
}

TEST(ModelJson, RoundTripsSurfaceModelBitForBit)
{
  std::mt19937_64 random(3);
  const SurfaceModel surface = RandomSurfaceModel(random, 7);
  const ModelDocument back = ModelFromJson(ModelToJson({surface, {}}, "f"), "f");
  const auto& read = std::get<SurfaceModel>(back.Surface);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_TRUE(SameBits(read.Coefficients(k), surface.Coefficients(k)));
  }
}

TEST(ModelJson, RoundTripsProvenance)
{
  std::mt19937_64 random(4);
  const ModelProvenance provenance{
      "palpate 9.8", "mask \"a\"\n.nii.gz", "Prostata Süd", "2024-01-02", {{"degree", "12"}}};
  const ModelProvenance back =
      ModelFromJson(ModelToJson({RandomModel(random, 1), provenance}, "f"), "f").Provenance;
  EXPECT_EQ(back.Program, provenance.Program);
  EXPECT_EQ(back.Input, provenance.Input);
  EXPECT_EQ(back.Label, provenance.Label);
  EXPECT_EQ(back.Date, provenance.Date);
  EXPECT_EQ(back.Settings, provenance.Settings);
}

TEST(ModelJson, StatesItsConvention)
{
  const Json file = SmallFile();
  EXPECT_EQ(file["format"], "palpate spherical-harmonic model");
  EXPECT_EQ(file["version"], 2);
  EXPECT_EQ(file["basis"]["normalization"], "orthonormal over the unit sphere");
  EXPECT_EQ(file["basis"]["phase"], "no Condon-Shortley phase");
  EXPECT_EQ(file["basis"]["polar_axis"], "+z");
  EXPECT_EQ(file["basis"]["order"], "l(l+1)+m");
  EXPECT_EQ(file["frame"], "patient LPS");
  EXPECT_EQ(file["unit"], "mm");
  EXPECT_EQ(file["degree"], 2);
}

TEST(ModelJson, SameModelGivesSameText)
{
  std::mt19937_64 random(5);
  const ModelDocument document{RandomModel(random, 6), {"p", "i", "1", "", {{"a", "b"}}}};
  EXPECT_EQ(ModelToJson(document, "f"), ModelToJson(document, "g"));
}

TEST(ModelJson, WritesDateOnlyIfGiven)
{
  EXPECT_FALSE(SmallFile()["provenance"].contains("date"));
}

TEST(ModelJson, RejectsOtherConvention)
{
  for (const char* key : {"kind", "normalization", "phase", "polar_axis", "order", "signs"})
  {
    Json file = SmallFile();
    file["basis"][key] = "Schmidt semi-normalised";
    ExpectRefusal(file, key);
    file["basis"].erase(key);
    ExpectRefusal(file, key);
  }
  for (const char* key : {"frame", "unit", "format", "model"})
  {
    Json file = SmallFile();
    file[key] = "RAS";
    ExpectRefusal(file, key);
  }
}

TEST(ModelJson, ReadsTheFirstVersionsNames)
{
  std::mt19937_64 random(8);
  const std::pair<OrganModel, const char*> models[] = {
      {RandomModel(random, 3), "star-shaped"}, {RandomSurfaceModel(random, 3), "parametric"}};
  for (const auto& [model, name] : models)
  {
    const Json today = Json::parse(ModelToJson({model, {}}, "f"));
    Json file = today;
    file["version"] = 1;
    file["surface"] = name;
    file.erase("model");
    const ModelDocument back = ModelFromJson(file.dump(), "f");
    EXPECT_EQ(Json::parse(ModelToJson(back, "f")), today);
    file["surface"] = "radial";
    ExpectRefusal(file, "model");
    file["surface"] = name;
    file["version"] = 2;
    ExpectRefusal(file, "model");
  }
}

TEST(ModelJson, RejectsOtherVersion)
{
  for (const Json& version : {Json(3), Json(0), Json("1"), Json(nullptr), Json(1.5)})
  {
    Json file = SmallFile();
    file["version"] = version;
    ExpectRefusal(file, "version");
  }
}

TEST(ModelJson, RejectsWrongCountsAndTypes)
{
  const std::vector<std::pair<const char*, Json>> changes{
      {"degree", Json(3)},
      {"degree", Json(-1)},
      {"degree", Json(1000000000)},
      {"degree", Json(2.0)},
      {"degree", Json("2")},
      {"center_mm", Json::array({1, 2})},
      {"center_mm", Json("0 0 0")},
      {"center_mm", Json::array({1, 2, nullptr})},
      {"coefficients_mm", Json::array()},
      {"coefficients_mm", Json::array({1, 2, 3, 4, 5, 6, 7, 8, "9"})},
      {"coefficients_mm", Json::object()},
      {"basis", Json(3)},
      {"model", Json(3)}};
  for (const auto& [key, value] : changes)
  {
    Json file = SmallFile();
    file[key] = value;
    ExpectRefusal(file, "");
  }
}

TEST(ModelJson, RejectsNumberOutOfRange)
{
  std::string text = SmallFile().dump();
  text.replace(text.find("\"center_mm\":[") + 13, 0, "1e999,");
  EXPECT_NE(RefusalOf(text), "accepted");
}

TEST(ModelJson, DoesNotWriteNonFiniteNumbers)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(ModelToJson({RadialModel(0, {nan}, Vector3::Zero()), {}}, "f"), InputError);
  EXPECT_THROW(ModelToJson({RadialModel(0, {1.0}, {0.0, infinity, 0.0}), {}}, "f"), InputError);
}

TEST(ModelJson, RejectsEveryTruncation)
{
  const std::string text = SmallFile().dump();
  for (std::size_t length = 0; length < text.size(); ++length)
  {
    ASSERT_NE(RefusalOf(text.substr(0, length)), "accepted") << length << " bytes";
  }
}

// c = 25 mm^2/N / a, a little less to one side.
ComplianceMaps SomeMaps()
{
  ComplianceMaps maps;
  maps.Degree = 2;
  maps.LargestPatch = 7.3;
  maps.PoissonRatio = 0.49;
  for (std::vector<double>& map : maps.Coefficients)
  {
    map.assign(9, 0.0);
    map[3] = 0.1 / 3.0;
  }
  maps.Coefficients[0][0] = 100.0 / 3.0;
  maps.FitError = {0.01, 0.05, Vector3(0.6, 0.0, -0.8), 2.5};
  return maps;
}

Json ElasticFile()
{
  std::mt19937_64 random(1);
  ModelDocument document{RandomModel(random, 2), {}};
  document.Elasticity = std::make_shared<const ComplianceMaps>(SomeMaps());
  return Json::parse(ModelToJson(document, "f"));
}

TEST(ModelJson, RoundTripsElasticityBitForBit)
{
  const ModelDocument back = ModelFromJson(ElasticFile().dump(), "f");
  ASSERT_NE(back.Elasticity, nullptr);
  const ComplianceMaps maps = SomeMaps();
  EXPECT_EQ(back.Elasticity->Degree, maps.Degree);
  EXPECT_EQ(back.Elasticity->LargestPatch, maps.LargestPatch);
  EXPECT_EQ(back.Elasticity->PoissonRatio, maps.PoissonRatio);
  for (std::size_t map = 0; map < ComplianceMaps::Count; ++map)
  {
    EXPECT_TRUE(SameBits(back.Elasticity->Coefficients[map], maps.Coefficients[map])) << map;
  }
  EXPECT_EQ(back.Elasticity->FitError.Rms, maps.FitError.Rms);
  EXPECT_EQ(back.Elasticity->FitError.Largest, maps.FitError.Largest);
  EXPECT_EQ(back.Elasticity->FitError.Worst, maps.FitError.Worst);
}

TEST(ModelJson, RefusesElasticityThatIsIncomplete)
{
  for (const char* key : {"degree", "largest_patch_mm", "poisson_ratio", "compliance_mm2_per_n",
                          "mean_curvature_per_mm", "fit_error"})
  {
    Json file = ElasticFile();
    file["elasticity"].erase(key);
    ExpectRefusal(file, key);
    for (const Json& wrong : {Json("many"), Json(-1), Json(true), Json::array({1, "x"})})
    {
      file["elasticity"][key] = wrong;
      EXPECT_NE(RefusalOf(file.dump()), "accepted") << key << " " << wrong;
    }
  }
  Json file = ElasticFile();
  file["elasticity"]["compliance_mm2_per_n"][2].erase(0);
  ExpectRefusal(file, "compliance_mm2_per_n");
}

TEST(ModelJson, RefusesElasticityThatIsNoBody)
{
  Json file = ElasticFile();
  file["elasticity"]["compliance_mm2_per_n"][0][0] = -30.0;
  const std::string message = RefusalOf(file.dump());
  EXPECT_NE(message.find("elastic body"), std::string::npos) << message;
}
} // namespace
} // namespace palpate::model_json_test
