#include "ElasticCases.h"
#include "MarkupCheck.h"
#include "SofteningReport.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
// A ball of 25 mm with a hard lesion beneath its posterior side.
SoftenedModel Soften(double largestPatch)
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
  SoftenedModel made;
  made.Document = {organ.Model, {}, std::make_shared<const ComplianceMaps>(maps)};
  made.Document.Provenance.Settings = {{"tissue_kpa", "20"}};
  made.Notes = {"a <note>"};
  return made;
}

const SoftenedModel& Softened()
{
  static const SoftenedModel softened = Soften(0.0);
  return softened;
}

TEST(SofteningReport, SentenceSaysWhatTheBallFeels)
{
  const std::string sentence = SofteningReport(Softened(), "soft.json", 8.0).Sentence();
  EXPECT_EQ(sentence.rfind("A ball of 8 mm, 2.0 mm deep, feels 0.", 0), 0U) << sentence;
  EXPECT_EQ(sentence.find("harder than that is 0 %"), std::string::npos) << sentence;
}

TEST(SofteningReport, SaysThatABallIsTooLarge)
{
  const SoftenedModel narrow = Soften(1.0); // mm, no patch may grow larger
  const std::string sentence = SofteningReport(narrow, "soft.json", 8.0).Sentence();
  EXPECT_NE(sentence.find("too large for this organ"), std::string::npos) << sentence;
}

TEST(SofteningReport, PageIsWholeAndEscaped)
{
  const std::string page = SofteningReport(Softened(), "<soft>.json", 8.0).Page();
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
} // namespace palpate
