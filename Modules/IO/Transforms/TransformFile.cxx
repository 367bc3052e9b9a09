#include "TransformFile.h"

#include "AffineRows.h"
#include "DecimalText.h"
#include "FileFormat.h"
#include "FslSpace.h"
#include "HdfTransform.h"
#include "ImageFormat.h"
#include "InputError.h"
#include "ItkTransform.h"
#include "Refusal.h"
#include "WholeFile.h"

#include <cmath>
#include <locale>
#include <sstream>

namespace palpate
{
namespace
{
using Matrix34 = Eigen::Matrix<double, 3, 4>;

constexpr std::uintmax_t LargestTransform = 1U << 20U; // bytes
constexpr double LeastDeterminant = 1e-9;

// Patient RAS and LPS differ by the signs of the first two axes.
Eigen::Affine3d OtherFrame(const Eigen::Affine3d& map)
{
  const Eigen::Affine3d flip(Eigen::Vector3d(-1.0, -1.0, 1.0).asDiagonal());
  return flip * map * flip;
}

std::string RowText(const Eigen::Affine3d& map, int row)
{
  std::string text;
  for (int column = 0; column < 4; ++column)
  {
    text += (column > 0 ? " " : "") + ExactText(map.matrix()(row, column));
  }
  return text;
}

// The three rows that follow `mark` in a file, up to `end`.
Eigen::Affine3d RowsAfter(const std::filesystem::path& file, const std::string& text,
                          const std::string& mark, const std::string& end)
{
  const std::size_t found = text.find(mark);
  Matrix34 rows;
  bool isWhole = found != std::string::npos;
  if (isWhole)
  {
    std::istringstream numbers(text.substr(found + mark.size()));
    numbers.imbue(std::locale::classic());
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 4; ++column)
      {
        isWhole = isWhole && numbers >> rows(row, column);
      }
    }
    // The last number might be cut off.
    std::string next;
    isWhole = isWhole && numbers >> next && next.rfind(end, 0) == 0;
  }
  if (!isWhole)
  {
    Refuse(file, "has no three whole rows of four numbers after \"" + mark + "\"",
           "write it again with the program that made it");
  }
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  map.matrix().topRows<3>() = rows;
  return map;
}

Eigen::Affine3d ReadLta(const std::filesystem::path& file, const std::string& text)
{
  std::istringstream lines(text);
  int type = -1;
  int count = -1;
  for (std::string line; std::getline(lines, line);)
  {
    std::istringstream words(line);
    std::string key;
    std::string sign;
    int value = 0;
    if (words >> key >> sign >> value && sign == "=")
    {
      type = key == "type" && type < 0 ? value : type;
      count = key == "nxforms" && count < 0 ? value : count;
    }
  }
  if (type != 1 || count != 1)
  {
    Refuse(file, "is not one transform of type 1 (RAS to RAS)",
           "make one with lta_convert --outlta NAME.lta, without --ltavox2vox");
  }
  return OtherFrame(RowsAfter(file, text, "1 4 4", "0"));
}

Eigen::Affine3d ReadItk(const std::filesystem::path& file, const std::string& text)
{
  if (text.find("FixedParameters:") == std::string::npos)
  {
    Refuse(file, "is not a transform of ITK, or is cut off", "write it again as text (.tfm)");
  }
  return ToAffine(ReadItkTransform(file));
}

Eigen::Affine3d ReadXfm(const std::filesystem::path& file, const std::string& text)
{
  if (text.rfind("MNI Transform File", 0) != 0 ||
      text.find("Transform_Type") != text.rfind("Transform_Type"))
  {
    Refuse(file, "is not one transform of MINC", "concatenate several with xfmconcat");
  }
  return OtherFrame(RowsAfter(file, text, "Linear_Transform =", ";"));
}

std::string TfmText(const Eigen::Affine3d& map)
{
  const Eigen::Affine3d toMoving = map.inverse();
  std::string text = "#Insight Transform File V1.0\n#Transform 0\n"
                     "Transform: AffineTransform_double_3_3\nParameters:";
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      text += " " + ExactText(toMoving.linear()(row, column));
    }
  }
  for (int row = 0; row < 3; ++row)
  {
    text += " " + ExactText(toMoving.translation()[row]);
  }
  return text + "\nFixedParameters: 0 0 0\n";
}

std::string LtaText(const Eigen::Affine3d& map)
{
  std::string text = "type      = 1 # LINEAR_RAS_TO_RAS\nnxforms   = 1\n"
                     "mean      = 0.0000 0.0000 0.0000\nsigma     = 1.0000\n1 4 4\n";
  for (int row = 0; row < 3; ++row)
  {
    text += RowText(map, row) + "\n";
  }
  text += "0 0 0 1\n";
  for (const char* volume : {"src", "dst"})
  {
    text += std::string(volume) + " volume info\nvalid = 0  # volume info invalid\n";
  }
  return text;
}

std::string XfmText(const Eigen::Affine3d& map)
{
  std::string text = "MNI Transform File\n\nTransform_Type = Linear;\nLinear_Transform =\n";
  for (int row = 0; row < 3; ++row)
  {
    text += RowText(map, row) + (row < 2 ? "\n" : ";\n");
  }
  return text;
}

// From FSL's coordinates of an image to the patient.
Eigen::Affine3d FslSpaceOf(const std::filesystem::path& file, const std::filesystem::path& image)
{
  if (image.empty())
  {
    Refuse(file, "is a matrix of FLIRT, which is in the frames of two images",
           "name both images, or take " + ListOfEndings({".tfm", ".lta", ".xfm"}));
  }
  return FslSpaceOf(OpenImage(image)->Grid());
}

Eigen::Affine3d ReadFlirt(const std::filesystem::path& file, const std::string& text,
                          const TransformImages& images)
{
  std::istringstream numbers(text);
  numbers.imbue(std::locale::classic());
  Eigen::Matrix4d rows = Eigen::Matrix4d::Zero();
  bool isWhole = true;
  for (int i = 0; i < 16; ++i)
  {
    isWhole = isWhole && numbers >> rows(i / 4, i % 4);
  }
  std::string more;
  if (!isWhole || numbers >> more || rows.row(3) != Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0))
  {
    Refuse(file, "is no text of four rows of four numbers, as FLIRT writes them",
           "write it again with flirt -omat, or write ITK's as text (.tfm)");
  }
  return FslSpaceOf(file, images.Fixed) * Eigen::Affine3d(rows) *
         FslSpaceOf(file, images.Moving).inverse();
}

std::string FlirtText(const std::filesystem::path& file, const Eigen::Affine3d& map,
                      const TransformImages& images)
{
  const Eigen::Affine3d own =
      FslSpaceOf(file, images.Fixed).inverse() * map * FslSpaceOf(file, images.Moving);
  std::string text;
  for (int row = 0; row < 4; ++row)
  {
    text += RowText(own, row) + "\n";
  }
  return text;
}

[[noreturn]] void RefuseEnding(const std::filesystem::path& file)
{
  Refuse(file, "is no transform by its name", "name it " + ListOfEndings(TransformEndings()));
}
} // namespace

const std::vector<std::string>& TransformEndings()
{
  static const std::vector<std::string> Endings{".tfm", ".txt", ".h5", ".lta", ".xfm", ".mat"};
  return Endings;
}

Eigen::Affine3d ReadTransform(const std::filesystem::path& file, const TransformImages& images)
{
  const std::string ending = EndingOf(file, TransformEndings());
  if (ending.empty())
  {
    RefuseEnding(file);
  }
  const bool isHdf = ending == ".h5";
  const std::string text = isHdf ? std::string() : ReadWholeFile(file, LargestTransform);
  Eigen::Affine3d map = isHdf              ? ToAffine(ReadHdfTransform(file))
                        : ending == ".lta" ? ReadLta(file, text)
                        : ending == ".xfm" ? ReadXfm(file, text)
                        : ending == ".mat" ? ReadFlirt(file, text, images)
                                           : ReadItk(file, text);
  const double determinant = map.linear().determinant();
  if (!map.matrix().allFinite() || !(std::abs(determinant) > LeastDeterminant))
  {
    Refuse(file, "maps the patient's space to a plane, or has numbers that are not finite",
           "register again");
  }
  return isHdf || ending == ".tfm" || ending == ".txt" ? map.inverse() : map;
}

void WriteTransform(const std::filesystem::path& file, const Eigen::Affine3d& map,
                    const TransformImages& images)
{
  const std::string ending = EndingOf(file, TransformEndings());
  if (ending.empty())
  {
    RefuseEnding(file);
  }
  if (ending == ".h5")
  {
    WriteHdfTransform(file, ToMapRows(map.inverse()));
    return;
  }
  const Eigen::Affine3d otherFrame = OtherFrame(map);
  WriteWholeFile(file, ending == ".lta"   ? LtaText(otherFrame)
                       : ending == ".xfm" ? XfmText(otherFrame)
                       : ending == ".mat" ? FlirtText(file, map, images)
                                          : TfmText(map));
}
} // namespace palpate
