#include "ComparisonTable.h"

#include "ComparedCases.h"
#include "ComparisonOverview.h"
#include "CsvText.h"
#include "TemporaryFolder.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::comparison_table_test
{
namespace
{
using namespace palpate::test;

const std::vector<double> Tolerances{0.5, 2.0};

// A sphere of a radius against one of 20 mm.
PairComparison SpherePair(const std::string& name, double radius)
{
  PairComparison pair;
  pair.Case = name;
  const ComparedBody one = BodyOfModel(SphereModel(radius));
  const ComparedBody other = BodyOfModel(SphereModel(20.0));
  EXPECT_TRUE(CompareBodies(one, other, Tolerances, {}, pair.Numbers).IsOk());
  pair.One.Milliliters = one.Volume() / 1000.0;
  pair.Other.Milliliters = other.Volume() / 1000.0;
  return pair;
}

PairComparison Lost(const std::string& name)
{
  PairComparison pair;
  pair.Case = name;
  pair.State = FitResult::Outcome::BadInput;
  pair.Message = "no voxel is labelled";
  return pair;
}

TEST(ComparisonTable, HasARowPerPairWithUnitsInTheHead)
{
  const TemporaryFolder folder;
  const PairComparison pair = SpherePair("a", 21.0);
  WriteComparisonTable({pair, Lost("=b")}, Tolerances, folder / "t.csv");
  std::vector<CsvRecord> rows;
  const std::string text = ReadAll(folder / "t.csv");
  ForEachCsvRecord(text, [&](const CsvRecord& row) { rows.push_back(row); });
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(*rows[0].Find("status"), "compared");
  EXPECT_NEAR(std::stod(*rows[0].Find("dice")), pair.Numbers.Overlap->Dice(), 1e-7);
  EXPECT_EQ(*rows[0].Find("mean_mm"), "1");
  EXPECT_EQ(*rows[0].Find("signed_mean_mm"), "1");
  EXPECT_EQ(*rows[0].Find("surface_dice_0.5mm"), "0");
  EXPECT_EQ(*rows[0].Find("surface_dice_2mm"), "1");
  EXPECT_EQ(*rows[0].Find("bias_inferior_mm"), "1");
  EXPECT_EQ(*rows[1].Find("case"), "=b");
  EXPECT_EQ(*rows[1].Find("status"), "bad-input");
  EXPECT_EQ(*rows[1].Find("dice"), "");
}

TEST(ComparisonTable, KeepsItsNumbersOverReadingAndWriting)
{
  PairComparison pair = SpherePair("a", 21.0);
  pair.One.Structure.Label = 3;
  pair.One.Structure.Name = "Lobe, left";
  pair.Unpaired = {"x has no partner"};
  pair.Key = "0123456789abcdef";
  const std::string text = ComparisonTable({pair, Lost("=b")}, Tolerances);
  const std::vector<PairComparison> read = PairsInTable(text, Tolerances);
  ASSERT_EQ(read.size(), 2u);
  // Differences of rounded volumes are rounded once more; after that nothing changes.
  const std::string again = ComparisonTable(read, Tolerances);
  EXPECT_EQ(ComparisonTable(PairsInTable(again, Tolerances), Tolerances), again);
  EXPECT_NEAR(read[0].VolumeDifferencePercent(), pair.VolumeDifferencePercent(), 1e-9);
  EXPECT_NEAR(read[0].Numbers.Overlap->Jaccard(), pair.Numbers.Overlap->Jaccard(), 1e-11);
  EXPECT_EQ(read[0].Key, pair.Key);
  EXPECT_EQ(read[0].Unpaired, pair.Unpaired);
  EXPECT_NEAR(read[0].Numbers.Hausdorff95(), pair.Numbers.Hausdorff95(), 1e-11);
  EXPECT_FALSE(read[1].IsCompared());
}

TEST(ComparisonTable, OfOtherTolerancesOrColumnsHasNoPairs)
{
  EXPECT_TRUE(
      PairsInTable(ComparisonTable({SpherePair("a", 21.0)}, Tolerances), {0.5, 3.0}).empty());
  EXPECT_TRUE(PairsInTable("case,dice\na,0.9\n", Tolerances).empty());
}

TEST(ComparisonOverview, SummarisesComparedPairsOnly)
{
  const std::vector<SummarisedNumber> summary = SummariseComparisons(
      {SpherePair("a", 21.0), Lost("b"), SpherePair("c", 19.0), SpherePair("d", 25.0)});
  const auto& mean = summary.at(1);
  EXPECT_EQ(mean.Name, "mean distance");
  EXPECT_EQ(mean.Summary.Count, 3u);
  EXPECT_NEAR(mean.Summary.Mean, 7.0 / 3.0, 1e-9);
  EXPECT_NEAR(mean.Summary.Median, 1.0, 1e-9);
  EXPECT_NEAR(mean.Summary.Largest, 5.0, 1e-9);
  EXPECT_NEAR(summary.back().Summary.Mean, 2.0 / 3.0, 1e-9); // within 2 mm
}

TEST(ComparisonOverview, NumbersThatDoNotExistAreLeftOut)
{
  const NumberSummary summary = NumberSummary::Of({2.0, std::nan(""), 4.0});
  EXPECT_EQ(summary.Count, 2u);
  EXPECT_EQ(summary.Mean, 3.0);
  EXPECT_TRUE(std::isnan(NumberSummary::Of({}).Mean));
}

TEST(ComparisonOverview, NamesWhatWasNotCompared)
{
  const std::string page = ComparisonOverview({Lost("<b>")}, {"x has no partner"});
  EXPECT_NE(page.find("&lt;b&gt;: no voxel is labelled"), std::string::npos);
  EXPECT_NE(page.find("x has no partner"), std::string::npos);
}
} // namespace
} // namespace palpate::comparison_table_test
