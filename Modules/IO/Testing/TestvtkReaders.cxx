#include "ImageGrid.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "vtkSegmentationReader.h"

#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTestErrorObserver.h"

#include <gtest/gtest.h>
#include <sstream>

namespace palpate::vtk_readers_test
{
namespace
{
using namespace palpate::test;

// Axes rotated by a quarter turn about z: x runs to P, y to R.
std::string TurnedNrrd(const std::string& voxels)
{
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  lines[4] = "space directions: (0,2,0) (-2,0,0) (0,0,2)";
  return NrrdBytes(lines, voxels);
}

std::string MirroredNrrd()
{
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  lines[4] = "space directions: (2,0,0) (0,-2,0) (0,0,2)";
  return NrrdBytes(lines, std::string(120, '\1'));
}

// Errors that a reader and its executive report.
struct ErrorWatch
{
  explicit ErrorWatch(vtkAlgorithm* algorithm)
  {
    algorithm->AddObserver(vtkCommand::ErrorEvent, this->Own);
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Executive);
  }
  vtkNew<vtkTest::ErrorObserver> Own;
  vtkNew<vtkTest::ErrorObserver> Executive;
};

TEST(vtkSegmentationReader, OutputAndInformationHaveDirection)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.nrrd", TurnedNrrd(std::string(120, '\1')));
  vtkNew<vtkSegmentationReader> reader;
  reader->SetFileName((folder / "a.nrrd").c_str());
  reader->UpdateInformation();
  const double* direction = reader->GetOutputInformation(0)->Get(vtkDataObject::DIRECTION());
  ASSERT_NE(direction, nullptr);
  EXPECT_EQ(direction[1], -1.0);
  EXPECT_EQ(direction[3], 1.0);
  reader->Update();
  EXPECT_EQ(GridOf(reader->GetOutput()).Direction.col(0), Vector3(0, 1, 0));
  EXPECT_EQ(GridOf(reader->GetOutput()).OriginWorld, Vector3(10, 20, 30));
  EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(3, 4, 5, 0), 1.0);
  EXPECT_STREQ(reader->GetOutput()->GetPointData()->GetScalars()->GetName(), "Labels");
}

TEST(vtkSegmentationReader, BadFileRaisesErrorAndNextNameRecovers)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.nrrd", TurnedNrrd(std::string(120, '\1')));
  vtkNew<vtkSegmentationReader> reader;
  const ErrorWatch errors(reader);
  reader->SetFileName("/no/such/file.nrrd");
  reader->Update();
  EXPECT_NE(
      errors.Own->GetErrorMessage().find("/no/such/file.nrrd does not exist; check the path."),
      std::string::npos);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
  reader->SetFileName((folder / "a.nrrd").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 120);
}

TEST(vtkSegmentationReader, LeftHandedFileIsReversedUnlessRefused)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.nrrd", MirroredNrrd());
  vtkNew<vtkSegmentationReader> reader;
  const ErrorWatch errors(reader);
  reader->SetFileName((folder / "a.nrrd").c_str());
  reader->Update();
  ASSERT_EQ(errors.Own->GetErrorMessage(), "");
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 120);
  EXPECT_EQ(GridOf(reader->GetOutput()).OriginWorld, Vector3(10, 12, 30));
  ASSERT_EQ(reader->GetNumberOfNotes(), 1);
  EXPECT_NE(std::string(reader->GetNote(0)).find("index axis 2 was reversed"), std::string::npos);
  reader->RefuseLeftHandedOn();
  reader->Update();
  EXPECT_NE(errors.Own->GetErrorMessage().find("left-handed"), std::string::npos);
}

TEST(vtkSegmentationReader, ProvidesLayersAndSegments)
{
  const TemporaryFolder folder;
  DicomSegmentationSpec spec;
  spec.Segments = {{1, "a"}, {2, "b"}};
  const std::vector<int> full(12, 1);
  spec.Frames = {{1, 0.0, full}, {2, 0.0, full}, {2, 3.0, full}};
  WriteDicomSegmentation(folder / "a.dcm", spec);
  vtkNew<vtkSegmentationReader> reader;
  reader->SetFileName((folder / "a.dcm").c_str());
  reader->Update();
  ASSERT_EQ(reader->GetNumberOfLayers(), 2);
  ASSERT_EQ(reader->GetNumberOfSegments(), 2);
  EXPECT_STREQ(reader->GetSegmentName(1), "b");
  EXPECT_EQ(reader->GetSegmentLabel(1), 2);
  EXPECT_EQ(reader->GetSegmentValue(1), 2);
  EXPECT_EQ(reader->GetSegmentLayer(1), 1);
  EXPECT_EQ(reader->GetSegmentLabel(2), -1);
  EXPECT_EQ(reader->GetSegmentName(-1), nullptr);
  EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(0, 0, 0, 0), 1.0);
  reader->SetLayer(1);
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(0, 0, 0, 0), 2.0);
}

TEST(vtkSegmentationReader, MissingLayerIsError)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.nrrd", TurnedNrrd(std::string(120, '\1')));
  vtkNew<vtkSegmentationReader> reader;
  const ErrorWatch errors(reader);
  reader->SetFileName((folder / "a.nrrd").c_str());
  reader->SetLayer(1);
  reader->Update();
  EXPECT_NE(errors.Own->GetErrorMessage().find("has no layer 1"), std::string::npos);
}

TEST(vtkSegmentationReader, PrintSelfNamesTheFile)
{
  vtkNew<vtkSegmentationReader> reader;
  reader->SetFileName("x.nii");
  std::ostringstream text;
  reader->Print(text);
  EXPECT_NE(text.str().find("FileName: x.nii"), std::string::npos);
}
} // namespace
} // namespace palpate::vtk_readers_test
