#include "ReportIndex.h"

#include "MarkupCheck.h"
#include "SyntheticFit.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

namespace palpate::report_index_test
{
namespace
{
std::string Page(const palpate::ReportIndex& index)
{
  const palpate::test::TemporaryFolder folder;
  index.Write(folder / "index.html");
  return palpate::test::ReadAll(folder / "index.html");
}

TEST(ReportIndex, LinksEveryCaseAndCountsFitted)
{
  const palpate::test::SyntheticFit fit;
  FitResult refused = fit.Result;
  refused.State = FitResult::Outcome::Refused;
  refused.Structure.Name = "<Zone> & \"more\"";
  refused.Message = "is not star-shaped: <why>";
  palpate::ReportIndex index;
  index.Add(fit.Result, DegreeOf(fit.Result.Model), "case 1%/report.html");
  index.Add(refused, 0, "case_2/report.html");
  index.Add(refused, 0, "");
  const std::string html = Page(index);
  EXPECT_EQ(palpate::test::MarkupError(html), "");
  EXPECT_NE(html.find("3 cases, 1 fitted"), std::string::npos);
  EXPECT_NE(html.find("href=\"case%201%25/report.html\""), std::string::npos);
  EXPECT_NE(html.find("href=\"case_2/report.html\""), std::string::npos);
  EXPECT_NE(html.find("0.9873"), std::string::npos);
  EXPECT_NE(html.find("is not star-shaped: &lt;why&gt;"), std::string::npos);
  EXPECT_EQ(html.find("secret-folder"), std::string::npos);
  EXPECT_EQ(html.find("http"), std::string::npos);
}

TEST(ReportIndex, FileWithoutStructuresShowsReason)
{
  FitResult unread;
  unread.Input = "folder/bad.nii.gz";
  unread.State = FitResult::Outcome::BadInput;
  unread.Message = "folder/bad.nii.gz is empty; copy or export it again.";
  palpate::ReportIndex index;
  index.Add(unread, 0, "");
  const std::string html = Page(index);
  EXPECT_EQ(palpate::test::MarkupError(html), "");
  EXPECT_NE(html.find("1 cases, 0 fitted"), std::string::npos);
  EXPECT_NE(html.find("bad.nii.gz is empty; copy"), std::string::npos);
  EXPECT_EQ(html.find("Label 0"), std::string::npos);
}

TEST(ReportIndex, NoCasesGiveValidPage)
{
  EXPECT_EQ(palpate::test::MarkupError(Page(palpate::ReportIndex())), "");
}
} // namespace
} // namespace palpate::report_index_test
