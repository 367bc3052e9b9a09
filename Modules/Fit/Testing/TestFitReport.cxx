#include "FitReport.h"

#include "InputError.h"
#include "MarkupCheck.h"
#include "SyntheticFit.h"
#include "TemporaryFolder.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::fit_report_test
{
namespace
{
using palpate::test::SyntheticFit;

std::string Report(const FitResult& result, const palpate::Volume* volume)
{
  const palpate::test::TemporaryFolder folder;
  palpate::WriteFitReport(result, volume, folder / "report.html");
  return palpate::test::ReadAll(folder / "report.html");
}

int Count(const std::string& text, const std::string& part)
{
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
  {
    ++count;
  }
  return count;
}

TEST(FitReport, IsWellFormedAndLoadsNothing)
{
  const SyntheticFit fit;
  const std::string html = Report(fit.Result, &fit.Mri);
  EXPECT_EQ(palpate::test::MarkupError(html), "");
  EXPECT_EQ(Count(html, "http:"), 0);
  EXPECT_EQ(Count(html, "https:"), 0);
  EXPECT_EQ(Count(html, "href="), Count(html, "href=\"data:image/png;base64,"));
  EXPECT_EQ(Count(html, "src="), 0);
  EXPECT_EQ(Count(html, "@import"), 0);
}

TEST(FitReport, ShowsSlicesContoursViewsAndCharts)
{
  const SyntheticFit fit;
  const std::string html = Report(fit.Result, &fit.Mri);
  EXPECT_EQ(Count(html, "<svg class=\"slice\""), 6);
  EXPECT_EQ(Count(html, "<svg class=\"view\""), 6);
  EXPECT_EQ(Count(html, "<svg class=\"chart\""), 3);
  EXPECT_EQ(Count(html, "<path class=\"mask\""), 6);
  EXPECT_EQ(Count(html, "<path class=\"surface\""), 6);
  EXPECT_EQ(Count(html, "<path class=\"model\""), 6);
  EXPECT_EQ(Count(html, "<svg class=\"colorbar\""), 1);
}

TEST(FitReport, ContainsNumbersOfResult)
{
  const SyntheticFit fit;
  const std::string html = Report(fit.Result, nullptr);
  for (const char* number :
       {"0.9873", "0.281 mm", "0.352 mm", "0.713 mm", "1.577 mm", "0.171 mm", "43.217", "43.301 ml",
        "0.37 %", "1.733", "0.219 mm", "6021.5", "5987.2", "0.138 s", "0.111 mm", "36.0"})
  {
    EXPECT_GT(Count(html, number), 0) << number;
  }
  for (const char* setting : {"frequency", "smoothing", "degree", "Eigen", "ITK", "VTK", "Palpate"})
  {
    EXPECT_GT(Count(html, setting), 0) << setting;
  }
}

TEST(FitReport, ShowsRegionsWithoutDirections)
{
  SyntheticFit fit;
  const std::string covered = Report(fit.Result, nullptr);
  EXPECT_NE(covered.find("<dt>Coverage</dt><dd>good"), std::string::npos);
  EXPECT_EQ(covered.find("Grey: no direction"), std::string::npos);
  fit.Result.Coverage.Outcome = palpate::DirectionCoverage::Verdict::Gaps;
  fit.Result.Coverage.LargestGap = {palpate::Vector3::UnitX(), 1.0};
  const std::string gaps = Report(fit.Result, nullptr);
  EXPECT_NE(gaps.find("<dt>Coverage</dt><dd>gaps"), std::string::npos);
  EXPECT_NE(gaps.find("Grey: no direction"), std::string::npos);
  // The views from that side are different images.
  const auto views = [](const std::string& html)
  {
    return html.substr(html.find("From six sides"), html.find("By degree") - html.find("From six"));
  };
  EXPECT_NE(views(covered).substr(views(covered).find("data:")),
            views(gaps).substr(views(gaps).find("data:")));
}

TEST(FitReport, EscapesMarkupInNames)
{
  SyntheticFit fit;
  fit.Result.Structure.Name = "</h1><script>alert(\"1\")</script>&'\xFF";
  fit.Result.Notes = {"<img src=x onerror=alert(1)>"};
  fit.Result.Message = "<b>bold</b>";
  fit.Result.Seconds.emplace_back("<i>", 1.0);
  fit.Mri.Source = "<volume>.nii";
  fit.Mri.Notes = {"<u>"};
  const std::string html = Report(fit.Result, &fit.Mri);
  EXPECT_EQ(palpate::test::MarkupError(html), "");
  for (const char* tag : {"<script", "<img", "<b>", "<volume", "<u>", "<i>"})
  {
    EXPECT_EQ(Count(html, tag), 0) << tag;
  }
  EXPECT_GT(Count(html, "&lt;script&gt;"), 0);
}

TEST(FitReport, DoesNotRevealInputFolders)
{
  SyntheticFit fit;
  fit.Result.State = FitResult::Outcome::BadInput;
  fit.Result.Message = fit.Result.Input.string() + ": is broken; " + fit.Result.Input.string();
  fit.Result.Notes = {fit.Result.Input.string() + " was touched",
                      "names are from (/home/someone/secret-folder/names.txt)"};
  fit.Mri.Notes.push_back(fit.Mri.Source.string() + ": an axis was reversed");
  const std::string html = Report(fit.Result, &fit.Mri);
  EXPECT_EQ(Count(html, "secret-folder"), 0);
  EXPECT_GT(Count(html, "case_17.nii.gz: is broken"), 0);
  EXPECT_GT(Count(html, "t2.nii.gz"), 0);
}

TEST(FitReport, RefusedStructureShowsReasonMaskAndSurface)
{
  SyntheticFit fit;
  fit.Result.State = FitResult::Outcome::Refused;
  fit.Result.Message = "is not star-shaped: the centre does not see 41.0 % of its surface";
  fit.Result.ModelSurface = nullptr;
  fit.Result.RmsByDegree.clear();
  const std::string html = Report(fit.Result, &fit.Mri);
  EXPECT_EQ(palpate::test::MarkupError(html), "");
  EXPECT_GT(Count(html, "Prostate is not star-shaped"), 0);
  EXPECT_EQ(Count(html, "<path class=\"mask\""), 6);
  EXPECT_EQ(Count(html, "<path class=\"surface\""), 6);
  EXPECT_EQ(Count(html, "class=\"model\""), 0);
  EXPECT_EQ(Count(html, "<svg class=\"view\""), 6);
  EXPECT_EQ(Count(html, "<svg class=\"chart\""), 0);
  EXPECT_EQ(Count(html, "Dice"), 0);
}

TEST(FitReport, UnreadInputGetsReport)
{
  FitResult nothing;
  nothing.Input = "missing.nii.gz";
  nothing.State = FitResult::Outcome::BadInput;
  nothing.Message = "missing.nii.gz: there is no such file; check the path";
  const std::string html = Report(nothing, nullptr);
  EXPECT_EQ(palpate::test::MarkupError(html), "");
  EXPECT_GT(Count(html, "there is no such file"), 0);
  EXPECT_EQ(Count(html, "<svg"), 0);
}

TEST(FitReport, HandlesNonFiniteNumbers)
{
  SyntheticFit fit;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  fit.Result.Dice = nan;
  fit.Result.ModelToMask.Mean = std::numeric_limits<double>::infinity();
  fit.Result.RmsByDegree[2] = nan;
  fit.Result.ModelSurface->GetPointData()->GetArray("DistanceToSurface")->SetComponent(7, 0, nan);
  fit.Mri.Image->SetScalarComponentFromFloat(48, 48, 10, 0,
                                             std::numeric_limits<float>::quiet_NaN());
  const std::string html = Report(fit.Result, &fit.Mri);
  EXPECT_EQ(palpate::test::MarkupError(html), "");
  EXPECT_EQ(Count(html, ">nan"), 0);
  EXPECT_EQ(Count(html, "inf "), 0);
}

TEST(FitReport, IsReproducible)
{
  const SyntheticFit fit;
  EXPECT_EQ(Report(fit.Result, &fit.Mri), Report(fit.Result, &fit.Mri));
}

TEST(FitReport, MissingFolderIsInputError)
{
  const SyntheticFit fit;
  EXPECT_THROW(palpate::WriteFitReport(fit.Result, nullptr, "/no/such/folder/report.html"),
               palpate::InputError);
}
} // namespace
} // namespace palpate::fit_report_test
