#include "ImageGrid.h"
#include "MessageOf.h"
#include "SegmentationFile.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numeric>

namespace palpate::orientations_test
{
namespace
{
using namespace palpate::test;

// Different, so that exchanged axes are detected.
const Vector3 Spacing(0.5, 1.25, 3.0);
const Vector3 Origin(10.0, -20.0, 30.0);
// Factors between RAS and LPS coordinates, in both directions.
const Vector3 HalfTurn(-1.0, -1.0, 1.0);

// 4 x 5 x 6 voxels, each with a unique value: its number in the file.
std::string CountingVoxels()
{
  std::string voxels(120, '\0');
  std::iota(voxels.begin(), voxels.end(), '\0');
  return voxels;
}

// -1 outside the image.
double ValueAt(vtkImageData* image, const Vector3& world)
{
  double index[3];
  image->TransformPhysicalPointToContinuousIndex(world.data(), index);
  std::array<int, 3> voxel{};
  for (int k = 0; k < 3; ++k)
  {
    const auto i = static_cast<std::size_t>(k);
    voxel[i] = static_cast<int>(std::lround(index[k]));
    if (!(voxel[i] >= 0 && voxel[i] < image->GetDimensions()[k]))
    {
      return -1.0;
    }
  }
  return image->GetScalarComponentAsDouble(voxel[0], voxel[1], voxel[2], 0);
}

// Whether all voxels of an image are at the positions given by the axes (columns, LPS), Spacing and
// an origin.
testing::AssertionResult HasVoxelsAt(vtkImageData* image, const Eigen::Matrix3d& axes,
                                     const Vector3& origin)
{
  if (!(GridOf(image).Direction.determinant() > 0.0))
  {
    return testing::AssertionFailure() << "its axes are left-handed";
  }
  for (int voxel = 0; voxel < 120; ++voxel)
  {
    const int row = voxel / 4 % 5;
    const int slice = voxel / 20;
    const Vector3 index(voxel % 4, row, slice);
    const Vector3 world = origin + axes * Spacing.cwiseProduct(index);
    if (ValueAt(image, world) != voxel)
    {
      return testing::AssertionFailure() << "voxel " << voxel << " is not at its place";
    }
  }
  return testing::AssertionSuccess();
}

std::size_t CountOf(const std::vector<std::string>& notes, const std::string& part)
{
  return static_cast<std::size_t>(std::count_if(notes.begin(), notes.end(),
                                                [&part](const std::string& note)
                                                { return note.find(part) != std::string::npos; }));
}

// Reads a file of each axis order, as a volume and as a label map. `bytesOf` receives the header's
// axes; `signs` converts the header's coordinates to LPS.
void ExpectAllOrdersKeepTheirPlaces(
    const std::string& name, const Vector3& signs,
    const std::function<std::string(const Eigen::Matrix3d& axes)>& bytesOf)
{
  const TemporaryFolder folder;
  std::size_t leftHanded = 0;
  for (const Eigen::Matrix3d& axes : AllAxisOrders())
  {
    SCOPED_TRACE(testing::Message() << name << ", columns of\n" << axes);
    WriteAll(folder / name, bytesOf(axes));
    const Eigen::Matrix3d axesWorld = signs.asDiagonal() * axes;
    const Vector3 originWorld = signs.cwiseProduct(Origin);
    const bool isLeftHanded = axesWorld.determinant() < 0.0;
    leftHanded += isLeftHanded ? 1 : 0;
    const Volume volume = ReadVolume(folder / name);
    ASSERT_TRUE(HasVoxelsAt(volume.Image, axesWorld, originWorld));
    ASSERT_EQ(CountOf(volume.Notes, "left-handed"), isLeftHanded ? 1u : 0u);
    const Segmentation labels = ReadSegmentation(folder / name);
    ASSERT_TRUE(HasVoxelsAt(labels.Layers[0], axesWorld, originWorld));
    ASSERT_EQ(labels.Notes, volume.Notes);
    if (isLeftHanded)
    {
      ASSERT_TRUE(Contains(MessageOf(
                               [&] {
                                 ReadVolume(folder / name, {{}, LeftHandedAxes::Refuse});
                               }),
                           "has left-handed directions"));
      ASSERT_THROW(ReadSegmentation(folder / name, LeftHandedAxes::Refuse), InputError);
    }
  }
  EXPECT_EQ(leftHanded, 24u);
}

std::string VectorText(const Vector3& v)
{
  return '(' + std::to_string(v[0]) + ',' + std::to_string(v[1]) + ',' + std::to_string(v[2]) + ')';
}

// `frame`: the line that names the space.
std::string NrrdOf(const std::string& frame, const Eigen::Matrix3d& axes)
{
  const Eigen::Matrix3d steps = axes * Spacing.asDiagonal();
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  lines[2] = frame;
  lines[4] = "space directions: " + VectorText(steps.col(0)) + ' ' + VectorText(steps.col(1)) +
             ' ' + VectorText(steps.col(2));
  lines[8] = "space origin: " + VectorText(Origin);
  return NrrdBytes(lines, CountingVoxels());
}

std::vector<std::string> NotesOfNrrd(const std::vector<std::string>& lines)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.nrrd", NrrdBytes(lines, CountingVoxels()));
  return ReadVolume(folder / "a.nrrd").Notes;
}

std::string RefusalOfNrrd(const std::vector<std::string>& lines)
{
  return MessageOf([&] { NotesOfNrrd(lines); });
}

std::vector<std::string> LinesWith(std::size_t line, const std::string& text)
{
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  lines[line] = text;
  return lines;
}

// A NIfTI header with Spacing and no orientation.
NiftiSpec NiftiOfSpacing()
{
  NiftiSpec spec;
  spec.SFormCode = 0;
  spec.PixelDimensions = {1.0F, 0.5F, 1.25F, 3.0F};
  return spec;
}

TEST(Orientations, NiftiSFormKeepsPositionsInAll48AxisOrders)
{
  ExpectAllOrdersKeepTheirPlaces("a.nii", HalfTurn,
                                 [](const Eigen::Matrix3d& axes)
                                 {
                                   NiftiSpec spec = NiftiOfSpacing();
                                   spec.SFormCode = 1;
                                   for (int row = 0; row < 3; ++row)
                                   {
                                     const auto first = static_cast<std::size_t>(4 * row);
                                     for (int k = 0; k < 3; ++k)
                                     {
                                       spec.SForm[first + static_cast<std::size_t>(k)] =
                                           static_cast<float>(axes(row, k) * Spacing[k]);
                                     }
                                     spec.SForm[first + 3] = static_cast<float>(Origin[row]);
                                   }
                                   return NiftiBytes(spec, CountingVoxels());
                                 });
}

TEST(Orientations, NiftiQFormKeepsPositionsInAll48AxisOrders)
{
  ExpectAllOrdersKeepTheirPlaces("a.nii", HalfTurn,
                                 [](const Eigen::Matrix3d& axes)
                                 {
                                   NiftiSpec spec = NiftiOfSpacing();
                                   spec.QFormCode = 1;
                                   // nifti1.h: a rotation; pixdim[0] states whether the slice axis
                                   // is then reversed.
                                   const double sign = axes.determinant() < 0.0 ? -1.0 : 1.0;
                                   const Eigen::Matrix3d rotation =
                                       axes * Vector3(1.0, 1.0, sign).asDiagonal();
                                   const Eigen::Quaterniond turn(rotation);
                                   const double positive = turn.w() < 0.0 ? -1.0 : 1.0;
                                   spec.PixelDimensions[0] = static_cast<float>(sign);
                                   for (int k = 0; k < 3; ++k)
                                   {
                                     const auto i = static_cast<std::size_t>(k);
                                     spec.QForm[i] = static_cast<float>(positive * turn.vec()[k]);
                                     spec.QForm[i + 3] = static_cast<float>(Origin[k]);
                                   }
                                   return NiftiBytes(spec, CountingVoxels());
                                 });
}

TEST(Orientations, MetaImageKeepsPositionsInAll48AxisOrders)
{
  // Programs disagree on the meaning of the letters; the matrix is unambiguous.
  for (const char* letters : {"RAI", "LPS", "ASR", "???"})
  {
    ExpectAllOrdersKeepTheirPlaces(
        "a.mha", Vector3::Ones(),
        [letters](const Eigen::Matrix3d& axes)
        {
          // A row of TransformMatrix is an index axis.
          std::string bytes = MetaImageBytes("MET_UCHAR", CountingVoxels(), "TransformMatrix =");
          std::string matrix;
          for (int k = 0; k < 9; ++k)
          {
            matrix += ' ' + std::to_string(static_cast<int>(axes(k % 3, k / 3)));
          }
          const std::string start = "TransformMatrix =";
          bytes.insert(
              bytes.find(start) + start.size(),
              matrix + "\nElementSpacing = 0.5 1.25 3\nAnatomicalOrientation = " + letters + '\n');
          const std::string offset = "Offset = 10 20 30";
          return bytes.replace(bytes.find(offset), offset.size(), "Offset = 10 -20 30");
        });
  }
}

TEST(Orientations, NotesMetaImageWithoutMatrix)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.mha",
           MetaImageBytes("MET_UCHAR", CountingVoxels(), "ElementSpacing = 2 2 2\n"));
  const Volume volume = ReadVolume(folder / "a.mha");
  EXPECT_EQ(CountOf(volume.Notes, "gives no TransformMatrix"), 1u);
  EXPECT_TRUE(GridOf(volume.Image).Direction.isIdentity());
}

TEST(Orientations, NrrdKeepsPositionsInAllSpacesAndAxisOrders)
{
  const std::vector<std::pair<std::string, Vector3>> spaces{
      {"left-posterior-superior", {1, 1, 1}}, {"LPS", {1, 1, 1}},
      {"right-anterior-superior", HalfTurn},  {"RAS", HalfTurn},
      {"left-anterior-superior", {1, -1, 1}}, {"LAS", {1, -1, 1}},
      {"left anterior superior", {1, -1, 1}}};
  for (const auto& [space, signs] : spaces)
  {
    SCOPED_TRACE(space);
    ExpectAllOrdersKeepTheirPlaces("a.nrrd", signs,
                                   [name = space](const Eigen::Matrix3d& axes)
                                   { return NrrdOf("space: " + name, axes); });
  }
}

TEST(Orientations, NotesNrrdSpacesAssumedAsLps)
{
  for (const char* frame : {"space: scanner-xyz", "space: 3D-right-handed", "space dimension: 3"})
  {
    SCOPED_TRACE(frame);
    ExpectAllOrdersKeepTheirPlaces("a.nrrd", Vector3::Ones(),
                                   [frame](const Eigen::Matrix3d& axes)
                                   { return NrrdOf(frame, axes); });
    const std::vector<std::string> notes = NotesOfNrrd(LinesWith(2, frame));
    EXPECT_EQ(notes.size(), 1u);
    EXPECT_EQ(CountOf(notes, "taken as L, P, S"), 1u);
  }
}

TEST(Orientations, NotesNrrdWithoutDirections)
{
  const std::vector<std::string> lines{"type: unsigned char", "dimension: 3", "sizes: 4 5 6",
                                       "spacings: 2 2 2", "encoding: raw"};
  EXPECT_EQ(NotesOfNrrd(lines), std::vector<std::string>{"The file gives no space directions; its "
                                                         "index axes were taken as L, P, S."});
}

TEST(Orientations, AreKnownOnlyIfTheFileStatesThem)
{
  const TemporaryFolder folder;
  const auto isOriented = [&folder](const std::vector<std::string>& lines)
  {
    WriteAll(folder / "a.nrrd", NrrdBytes(lines, CountingVoxels()));
    return ReadVolume(folder / "a.nrrd").IsOriented &&
           ReadSegmentation(folder / "a.nrrd").IsOriented;
  };
  EXPECT_TRUE(isOriented(PlainNrrdLines("unsigned char")));
  EXPECT_FALSE(isOriented(LinesWith(2, "space: scanner-xyz")));
}

TEST(Orientations, NrrdInPatientSpaceGetsNoNote)
{
  EXPECT_TRUE(NotesOfNrrd(PlainNrrdLines("unsigned char")).empty());
}

TEST(Orientations, LengthsFollowUnitOfNrrd)
{
  const std::vector<std::pair<std::string, double>> units{
      {"mm", 1.0},  {"um", 1e-3}, {"\xC2\xB5m", 1e-3},  {"micron", 1e-3},
      {"cm", 10.0}, {"m", 1e3},   {"Millimeters", 1.0}, {"in", 25.4}};
  const TemporaryFolder folder;
  for (const auto& [unit, millimeters] : units)
  {
    SCOPED_TRACE(unit);
    std::vector<std::string> lines = PlainNrrdLines("unsigned char");
    lines[2] = "space: right-anterior-superior";
    lines.push_back("space units: \"" + unit + "\" \"" + unit + "\" \"" + unit + "\"");
    WriteAll(folder / "a.nrrd", NrrdBytes(lines, CountingVoxels()));
    const Volume volume = ReadVolume(folder / "a.nrrd");
    const ImageGrid grid = GridOf(volume.Image);
    EXPECT_LT((grid.Spacing - Vector3::Constant(2.0 * millimeters)).norm(), 1e-12);
    EXPECT_LT((grid.OriginWorld - millimeters * Vector3(-10, -20, 30)).norm(), 1e-12);
    EXPECT_EQ(CountOf(volume.Notes, "was converted to mm"), millimeters == 1.0 ? 0u : 1u);
  }
}

TEST(Orientations, UnitsOfAxesCountWithoutDirections)
{
  const std::vector<std::string> lines{
      "type: unsigned char",         "dimension: 3", "sizes: 4 5 6", "spacings: 0.2 0.2 0.2",
      "units: \"cm\" \"cm\" \"cm\"", "encoding: raw"};
  const TemporaryFolder folder;
  WriteAll(folder / "a.nrrd", NrrdBytes(lines, CountingVoxels()));
  EXPECT_LT((GridOf(ReadVolume(folder / "a.nrrd").Image).Spacing - Vector3(2, 2, 2)).norm(), 1e-12);
}

TEST(Orientations, NotesUnknownUnits)
{
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  lines.emplace_back("space units: \"voxel\" \"voxel\" \"voxel\"");
  EXPECT_EQ(CountOf(NotesOfNrrd(lines), "unit, voxel, is not known"), 1u);
}

TEST(Orientations, LengthsFollowUnitOfMetaImage)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.mha",
           MetaImageBytes("MET_UCHAR", CountingVoxels(),
                          "TransformMatrix = 1 0 0 0 1 0 0 0 1\nElementSpacing = 0.2 0.2 0.2\n"
                          "DistanceUnits = cm\n"));
  const Volume volume = ReadVolume(folder / "a.mha");
  EXPECT_LT((GridOf(volume.Image).Spacing - Vector3(2, 2, 2)).norm(), 1e-12);
  EXPECT_EQ(GridOf(volume.Image).OriginWorld, Vector3(100, 200, 300));
  EXPECT_TRUE(volume.IsOriented);
}

TEST(Orientations, RejectsNonPatientNrrdSpacesByName)
{
  for (const char* space :
       {"3D-left-handed", "3D-left-handed-time", "3D-right-handed-time", "scanner-xyz-time",
        "left-posterior-superior-time", "LPST", "right-anterior-superior-time", "RAST",
        "left-anterior-superior-time", "LAST", "inferior-left-posterior"})
  {
    EXPECT_TRUE(Contains(RefusalOfNrrd(LinesWith(2, std::string("space: ") + space)), space));
  }
}

// The library writes one coordinate per space dimension into arrays of the image's dimension.
TEST(Orientations, RejectsNrrdSpacesOfOtherDimensions)
{
  for (const int dimension : {1, 2, 4, 8})
  {
    const std::string text = std::to_string(dimension);
    EXPECT_TRUE(Contains(RefusalOfNrrd(LinesWith(2, "space dimension: " + text)),
                         "has a space of dimension " + text));
  }
}

TEST(Orientations, RejectsDamagedNrrdDirections)
{
  for (const char* directions :
       {"(2,0,0) (0,2,0)", "(2,0,0) (0,2,0) none", "(2,0) (0,2) (2,2)", "(2,0,0) (0,2,0) (0,0,nan)",
        "(2,0,0) (0,2,0) (0,0,2", "(2,0,0) (0,2,0) (0,0,2,0)"})
  {
    EXPECT_TRUE(Contains(
        RefusalOfNrrd(LinesWith(4, std::string("space directions: ") + directions)), "a.nrrd "))
        << directions;
  }
  EXPECT_TRUE(Contains(RefusalOfNrrd(LinesWith(8, "space origin: (nan,nan,nan)")),
                       "a space origin that is not three finite numbers"));
}
} // namespace
} // namespace palpate::orientations_test
