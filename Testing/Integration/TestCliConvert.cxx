#include "CommandRun.h"
#include "ImageWriter.h"
#include "LabelImages.h"
#include "LabelStatistics.h"
#include "ModelFile.h"
#include "SegmentationFile.h"
#include "SegmentationWriter.h"
#include "SurfaceFile.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"
#include "TestData.h"
#include "TransformFile.h"
#include "VolumeFile.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

namespace palpate::cli_convert_test
{
namespace
{
using namespace palpate::test;

void ExpectRefused(const CommandRun& run, const std::string& name)
{
  EXPECT_EQ(run.Code, 2) << run.Errors;
  EXPECT_EQ(run.Output, "");
  EXPECT_NE(run.Errors.find(name), std::string::npos) << run.Errors;
  EXPECT_EQ(run.Errors.find('\n'), run.Errors.size() - 1) << "more than a sentence: " << run.Errors;
}

TEST(CliConvert, ModelTablesAreWriteOnly)
{
  const TemporaryFolder folder;
  WriteNearlyASphere(folder / "a.json");
  EXPECT_EQ(RunPalpate({"convert", "a.json", "b.csv"}, folder.Path()).Code, 0);
  ExpectRefused(RunPalpate({"convert", "b.csv", "c.json"}, folder.Path()), "use the model.json");
}

TEST(CliConvert, CoefOutputReportsLossUnlessQuiet)
{
  const TemporaryFolder folder;
  WriteNearlyASphere(folder / "a.json");
  EXPECT_NE(RunPalpate({"convert", "a.json", "a.coef"}, folder.Path()).Errors, "");
  EXPECT_EQ(RunPalpate({"convert", "a.json", "a.coef", "--quiet"}, folder.Path()).Errors, "");
}

TEST(CliConvert, RadialAndSurfaceFormsGiveSameSurface)
{
  const TemporaryFolder folder;
  WriteNearlyASphere(folder / "a.json");
  RunPalpate({"convert", "a.json", "a.coef"}, folder.Path());
  RunPalpate({"convert", "a.json", "a.vtp", "--frequency", "6"}, folder.Path());
  RunPalpate({"convert", "a.coef", "b.vtp", "--frequency", "6"}, folder.Path());
  const auto first = ReadSurface(folder / "a.vtp");
  const auto second = ReadSurface(folder / "b.vtp");
  ASSERT_EQ(first->GetNumberOfPoints(), 362);
  ASSERT_EQ(second->GetNumberOfPoints(), 362);
  for (vtkIdType i = 0; i < 362; ++i)
  {
    const Vector3 a(first->GetPoint(i));
    const Vector3 b(second->GetPoint(i));
    ASSERT_LT((a - b).norm(), 1e-5); // either may be drawn in single precision
  }
}

TEST(CliConvert, ModelMeshHasExactCountsOfFrequency)
{
  const TemporaryFolder folder;
  WriteNearlyASphere(folder / "a.json");
  for (const char* name : {"a.vtp", "a.stl", "a.ply", "a.obj"})
  {
    ASSERT_EQ(RunPalpate({"convert", "a.json", name}, folder.Path()).Code, 0) << name;
    EXPECT_EQ(ReadSurface(folder / name)->GetNumberOfPoints(), 4002) << name;
    EXPECT_EQ(ReadSurface(folder / name)->GetNumberOfCells(), 8000) << name;
  }
  for (const char* name : {"a.gltf", "a.glb", "a.x3d"})
  {
    EXPECT_EQ(RunPalpate({"convert", "a.vtp", name}, folder.Path()).Code, 0) << name;
  }
  EXPECT_EQ(folder.EntryCount(), 8u);
}

TEST(CliConvert, ConvertsRealCoefficientFiles)
{
  PALPATE_REQUIRE_FILE(DataPath("spharm_coef/case0_hippoL.coef"));
  const TemporaryFolder folder;
  const CommandRun run = RunPalpate(
      {"convert", DataPath("spharm_coef/case0_hippoL.coef").string(), "a.vtp"}, folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_EQ(ReadSurface(folder / "a.vtp")->GetNumberOfPoints(), 4002);
}

TEST(CliConvert, EveryImageFormatKeepsVoxels)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const auto before = ReadVolume(folder / "a.nii.gz").Image;
  for (const char* name : {"b.nrrd", "c.mha", "d.nii"})
  {
    ASSERT_EQ(RunPalpate({"convert", "a.nii.gz", name}, folder.Path()).Code, 0) << name;
    const auto after = ReadVolume(folder / name).Image;
    ASSERT_EQ(after->GetScalarType(), VTK_UNSIGNED_CHAR) << name;
    EXPECT_EQ(0, std::memcmp(before->GetScalarPointer(), after->GetScalarPointer(),
                             static_cast<std::size_t>(before->GetNumberOfPoints())))
        << name;
  }
}

TEST(CliConvert, WritesSingleLabelAsBinaryMask)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  ASSERT_EQ(RunPalpate({"convert", "a.nii.gz", "b.nrrd", "--label", "2"}, folder.Path()).Code, 0);
  const auto before = ReadVolume(folder / "a.nii.gz").Image;
  const auto after = ReadVolume(folder / "b.nrrd").Image;
  for (vtkIdType i = 0; i < before->GetNumberOfPoints(); ++i)
  {
    const auto* label = static_cast<unsigned char*>(before->GetScalarPointer()) + i;
    const auto* mask = static_cast<unsigned char*>(after->GetScalarPointer()) + i;
    ASSERT_EQ(*mask, *label == 2 ? 1 : 0);
  }
}

TEST(CliConvert, SlicerSegmentationKeepsSegmentsAndTheirNames)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  ASSERT_EQ(RunPalpate({"convert", "a.nii.gz", "b.seg.nrrd"}, folder.Path()).Code, 0);
  Segmentation both = ReadSegmentation(folder / "b.seg.nrrd");
  ASSERT_EQ(both.Segments.size(), 2U);
  both.Segments[1].Name = "small one";
  WriteSegmentation(folder / "b.seg.nrrd", both);
  const CommandRun run =
      RunPalpate({"convert", "b.seg.nrrd", "c.seg.nrrd", "--label", "small one"}, folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  const Segmentation one = ReadSegmentation(folder / "c.seg.nrrd");
  ASSERT_EQ(one.Segments.size(), 1U);
  EXPECT_EQ(one.Segments[0].Name, "small one");
  EXPECT_EQ(MeasureLabels(one)[0].Voxels, MeasureLabels(both)[1].Voxels);
}

TEST(CliConvert, NamesAndColoursSurviveNiftiAndItkSnapTables)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  RunPalpate({"convert", "a.nii.gz", "b.seg.nrrd"}, folder.Path());
  Segmentation named = ReadSegmentation(folder / "b.seg.nrrd");
  named.Segments[0].Name = "big <one>";
  named.Segments[1].Name = "small";
  named.Segments[1].Color = {0.0, 1.0, 0.2};
  WriteSegmentation(folder / "b.seg.nrrd", named);
  ASSERT_EQ(RunPalpate({"convert", "b.seg.nrrd", "c.nii.gz"}, folder.Path()).Code, 0);
  ASSERT_EQ(RunPalpate({"convert", "c.nii.gz", "d.nii"}, folder.Path()).Code, 0);
  ASSERT_EQ(RunPalpate({"convert", "c.nii.gz", "e.mha"}, folder.Path()).Code, 0);
  ASSERT_EQ(RunPalpate({"convert", "c.nii.gz", "e.txt"}, folder.Path()).Code, 0);
  for (const char* name : {"c.nii.gz", "d.nii", "e.mha"})
  {
    const Segmentation read = ReadSegmentation(folder / name);
    EXPECT_EQ(read.Segments[0].Name, "big <one>") << name;
    EXPECT_EQ(read.Segments[1].Name, "small") << name;
    EXPECT_EQ(read.Segments[1].Color, named.Segments[1].Color) << name;
  }
}

TEST(CliConvert, DicomNeedsItsSourceSeries)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  WriteNearlyASphere(folder / "a.json");
  ExpectRefused(RunPalpate({"convert", "a.nii.gz", "b.dcm"}, folder.Path()), "--source");
  ExpectRefused(RunPalpate({"convert", "a.json", "b.dcm"}, folder.Path()), "--source");
  ExpectRefused(RunPalpate({"convert", "a.nii.gz", "b.mha", "--source", "."}, folder.Path()),
                "named .dcm");
  ExpectRefused(
      RunPalpate({"convert", "a.json", "b.dcm", "--source", ".", "--contours"}, folder.Path()),
      "--contours needs a segmentation");
  ExpectRefused(RunPalpate({"convert", "a.nii.gz", "b.dcm", "--source", "none"}, folder.Path()),
                "none");
  EXPECT_EQ(folder.EntryCount(), 2u);
}

TEST(CliConvert, RealLiverGoesBackToItsSeries)
{
  const std::string series = DataPath("dicom_seg/ct_3slice").string();
  PALPATE_REQUIRE_FILE(series);
  const TemporaryFolder folder;
  const std::string liver = DataPath("dicom_seg/liver.dcm").string();
  std::filesystem::copy(series, folder / "series");
  ASSERT_EQ(RunPalpate({"convert", liver, "l.seg.nrrd"}, folder.Path()).Code, 0);
  ASSERT_EQ(RunPalpate({"convert", liver, "l.nii.gz"}, folder.Path()).Code, 0);
  for (const std::string name : {"l.seg.nrrd", "l.nii.gz"})
  {
    ASSERT_EQ(RunPalpate({"convert", name, "a.dcm", "--source", series}, folder.Path()).Code, 0);
    ASSERT_EQ(RunPalpate({"convert", name, "series/rs.dcm", "--source", "series", "--contours"},
                         folder.Path())
                  .Code,
              0);
    for (const char* made : {"a.dcm", "series/rs.dcm"})
    {
      const Segmentation read = ReadSegmentation(folder / made);
      EXPECT_EQ(read.Segments[0].Name, "Liver");
      EXPECT_EQ(MeasureLabels(read)[0].Voxels, 107098) << made;
    }
    EXPECT_EQ(ReadSegmentation(folder / "a.dcm").Segments[0].Codes.Type.Value,
              name == "l.nii.gz" ? "10200004" : "T-62000");
    std::filesystem::remove(folder / "series/rs.dcm");
  }
}

TEST(CliConvert, UnknownEndingListsThoseThatAreWritten)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const CommandRun run = RunPalpate({"convert", "a.nii.gz", "b.foo"}, folder.Path());
  ExpectRefused(run, "b.foo");
  for (const char* ending : {".nii.gz", ".seg.nrrd", ".dcm", ".txt"})
  {
    EXPECT_NE(run.Errors.find(ending), std::string::npos) << ending;
  }
}

TEST(CliConvert, MissingLabelListsExistingLabels)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const CommandRun run =
      RunPalpate({"convert", "a.nii.gz", "b.nrrd", "--label", "7"}, folder.Path());
  ExpectRefused(run, "a.nii.gz");
  EXPECT_NE(run.Errors.find('1'), std::string::npos);
  EXPECT_NE(run.Errors.find('2'), std::string::npos);
}

TEST(CliConvert, RejectsIncompatibleInputAndOutput)
{
  const TemporaryFolder folder;
  WriteNearlyASphere(folder / "a.json");
  WriteTwoSpheres(folder / "a.nii.gz");
  WriteAll(folder / "bad.json", "{\"format\": 3}");
  WriteAll(folder / "bad.nii.gz", "no image");
  WriteAll(folder / "bad.stl", "no surface");
  ExpectRefused(RunPalpate({"convert", "none.json", "b.csv"}, folder.Path()), "none.json");
  ExpectRefused(RunPalpate({"convert", "bad.json", "b.csv"}, folder.Path()), "bad.json");
  ExpectRefused(RunPalpate({"convert", "bad.nii.gz", "b.nrrd"}, folder.Path()), "bad.nii.gz");
  ExpectRefused(RunPalpate({"convert", "bad.stl", "b.vtp"}, folder.Path()), "bad.stl");
  ExpectRefused(RunPalpate({"convert", "a.json", "b.nii.gz"}, folder.Path()), "b.nii.gz");
  ExpectRefused(RunPalpate({"convert", "a.nii.gz", "b.stl"}, folder.Path()), "b.stl");
  ExpectRefused(RunPalpate({"convert", "a.json", "b.stl", "--label", "1"}, folder.Path()),
                "--label needs a segmentation");
  ExpectRefused(RunPalpate({"convert", "a.json", "no/b.csv"}, folder.Path()), "no/b.csv");
  EXPECT_EQ(folder.EntryCount(), 5u);
}

TEST(CliConvert, ChoosesSeriesOfMixedDicomFolderByNumber)
{
  PALPATE_REQUIRE_FILE(DataPath("prostate/dicom_localizer_three_planes"));
  const TemporaryFolder folder;
  const std::string input = DataPath("prostate/dicom_localizer_three_planes").string();
  const CommandRun mixed = RunPalpate({"convert", input, "a.nrrd"}, folder.Path());
  EXPECT_EQ(mixed.Code, 2);
  EXPECT_NE(mixed.Errors.find("--series"), std::string::npos) << mixed.Errors;
  EXPECT_EQ(folder.EntryCount(), 0u);
  const CommandRun chosen =
      RunPalpate({"convert", input, "a.nrrd", "--series", "2"}, folder.Path());
  EXPECT_EQ(chosen.Code, 0) << chosen.Errors;
}

TEST(CliConvert, FolderOfMasksBecomesOneNamedSegmentation)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "masks");
  WriteEllipsoid(folder / "masks/liver.nii.gz", 12.0, 9.0, 8.0);
  WriteEllipsoid(folder / "masks/none.nii.gz", 0.0, 0.0, 0.0); // empty
  WriteEllipsoid(folder / "masks/spleen.nii.gz", 9.0, 9.0, 8.0);
  WriteTwoSpheres(folder / "masks/zother.nii.gz"); // on another grid
  const CommandRun run = RunPalpate({"convert", "masks", "all.seg.nrrd"}, folder.Path());
  EXPECT_EQ(run.Code, 1) << run.Errors;
  EXPECT_NE(run.Errors.find("none.nii.gz"), std::string::npos);
  EXPECT_NE(run.Errors.find("lies on another grid"), std::string::npos);
  const Segmentation all = ReadSegmentation(folder / "all.seg.nrrd");
  ASSERT_EQ(all.Segments.size(), 2u);
  EXPECT_EQ(all.Segments[0].Name, "liver");
  EXPECT_EQ(all.Segments[1].Name, "spleen");
  const vtkIdType liver =
      MeasureLabels(ReadSegmentation(folder / "masks/liver.nii.gz")).at(0).Voxels;
  EXPECT_EQ(MeasureLabels(all).at(0).Voxels, liver);
}

TEST(CliConvert, MasksThatShareNoVoxelShareLabelMap)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "masks");
  WriteTwoSpheres(folder / "two.nii.gz");
  for (const char* label : {"1", "2"})
  {
    RunPalpate(
        {"convert", "two.nii.gz", std::string("masks/part") + label + ".nrrd", "--label", label},
        folder.Path());
  }
  ASSERT_EQ(RunPalpate({"convert", "masks", "all.nii.gz"}, folder.Path()).Code, 0);
  const auto before = MeasureLabels(ReadSegmentation(folder / "two.nii.gz"));
  const auto after = MeasureLabels(ReadSegmentation(folder / "all.nii.gz"));
  ASSERT_EQ(after.size(), 2u);
  EXPECT_EQ(after[0].Voxels, before[0].Voxels);
  EXPECT_EQ(after[1].Voxels, before[1].Voxels);
}

TEST(CliConvert, ThresholdBackgroundAndResampleMendWhatIsRefused)
{
  const TemporaryFolder folder;
  WriteGradedSphere(folder / "p.nii.gz");
  const CommandRun refused = RunPalpate({"convert", "p.nii.gz", "m.nii.gz"}, folder.Path());
  ExpectRefused(refused, "--background nan");
  EXPECT_EQ(
      RunPalpate({"convert", "p.nii.gz", "m.nii.gz", "--threshold", "0.5"}, folder.Path()).Code, 0);
  EXPECT_EQ(ReadSegmentation(folder / "m.nii.gz").Segments.size(), 1u);
  EXPECT_EQ(
      RunPalpate({"convert", "p.nii.gz", "v.nii.gz", "--background", "-1,nan"}, folder.Path()).Code,
      0);
  EXPECT_EQ(ReadVolume(folder / "v.nii.gz").Image->GetScalarComponentAsDouble(0, 0, 0, 0), 0.0);
  const auto sheared = DataPath("odd/nii_nonorth_0.2.nii.gz");
  PALPATE_REQUIRE_FILE(sheared);
  ExpectRefused(RunPalpate({"convert", sheared, "u.nii.gz"}, folder.Path()), "--resample");
  EXPECT_EQ(RunPalpate({"convert", sheared, "u.nii.gz", "--resample"}, folder.Path()).Code, 0);
  EXPECT_EQ(ReadSegmentation(folder / "u.nii.gz").Segments.size(), 1u);
}

// A turn by 30 degrees about z, and a shift.
Eigen::Affine3d Turned()
{
  return Eigen::Translation3d(30.0, -10.0, 20.0) *
         Eigen::Affine3d(Eigen::AngleAxisd(M_PI / 6.0, Vector3::UnitZ()));
}

Vector3 MiddleOf(const std::filesystem::path& mask)
{
  const Segmentation read = ReadSegmentation(mask);
  vtkImageData* image = read.Layers.front();
  Vector3 sum = Vector3::Zero();
  double count = 0.0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    if (image->GetPointData()->GetScalars()->GetTuple1(i) > 0.0)
    {
      sum += Vector3(image->GetPoint(i));
      ++count;
    }
  }
  return sum / count;
}

TEST(CliConvert, TransformMovesMasksSurfacesAndModelsAlike)
{
  const TemporaryFolder folder;
  WriteEllipsoid(folder / "mask.nii.gz", 12.0, 9.0, 8.0);
  WriteNearlyASphere(folder / "model.json");
  WriteTransform(folder / "t.tfm", Turned());
  const auto run = [&folder](std::vector<std::string> words)
  {
    words.insert(words.begin(), "convert");
    words.insert(words.end(), {"--transform", "t.tfm"});
    const CommandRun done = RunPalpate(words, folder.Path());
    EXPECT_EQ(done.Code, 0) << done.Errors;
  };
  run({"mask.nii.gz", "moved.nii.gz"});
  const Vector3 there = Turned() * MiddleOf(folder / "mask.nii.gz");
  EXPECT_LT((MiddleOf(folder / "moved.nii.gz") - there).norm(), 1e-3); // single precision
  run({"mask.nii.gz", "resampled.nii.gz", "--reference", "moved.nii.gz"});
  EXPECT_LT((MiddleOf(folder / "resampled.nii.gz") - there).norm(), 0.1); // of nearest voxels
  run({"model.json", "moved.json"});
  const OrganModel moved = ReadModel(folder / "moved.json").Surface;
  EXPECT_LT((CenterOf(moved) - Turned() * NearlyASphere().CenterWorld()).norm(), 0.1);
  RunPalpate({"convert", "model.json", "a.vtp"}, folder.Path());
  run({"a.vtp", "b.vtp"});
  const auto before = ReadSurface(folder / "a.vtp");
  const auto after = ReadSurface(folder / "b.vtp");
  const Vector3 point(before->GetPoint(7));
  EXPECT_LT((Turned() * point - Vector3(after->GetPoint(7))).norm(), 1e-4);
}

TEST(CliConvert, TransformsThatNeedReferenceOrMissTheImageAreRefused)
{
  const TemporaryFolder folder;
  WriteEllipsoid(folder / "mask.nii.gz", 12.0, 9.0, 8.0);
  WriteTransform(folder / "large.tfm", Eigen::Affine3d(Vector3(1.1, 1.0, 1.0).asDiagonal()));
  WriteTransform(folder / "far.tfm", Eigen::Affine3d(Eigen::Translation3d(900.0, 0.0, 0.0)));
  WriteTransform(folder / "mirror.tfm", Eigen::Affine3d(Vector3(-1.0, 1.0, 1.0).asDiagonal()));
  const auto refusal = [&folder](std::vector<std::string> words)
  {
    words.insert(words.begin(), {"convert", "mask.nii.gz", "a.seg.nrrd"});
    return RunPalpate(words, folder.Path());
  };
  ExpectRefused(refusal({"--transform", "large.tfm"}), "--reference");
  ExpectRefused(refusal({"--transform", "mirror.tfm"}), "mirrors");
  ExpectRefused(refusal({"--transform", "far.tfm", "--reference", "mask.nii.gz"}), "no structure");
  ExpectRefused(refusal({"--reference", "mask.nii.gz"}), "needs --transform");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.seg.nrrd"));
}

TEST(CliConvert, LabelIsChosenBeforeItMoves)
{
  const TemporaryFolder folder;
  const auto mask = MakeLabelImage({}, [](double x, double, double) { return x < 10.0; });
  vtkDataArray* labels = mask->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < mask->GetNumberOfPoints(); ++i)
  {
    labels->SetTuple1(i, mask->GetPoint(i)[0] > 22.0 ? 2.0 : labels->GetTuple1(i));
  }
  WriteImage(folder / "mask.nii.gz", mask);
  WriteTransform(folder / "t.tfm", Eigen::Affine3d(Eigen::Translation3d(15.0, 0.0, 0.0)));
  const auto convert = [&folder](const char* label)
  {
    return RunPalpate({"convert", "mask.nii.gz", "a.nii.gz", "--label", label, "--transform",
                       "t.tfm", "--reference", "mask.nii.gz"},
                      folder.Path());
  };
  ExpectRefused(convert("2"), "no structure within");
  EXPECT_EQ(convert("1").Code, 0);
}
} // namespace
} // namespace palpate::cli_convert_test
