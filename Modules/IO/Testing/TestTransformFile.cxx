#include "TransformFile.h"

#include "InputError.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "WholeFile.h"

#include <gtest/gtest.h>
#include <random>
#include <sstream>

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
      const TransformImages images{this->Write("a.nii", test::NiftiBytes({})),
                                   this->Write("b.nii", test::NiftiBytes({}))};
      WriteTransform(file, map, images);
      EXPECT_LT((ReadTransform(file, images).matrix() - map.matrix()).norm(), 1e-10) << ending;
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

// A NIfTI file of 4 x 5 x 6 voxels with these axes (columns, RAS).
test::NiftiSpec NiftiOf(const Eigen::Matrix3d& axes, const Vector3& spacing, const Vector3& origin)
{
  test::NiftiSpec spec;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto at = static_cast<std::size_t>(axis);
    spec.PixelDimensions[at + 1] = static_cast<float>(spacing[axis]);
    spec.SForm[4 * at + 3] = static_cast<float>(origin[axis]);
    for (int column = 0; column < 3; ++column)
    {
      spec.SForm[4 * at + static_cast<std::size_t>(column)] =
          static_cast<float>(axes(axis, column) * spacing[column]);
    }
  }
  return spec;
}

// FLIRT's coordinates of a voxel: mm along the file's axes; the first is counted from the other end
// in files whose axes are right-handed (FSL's FLIRT FAQ).
Vector3 FlirtPlace(const Eigen::Matrix3d& axes, const Vector3& spacing, Vector3 voxel)
{
  voxel[0] = axes.determinant() > 0.0 ? 3.0 - voxel[0] : voxel[0];
  return voxel.cwiseProduct(spacing);
}

TEST_F(TransformFile, FlirtMatricesHoldInAll48AxisOrders)
{
  const Eigen::Affine3d map = Eigen::Translation3d(3.0, -7.0, 11.0) *
                              Eigen::AngleAxisd(0.4, Vector3(1.0, 2.0, -1.0).normalized());
  const Vector3 spacing(0.5, 1.25, 3.0);
  const Vector3 fixedSpacing(2.0, 0.75, 1.0);
  const Vector3 origin(10.0, -20.0, 30.0);
  const Vector3 toLps(-1.0, -1.0, 1.0);
  const std::vector<Eigen::Matrix3d> orders = test::AllAxisOrders();
  for (std::size_t i = 0; i < orders.size(); ++i)
  {
    const Eigen::Matrix3d& axes = orders[i];
    const Eigen::Matrix3d& fixedAxes = orders[(7 * i + 5) % orders.size()];
    const TransformImages images{
        this->Write("a.nii", test::NiftiBytes(NiftiOf(axes, spacing, origin))),
        this->Write("b.nii", test::NiftiBytes(NiftiOf(fixedAxes, fixedSpacing, -origin)))};
    WriteTransform(this->Folder / "a.mat", map, images);
    std::istringstream numbers(ReadWholeFile(this->Folder / "a.mat", 10000));
    Eigen::Matrix4d rows;
    for (int at = 0; at < 16; ++at)
    {
      numbers >> rows(at / 4, at % 4);
    }
    for (const Vector3& voxel : {Vector3(0, 0, 0), Vector3(3, 1, 0), Vector3(1, 4, 5)})
    {
      const Vector3 world =
          toLps.cwiseProduct(Vector3(origin + axes * spacing.cwiseProduct(voxel)));
      const Vector3 there = toLps.cwiseProduct(Vector3(map * world)); // RAS
      const Vector3 fixedVoxel =
          (fixedAxes.transpose() * (there + origin)).cwiseQuotient(fixedSpacing);
      const Vector3 place = (rows * FlirtPlace(axes, spacing, voxel).homogeneous()).head<3>();
      ASSERT_LT((place - FlirtPlace(fixedAxes, fixedSpacing, fixedVoxel)).norm(), 1e-4) << i;
    }
    ASSERT_LT((ReadTransform(this->Folder / "a.mat", images).matrix() - map.matrix()).norm(),
              1e-10);
  }
}

TEST_F(TransformFile, RefusesFlirtMatricesWithoutImagesAndOfOtherKinds)
{
  const std::string good = "1 0 0 3\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
  EXPECT_NE(this->RefusalOf("a.mat", good).find("name both images"), std::string::npos);
  EXPECT_NE(this->RefusalOf("a.mat", "1 0 0 3\n0 1 0 0\n0 0 1 0\n").find("four rows"),
            std::string::npos);
  EXPECT_NE(this->RefusalOf("a.mat", good + "1").find("four rows"), std::string::npos);
  EXPECT_NE(this->RefusalOf("a.mat", std::string("\1\0\0\0 binary", 11)).find("four rows"),
            std::string::npos);
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
  EXPECT_THROW(WriteTransform(this->Folder / "a.hdf", Eigen::Affine3d::Identity()), InputError);
}

TEST_F(TransformFile, CutOffFilesAreRefusedOrTheSame)
{
  const std::filesystem::path image = this->Write("image.nii", test::NiftiBytes({}));
  for (const std::string& ending : TransformEndings())
  {
    if (ending == ".h5")
    {
      continue; // binary; see the next test
    }
    const std::filesystem::path file = this->Folder / ("cut" + ending);
    WriteTransform(file, Eigen::Affine3d(Eigen::Translation3d(1.0, 2.0, 3.0)), {image, image});
    const Eigen::Affine3d whole = ReadTransform(file, {image, image});
    const std::string text = ReadWholeFile(file, 4096);
    for (std::size_t length = 1; length < text.size(); length += 3)
    {
      const std::filesystem::path part = this->Write("part" + ending, text.substr(0, length));
      try
      {
        EXPECT_TRUE(ReadTransform(part, {image, image}).isApprox(whole)) << ending << length;
      }
      catch (const InputError&)
      {
      }
    }
  }
}

// Cut off, or with wrong bytes: one sentence, or a transform that its numbers allow.
TEST_F(TransformFile, BrokenHdfIsRefusedOrRead)
{
  const std::filesystem::path file = this->Folder / "a.h5";
  WriteTransform(file, Eigen::Affine3d(Eigen::Translation3d(1.0, 2.0, 3.0)));
  const std::string whole = ReadWholeFile(file, 1U << 20U);
  std::mt19937_64 random(308);
  int refused = 0;
  for (int n = 0; n < 40; ++n)
  {
    std::string broken = whole;
    if (n % 4 == 0)
    {
      broken.resize(random() % whole.size());
    }
    for (int byte = 0; byte < 1 + n / 4 && !broken.empty(); ++byte)
    {
      broken[random() % broken.size()] = static_cast<char>(random());
    }
    const std::string message = this->RefusalOf("a.h5", broken);
    EXPECT_TRUE(message == "read" || message.find("a.h5") != std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
    refused += message == "read" ? 0 : 1;
  }
  EXPECT_GT(refused, 10);
  for (const std::string& text : {std::string(), std::string("#Insight Transform File V1.0\n"),
                                  std::string(std::size_t{2} << 20U, 'x')})
  {
    EXPECT_NE(this->RefusalOf("a.h5", text), "read");
  }
}

} // namespace
} // namespace palpate::transform_file_test
