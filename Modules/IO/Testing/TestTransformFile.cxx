#include "TransformFile.h"

#include "InputError.h"
#include "TemporaryFolder.h"
#include "WholeFile.h"

#include <gtest/gtest.h>
#include <random>

namespace palpate::transform_file_test
{
namespace
{
class TransformFile : public testing::Test
{
protected:
  std::filesystem::path Write(const std::string& name, const std::string& text) const
  {
    WriteWholeFile(this->Folder / name, text);
    return this->Folder / name;
  }
  std::string RefusalOf(const std::string& name, const std::string& text) const
  {
    try
    {
      ReadTransform(this->Write(name, text));
    }
    catch (const InputError& error)
    {
      return error.what();
    }
    return "read";
  }

  test::TemporaryFolder Folder;
};

std::string Tfm(const std::string& type, const std::string& parameters,
                const std::string& center = "0 0 0")
{
  return "#Insight Transform File V1.0\n#Transform 0\nTransform: " + type +
         "\nParameters: " + parameters + "\nFixedParameters: " + center + "\n";
}

TEST_F(TransformFile, EveryFormatReadsWhatItWrites)
{
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (int draw = 0; draw < 20; ++draw)
  {
    Eigen::Affine3d map = Eigen::Affine3d::Identity();
    map.matrix().topRows<3>() =
        map.matrix().topRows<3>() +
        0.3 * Eigen::Matrix<double, 3, 4>::NullaryExpr([&] { return normal(random); });
    map.translation() *= 100.0;
    for (const std::string& ending : TransformEndings())
    {
      const std::filesystem::path file = this->Folder / ("map" + ending);
      WriteTransform(file, map);
      EXPECT_LT((ReadTransform(file).matrix() - map.matrix()).norm(), 1e-10) << ending;
    }
  }
}

// A body that moves by 10 mm to the patient's left, 20 to the back, 30 upwards: LPS and RAS differ.
TEST_F(TransformFile, FramesAreThoseOfEachProgram)
{
  const Eigen::Affine3d map(Eigen::Translation3d(10.0, 20.0, 30.0));
  const std::string matrix = "1 0 0 0 1 0 0 0 1 ";
  const std::vector<std::pair<std::string, std::string>> files{
      {"a.tfm", Tfm("AffineTransform_double_3_3", matrix + "-10 -20 -30")}, // fixed to moving, LPS
      {"a.lta", "type      = 1 # LINEAR_RAS_TO_RAS\nnxforms   = 1\nmean = 0 0 0\nsigma = 1\n1 4 4\n"
                "1 0 0 -10\n0 1 0 -20\n0 0 1 30\n0 0 0 1\nsrc volume info\nvalid = 0\n"},
      {"a.xfm", "MNI Transform File\n% made by hand\n\nTransform_Type = Linear;\n"
                "Linear_Transform =\n 1 0 0 -10\n 0 1 0 -20\n 0 0 1 30;\n"}};
  for (const auto& [name, text] : files)
  {
    EXPECT_LT((ReadTransform(this->Write(name, text)).matrix() - map.matrix()).norm(), 1e-12)
        << name;
  }
}

// As ITK writes them: a turn by 90 degrees about z through a centre.
TEST_F(TransformFile, RigidAndSimilarTransformsOfItkAreRead)
{
  const Vector3 center(5.0, 0.0, 0.0);
  const Vector3 there(5.0, 1.0, 0.0); // where the point one beside the centre on x goes
  for (const auto& [type, parameters] : std::vector<std::pair<std::string, std::string>>{
           {"Euler3DTransform_double_3_3", "0 0 1.5707963267948966 0 0 0"},
           {"VersorRigid3DTransform_double_3_3", "0 0 0.70710678118654752 0 0 0"},
           {"Similarity3DTransform_double_3_3", "0 0 0.70710678118654752 0 0 0 1"}})
  {
    const Eigen::Affine3d map = ReadTransform(this->Write("a.tfm", Tfm(type, parameters, "5 0 0")));
    EXPECT_LT((map.inverse() * Vector3(center + Vector3::UnitX()) - there).norm(), 1e-12) << type;
  }
  const Eigen::Affine3d shift = ReadTransform(this->Write(
      "s.tfm", "#Insight Transform File V1.0\n#Transform 0\nTransform: "
               "TranslationTransform_double_3_3\nParameters: 1 2 3\nFixedParameters: \n"));
  EXPECT_LT((shift.translation() + Vector3(1.0, 2.0, 3.0)).norm(), 1e-12);
}

TEST_F(TransformFile, RefusesWhatIsNoLinearMap)
{
  const std::string flat = Tfm("AffineTransform_double_3_3", "1 0 0 0 1 0 0 0 0 0 0 0");
  EXPECT_NE(this->RefusalOf("a.tfm", flat).find("to a plane"), std::string::npos);
  const std::string one = Tfm("AffineTransform_double_3_3", "1 0 0 0 1 0 0 0 1 0 0 0");
  EXPECT_NE(this->RefusalOf("a.tfm", one + one.substr(one.find("#Transform 0"))).find("several"),
            std::string::npos);
  EXPECT_NE(this->RefusalOf("a.tfm", Tfm("AffineTransform_double_2_2", "1 0 0 1 0 0", "0 0")),
            "read");
  EXPECT_NE(
      this->RefusalOf("a.tfm", Tfm("AffineTransform_double_3_3", "1 0 0 nan 1 0 0 0 1 0 0 0")),
      "read");
  EXPECT_NE(this->RefusalOf("a.lta", "type = 0\nnxforms = 1\n1 4 4\n1 0 0 0\n0 1 0 0\n0 0 1 0\n")
                .find("RAS to RAS"),
            std::string::npos);
  EXPECT_NE(this->RefusalOf("a.xfm", "MNI Transform File\nTransform_Type = Grid_Transform;\n"),
            "read");
  EXPECT_THROW(WriteTransform(this->Folder / "a.mat", Eigen::Affine3d::Identity()), InputError);
  // However it is cut off, it is refused or the same.
  for (const std::string& ending : TransformEndings())
  {
    const std::filesystem::path file = this->Folder / ("cut" + ending);
    WriteTransform(file, Eigen::Affine3d(Eigen::Translation3d(1.0, 2.0, 3.0)));
    const std::string text = ReadWholeFile(file, 4096);
    for (std::size_t length = 1; length < text.size(); length += 3)
    {
      if (this->RefusalOf("part" + ending, text.substr(0, length)) == "read")
      {
        EXPECT_TRUE(ReadTransform(this->Folder / ("part" + ending)).isApprox(ReadTransform(file)))
            << ending << ' ' << length;
      }
    }
  }
}
} // namespace
} // namespace palpate::transform_file_test
