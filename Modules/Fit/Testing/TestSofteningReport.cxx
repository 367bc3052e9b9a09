#include "ElasticCases.h"
#include "MarkupCheck.h"
#include "SofteningReport.h"

#include <gtest/gtest.h>

namespace palpate::softening_report_test
{
namespace
{
struct Softened
{
  SofteningReport Report(const std::string& name, double ball) const
  {
    return SofteningReport(this->Model, this->Softness, name, ball);
  }
  ModelDocument Model{RadialModel(0, {1.0}, Vector3::Zero()), {}};
  ModelSoftness Softness;
};

// A ball of 25 mm with a hard lesion beneath its posterior side.
Softened Soften(double largestPatch)
{
  test::ElasticCase organ;
  organ.Model = test::SphereModel();
  organ.Solid.Tissue.AddInclusion(
      test::BallFraction(organ.Model.PointWorld(Vector3::UnitY()) - 8.0 * Vector3::UnitY(), 6.0),
      0.2);
  organ.Build(8, 8);
  ComplianceMaps maps;
  const Status status =
      ComplianceMaps::Fit(organ.Model, organ.Solid, organ.Reduced, {16, largestPatch}, {}, maps);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  Softened made;
  made.Softness.Elasticity = std::make_shared<const ComplianceMaps>(maps);
  made.Softness.Tissue = "20 kPa";
  made.Softness.Notes = {"a <note>"};
  made.Model = {organ.Model, {}, made.Softness.Elasticity};
  made.Model.Provenance.Settings = {{"tissue_kpa", "20"}};
  return made;
}

const Softened& TheOrgan()
{
  static const Softened softened = Soften(0.0);
  return softened;
}

TEST(SofteningReport, SentenceSaysWhatTheBallFeels)
{
  const std::string sentence = TheOrgan().Report("soft.json", 8.0).Sentence();
  EXPECT_EQ(sentence.rfind("A ball of 8 mm, 2.0 mm deep, feels 0.", 0), 0U) << sentence;
  EXPECT_NE(sentence.find("Tissue: 20 kPa."), std::string::npos) << sentence;
  EXPECT_EQ(sentence.find("harder than that is 0 %"), std::string::npos) << sentence;
}

TEST(SofteningReport, SaysThatABallIsTooLarge)
{
  const Softened narrow = Soften(1.0); // mm, no patch may grow larger
  const std::string sentence = narrow.Report("soft.json", 8.0).Sentence();
  EXPECT_NE(sentence.find("too large for this organ"), std::string::npos) << sentence;
}

TEST(SofteningReport, PageIsWholeAndEscaped)
{
  const std::string page = TheOrgan().Report("<soft>.json", 8.0).Page();
  EXPECT_EQ(test::MarkupError(page.substr(page.find("<html"))), "");
  EXPECT_EQ(page.find("<soft>"), std::string::npos);
  EXPECT_EQ(page.find("<note>"), std::string::npos);
  EXPECT_NE(page.find("tissue_kpa"), std::string::npos);
  EXPECT_NE(page.find("noticeable steps"), std::string::npos);
  std::size_t views = 0;
  for (std::size_t at = page.find("<image "); at != std::string::npos;
       at = page.find("<image ", at + 1))
  {
    ++views;
  }
  EXPECT_EQ(views, 6U);
}
} // namespace
} // namespace palpate::softening_report_test
