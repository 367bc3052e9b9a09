#include "DecimalText.h"
#include "InputError.h"
#include "ModelCsv.h"
#include "RandomModels.h"

#include <cmath>
#include <gtest/gtest.h>
#include <sstream>

namespace palpate::model_csv_test
{
namespace
{
using namespace palpate::test;

// The numbers of a table's rows after l and m, row by row.
std::vector<double> NumbersOf(const std::string& table)
{
  std::vector<double> numbers;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);)
  {
    if (line[0] == '#' || line[0] == 'l')
    {
      continue;
    }
    std::istringstream cells(line);
    std::string cell;
    for (int column = 0; std::getline(cells, cell, ','); ++column)
    {
      if (column >= 2)
      {
        numbers.push_back(ParseNumber(cell).value());
      }
    }
  }
  return numbers;
}

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

TEST(ModelCsv, KeepsEveryBitOfRadialModel)
{
  std::mt19937_64 random(2);
  for (const int degree : {0, 1, 12, 40})
  {
    const std::vector<double> values =
        RandomBits(random, SphericalHarmonicBasis::CoefficientCount(degree));
    const std::vector<double> center = RandomBits(random, 3);
    const RadialModel model(degree, values, {center[0], center[1], center[2]});
    const std::string table = ModelToCsv({model, {}}, "f");
    EXPECT_TRUE(SameBits(NumbersOf(table), values)) << "degree " << degree;
    EXPECT_TRUE(Has(table, "# center_mm: " + ExactText(center[0]) + " " + ExactText(center[1]) +
                               " " + ExactText(center[2]) + "\n"));
    EXPECT_TRUE(Has(table, "# degree: " + std::to_string(degree) + "\n"));
  }
}

TEST(ModelCsv, KeepsEveryBitOfSurfaceModel)
{
  std::mt19937_64 random(3);
  const SurfaceModel surface = RandomSurfaceModel(random, 7);
  const std::vector<double> numbers = NumbersOf(ModelToCsv({surface, {}}, "f"));
  ASSERT_EQ(numbers.size(), 3U * 64U);
  for (std::size_t i = 0; i < 64; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(numbers[3 * i + static_cast<std::size_t>(k)], surface.Coefficients(k)[i]);
    }
  }
}

TEST(ModelCsv, RowsListDegreesAndOrders)
{
  const RadialModel model(1, {1.0, 2.0, 3.0, 4.0}, Vector3::Zero());
  EXPECT_TRUE(
      Has(ModelToCsv({model, {}}, "f"), "\nl,m,coefficient_mm\n0,0,1\n1,-1,2\n1,0,3\n1,1,4\n"));
}

TEST(ModelCsv, ProvenanceHasOneLinePerEntry)
{
  std::mt19937_64 random(4);
  const ModelProvenance provenance{
      "palpate 9.8", "evil\n0,0,7", "Prostata Süd", "2024-01-02", {{"degree", "12"}}};
  const std::string table = ModelToCsv({RandomModel(random, 1), provenance}, "f");
  EXPECT_TRUE(Has(table, "# program: palpate 9.8\n# input: evil 0 0 7\n# label: Prostata Süd\n"
                         "# date: 2024-01-02\n# setting degree: 12\n"));
}

TEST(ModelCsv, CommentsAreOneCell)
{
  std::mt19937_64 random(4);
  const ModelProvenance provenance{"p", "a,=cmd|' /C calc'!A0;+1+1\t-2", {}, {}, {}};
  const std::string text = ModelToCsv({RandomModel(random, 1), provenance}, "f");
  EXPECT_TRUE(Has(text, "# signs: m >= 0: cos(m phi), m < 0: sin(|m| phi)\n"));
  EXPECT_TRUE(Has(text, "# input: a =cmd|' /C calc'!A0 +1+1 -2\n")) << text;
}

TEST(ModelCsv, RejectsNonFiniteNumbers)
{
  EXPECT_THROW(ModelToCsv({RadialModel(0, {std::nan("")}, Vector3::Zero()), {}}, "f"), InputError);
}
} // namespace
} // namespace palpate::model_csv_test
