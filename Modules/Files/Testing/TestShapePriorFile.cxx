#include "ShapePriorFile.h"

#include "JsonText.h"
#include "MessageOf.h"
#include "TemporaryFolder.h"
#include "WholeFile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace palpate::shape_prior_file_test
{
namespace
{
using test::TemporaryFolder;
using Json = nlohmann::json;

ShapePrior ReadRadialPrior(const std::filesystem::path& file)
{
  return *std::get<std::shared_ptr<const ShapePrior>>(ReadOrganPrior(file));
}

// A file of the smooth prior, changed.
class ShapePriorFile : public testing::Test
{
protected:
  void Write(const std::function<void(Json&)>& change) const
  {
    WriteShapePrior(ShapePrior::Smooth(21.0), this->File);
    Json json = ReadJson(this->File, 1U << 24U, "");
    change(json);
    WriteWholeFile(this->File, json.dump());
  }
  std::string Refusal(const std::function<void(Json&)>& change) const
  {
    this->Write(change);
    return test::MessageOf([this] { ReadOrganPrior(this->File); });
  }

  TemporaryFolder Folder;
  std::filesystem::path File = this->Folder / "prior.json";
};

TEST_F(ShapePriorFile, ReturnsInSinglePrecision)
{
  const ShapePrior prior = ShapePrior::Smooth(21.0);
  WriteShapePrior(prior, this->File);
  const ShapePrior read = ReadRadialPrior(this->File);
  EXPECT_EQ(read.Degree(), 12);
  EXPECT_EQ(read.Cases(), 0U);
  EXPECT_LT((read.Mean() - prior.Mean()).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT((read.Covariance() - prior.Covariance()).cwiseAbs().maxCoeff(), 1e-6);
}

TEST_F(ShapePriorFile, OfOldProgramsHasNoKindAndIsRadial)
{
  this->Write([](Json& json) { json.erase("kind"); });
  EXPECT_EQ(ReadRadialPrior(this->File).Degree(), 12);
  const OrganPrior read = ReadOrganPrior(this->File);
  EXPECT_TRUE(std::holds_alternative<std::shared_ptr<const ShapePrior>>(read));
}

// A prior of surface models, which are spheres and ellipsoids in others.
SurfacePrior SphericalPrior()
{
  std::vector<SurfacePrior::Case> cases;
  for (int n = 0; n < 6; ++n)
  {
    const double radius = (8.0 + n) / ShapePrior::ConstantHarmonic;
    const RadialModel body(2, {radius, 0, 0, 0, 0, 0, 0.5 * (n % 2), 0, 0.3 * n}, Vector3::Zero());
    LogSurface known{Eigen::VectorXd::Zero(169), Vector3(0.0, 0.1 * n, 0.0)};
    known.Coefficients[0] = std::log(20.0 + n) / ShapePrior::ConstantHarmonic;
    cases.push_back({SurfaceModel::FromModel(body), Vector3(0.0, 3.0, 0.2 * n), known});
  }
  SurfacePrior prior;
  EXPECT_TRUE(SurfacePrior::OfGroup(cases, prior).IsOk());
  prior.Relation->Name = "gland";
  return prior;
}

class SurfacePriorFile : public ShapePriorFile
{
protected:
  SurfacePrior Read() const
  {
    return *std::get<std::shared_ptr<const SurfacePrior>>(ReadOrganPrior(this->File));
  }
  std::string RefusalOf(const std::function<void(Json&)>& change) const
  {
    WriteShapePrior(SphericalPrior(), this->File);
    Json json = ReadJson(this->File, 1U << 24U, "");
    change(json);
    WriteWholeFile(this->File, json.dump());
    return test::MessageOf([this] { ReadOrganPrior(this->File); });
  }
};

TEST_F(SurfacePriorFile, ReturnsInSinglePrecision)
{
  const SurfacePrior prior = SphericalPrior();
  WriteShapePrior(prior, this->File);
  const SurfacePrior read = this->Read();
  EXPECT_EQ(read.Degree, 3);
  EXPECT_EQ(read.Cases(), 6U);
  EXPECT_LT((read.Mean - prior.Mean).cwiseAbs().maxCoeff(), 1e-5);
  EXPECT_LT((read.Modes - prior.Modes).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT((read.Variances - prior.Variances).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_LT((read.Rest - prior.Rest).cwiseAbs().maxCoeff(), 1e-5);
  ASSERT_TRUE(read.Relation.has_value());
  EXPECT_LT((read.Relation->Gain - prior.Relation->Gain).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_LT((read.Relation->Covariance - prior.Relation->Covariance).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_LT((read.Relation->WallCovariance - prior.Relation->WallCovariance).cwiseAbs().maxCoeff(),
            1e-5);
  EXPECT_LT((read.Relation->Offset - prior.Relation->Offset).norm(), 1e-6);
  EXPECT_EQ(read.Relation->Name, "gland");
}

TEST_F(SurfacePriorFile, WithoutARelationHasNone)
{
  SurfacePrior prior = SphericalPrior();
  prior.Relation.reset();
  WriteShapePrior(prior, this->File);
  EXPECT_FALSE(this->Read().Relation.has_value());
}

TEST_F(SurfacePriorFile, RefusesWhatIsNone)
{
  EXPECT_EQ(this->RefusalOf([](Json&) {}), "no error");
  const auto says = [this](const char* part, const std::function<void(Json&)>& change)
  {
    const std::string message = this->RefusalOf(change);
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  says("another kind", [](Json& json) { json["kind"] = "volume"; });
  says("another kind", [](Json& json) { json["kind"] = 3; });
  says("not of its degree", [](Json& json) { json["kind"] = "radial"; });
  says("not of its degree", [](Json& json) { json["degree"] = 2.5; });
  says("not of its degree", [](Json& json) { json["degree"] = 1e9; });
  says("no degree", [](Json& json) { json["degree"] = 4; });
  says("number of cases", [](Json& json) { json["cases"] = 1e9; });
  says("not of its degree", [](Json& json) { json["modes"].erase(0); });
  says("not of its degree", [](Json& json) { json["mean"] = Json::array(); });
  says("not orthonormal", [](Json& json) { json["modes"][0] = 40.0; });
  says("variances", [](Json& json) { json["variances"][0] = -1.0; });
  says("variances", [](Json& json) { json["rest"][1] = 0.0; });
  says("mean surface", [](Json& json) { json["mean"][3] = 1e8; });
  says("not a number", [](Json& json) { json["mean"][3] = "7"; });
  says("relation", [](Json& json) { json["relation"] = 4; });
  says("no list \"gain\"", [](Json& json) { json["relation"].erase("gain"); });
  says("not of its degree", [](Json& json) { json["relation"]["covariance"].erase(0); });
  says("not of its degree", [](Json& json) { json["relation"]["wall_covariance"].erase(0); });
  says("not of its degree", [](Json& json) { json["relation"]["offset"].erase(0); });
  says("other sizes", [](Json& json) { json["relation"]["mean"].erase(0); });
  says("positive definite", [](Json& json) { json["relation"]["covariance"][0] = -1.0; });
  says("numbers that are none", [](Json& json) { json["relation"]["deviations"][0] = 0.0; });
}

TEST_F(ShapePriorFile, RefusesWhatIsNone)
{
  EXPECT_NE(this->Refusal([](Json& json) { json = 3; }).find("is not a prior"), std::string::npos);
  EXPECT_NE(this->Refusal([](Json& json) { json["format"] = "palpate check group"; })
                .find("palpate cohort --prior"),
            std::string::npos);
  EXPECT_NE(this->Refusal([](Json& json) { json["version"] = 2; }).find("another version"),
            std::string::npos);
  EXPECT_NE(this->Refusal([](Json& json) { json.erase("mean"); }).find("no list \"mean\""),
            std::string::npos);
  EXPECT_NE(this->Refusal([](Json& json) { json["mean"][4] = "7"; }).find("not a number"),
            std::string::npos);
  EXPECT_NE(this->Refusal([](Json& json) { json["degree"] = 11; }).find("not of its degree"),
            std::string::npos);
  EXPECT_NE(this->Refusal([](Json& json) { json["degree"] = 1e9; }).find("not of its degree"),
            std::string::npos);
  EXPECT_NE(
      this->Refusal([](Json& json) { json["covariance"].erase(0); }).find("not of its degree"),
      std::string::npos);
  EXPECT_NE(
      this->Refusal([](Json& json) { json["covariance"][0] = -1.0; }).find("not positive definite"),
      std::string::npos);
  EXPECT_NE(this->Refusal([](Json& json) { json["mean"][0] = 1000.0; }).find("mean radius"),
            std::string::npos);
  EXPECT_NE(this->Refusal([](Json& json) { json["cases"] = -1; }).find("number of cases"),
            std::string::npos);
}
} // namespace
} // namespace palpate::shape_prior_file_test
