#include "InputError.h"
#include "ModelCsv.h"
#include "RandomModels.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <sstream>

using namespace palpate;
using namespace palpate::test;

namespace
{
std::string SmallFile()
{
  std::mt19937_64 random(1);
  return ModelToCsv({RandomModel(random, 2), {"palpate 0", "a.nii", "1", "", {}}}, "f");
}

std::string RefusalOf(const std::string& text)
{
  try
  {
    ModelFromCsv(text, "folder/name.csv");
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "accepted";
}

std::string Replaced(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}
} // namespace

TEST(ModelCsv, EveryBitOfAStarShapedModelComesBack)
{
  std::mt19937_64 random(2);
  for (const int degree : {0, 1, 12, 40})
  {
    const std::vector<double> values =
        RandomBits(random, SphericalHarmonicBasis::CoefficientCount(degree));
    const std::vector<double> center = RandomBits(random, 3);
    const SphericalHarmonicModel model(degree, values, {center[0], center[1], center[2]});
    const ModelDocument back = ModelFromCsv(ModelToCsv({model, {}}, "f"), "f");
    const auto& read = std::get<SphericalHarmonicModel>(back.Surface);
    EXPECT_TRUE(SameBits(read.Coefficients(), values)) << "degree " << degree;
    EXPECT_TRUE(SameBits(read.CenterWorld(), model.CenterWorld())) << "degree " << degree;
  }
}

TEST(ModelCsv, EveryBitOfAParametricSurfaceComesBack)
{
  std::mt19937_64 random(3);
  const ParametricSphericalSurface surface = RandomParametric(random, 7);
  const ModelDocument back = ModelFromCsv(ModelToCsv({surface, {}}, "f"), "f");
  const auto& read = std::get<ParametricSphericalSurface>(back.Surface);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_TRUE(SameBits(read.Coefficients(k), surface.Coefficients(k)));
  }
}

TEST(ModelCsv, ProvenanceComesBackOnOneLineEach)
{
  std::mt19937_64 random(4);
  const ModelProvenance provenance{
      "palpate 9.8", "evil\n0,0,7", "Prostata Süd", "2024-01-02", {{"degree", "12"}}};
  const ModelProvenance back =
      ModelFromCsv(ModelToCsv({RandomModel(random, 1), provenance}, "f"), "f").Provenance;
  EXPECT_EQ(back.Program, provenance.Program);
  EXPECT_EQ(back.Input, "evil 0,0,7");
  EXPECT_EQ(back.Label, provenance.Label);
  EXPECT_EQ(back.Date, provenance.Date);
  EXPECT_EQ(back.Settings, provenance.Settings);
}

TEST(ModelCsv, CommentsHoldNoFormulaBehindTheirCommas)
{
  std::mt19937_64 random(4);
  const ModelProvenance provenance{"p", "a,=cmd|' /C calc'!A0;+1+1,-2,'@x", {}, {}, {}};
  const std::string text = ModelToCsv({RandomModel(random, 1), provenance}, "f");
  EXPECT_NE(text.find("# input: a,'=cmd|' /C calc'!A0;'+1+1,-2,''@x\n"), std::string::npos) << text;
  EXPECT_EQ(ModelFromCsv(text, "f").Provenance.Input, provenance.Input);
}

TEST(ModelCsv, RowsMayComeInAnyOrderAndWithOtherLineEnds)
{
  std::mt19937_64 random(5);
  const SphericalHarmonicModel model = RandomModel(random, 3);
  const std::string text = ModelToCsv({model, {}}, "f");
  std::vector<std::string> head;
  std::vector<std::string> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    (line[0] == '#' || line[0] == 'l' ? head : rows).push_back(line);
  }
  std::shuffle(rows.begin(), rows.end(), random);
  std::string shuffled;
  for (const auto* part : {&head, &rows})
  {
    for (const std::string& line : *part)
    {
      shuffled += line + "\r\n";
    }
  }
  const ModelDocument back = ModelFromCsv(shuffled, "f");
  EXPECT_TRUE(SameBits(std::get<SphericalHarmonicModel>(back.Surface).Coefficients(),
                       model.Coefficients()));
}

TEST(ModelCsv, OtherStatementsAreRefused)
{
  const std::string text = SmallFile();
  for (const char* change : {"# version: 1", "# frame: patient LPS", "# unit: mm",
                             "# phase: no Condon-Shortley phase", "# surface: star-shaped"})
  {
    const std::string message = RefusalOf(Replaced(text, change, std::string(change) + "x"));
    EXPECT_NE(message.find("folder/name.csv"), std::string::npos) << message;
    EXPECT_NE(RefusalOf(Replaced(text, std::string(change) + "\n", "")), "accepted") << change;
  }
}

TEST(ModelCsv, WrongRowsAreRefused)
{
  const std::string text = SmallFile();
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"\n2,-2,", "\n2,-3,"},
           {"\n2,-2,", "\n3,-2,"},
           {"\n2,-2,", "\n2,-1,"},
           {"\n2,-2,", "\n2,-2,nan"},
           {"\n2,-2,", "\n2,-2,1,"},
           {"\n2,-2,", "\n2;-2;"},
           {"\n2,-2,", "\n-1,0,"},
           {"\n0,0,", "\n0,-1,"},
           {"\n2,2,", "\n2,3,"},
           {"l,m,coefficient_mm", "l,m,coefficient_cm"},
           {"# degree: 2", "# degree: 3"},
           {"# degree: 2", "# degree: 1"},
           {"# degree: 2", "# degree: 2000000000"},
           {"# center_mm: ", "# center_mm: 1 "},
           {"# center_mm: ", "# center_mm: x "}})
  {
    EXPECT_NE(RefusalOf(Replaced(text, from, to)), "accepted") << from << " -> " << to;
  }
}

TEST(ModelCsv, MissingRowIsRefused)
{
  const std::string text = SmallFile();
  EXPECT_NE(RefusalOf(text.substr(0, text.rfind("2,2,"))), "accepted");
}

TEST(ModelCsv, DamagedBytesNeverDoWorseThanARefusal)
{
  const std::string text = SmallFile();
  std::mt19937_64 random(6);
  for (int i = 0; i < 20000; ++i)
  {
    std::string damaged = text.substr(0, 1 + random() % text.size());
    for (std::uint64_t flips = random() % 4; flips > 0; --flips)
    {
      damaged[random() % damaged.size()] = static_cast<char>(random());
    }
    const std::string message = RefusalOf(damaged); // any other exception fails the test
    ASSERT_FALSE(message.empty());
  }
}
