#include "ShapePriorFile.h"

#include "JsonText.h"
#include "MessageOf.h"
#include "TemporaryFolder.h"
#include "WholeFile.h"

#include <gtest/gtest.h>

#include <functional>

namespace palpate::shape_prior_file_test
{
namespace
{
using test::TemporaryFolder;
using Json = nlohmann::json;

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
    return test::MessageOf([this] { ReadShapePrior(this->File); });
  }

  TemporaryFolder Folder;
  std::filesystem::path File = this->Folder / "prior.json";
};

TEST_F(ShapePriorFile, ReturnsInSinglePrecision)
{
  const ShapePrior prior = ShapePrior::Smooth(21.0);
  WriteShapePrior(prior, this->File);
  const ShapePrior read = ReadShapePrior(this->File);
  EXPECT_EQ(read.Degree(), 12);
  EXPECT_EQ(read.Cases(), 0U);
  EXPECT_LT((read.Mean() - prior.Mean()).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT((read.Covariance() - prior.Covariance()).cwiseAbs().maxCoeff(), 1e-6);
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
