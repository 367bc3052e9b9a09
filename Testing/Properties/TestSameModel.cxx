// Command line, window, VTK filters and the library for C make the same model of a mask, to the
// last bit. Testing/Python/test_same_model.py compares the program with Python.
#include "FitStructure.h"
#include "ImageWriter.h"
#include "LabelImages.h"
#include "ModelTable.h"
#include "ProofCount.h"
#include "RandomShapes.h"
#include "SegmentationFile.h"
#include "StudyPhantoms.h"
#include "palpate.h"
#include "vtkIcosahedronDirections.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkRadialModelFit.h"
#include "vtkRadialSampler.h"
#include "vtkSegmentationSurface.h"
#include "vtkTable.h"

#include <algorithm>
#include <cstdio>
#include <gtest/gtest.h>
#include <memory>
#include <sstream>

namespace palpate::same_model_test
{
namespace
{
using ModelKind = FitSettings::ModelKind;

std::string TextOf(const std::vector<double>& numbers)
{
  std::string text;
  for (const double number : numbers)
  {
    char digits[40];
    std::snprintf(digits, sizeof(digits), "%a ", number);
    text += digits;
  }
  return text;
}

// Degree, centre and coefficients as hexadecimal floats; a surface model has no centre.
std::string TextOf(const OrganModel& model)
{
  if (const auto* radial = std::get_if<RadialModel>(&model))
  {
    const Vector3& c = radial->CenterWorld();
    return TextOf({c[0], c[1], c[2]}) + TextOf(radial->Coefficients());
  }
  std::vector<double> all;
  const auto& surface = std::get<SurfaceModel>(model);
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& one = surface.Coefficients(axis);
    all.insert(all.end(), one.begin(), one.end());
  }
  return TextOf(all);
}

// A bumpy body on an oblique grid, which may be left-handed and of thick slices; some have a second
// part or a small hole.
void WriteMask(int number, const std::filesystem::path& file)
{
  test::Random random(static_cast<unsigned>(number) + 20);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  test::LabelGrid grid;
  grid.Spacing = {1.0 + 0.5 * uniform(random), 1.3, number % 3 == 0 ? 4.0 : 1.7};
  grid.Size = {36, 33, static_cast<int>(46.0 / grid.Spacing[2])};
  grid.Direction = test::RandomRotation(random);
  if (number % 4 == 1)
  {
    for (const std::size_t entry : {0, 3, 6})
    {
      grid.Direction[entry] *= -1.0;
    }
  }
  grid.CenterOnOrigin();
  const RadialModel body = test::RandomOrgan(random, 4);
  const double scale = 14.0 / body.Radius(Vector3::UnitX());
  const auto isInside = [&](double x, double y, double z)
  {
    const Vector3 at(x, y, z);
    const bool isHole = number % 5 == 2 && (at - Vector3(3.0, 2.0, 1.0)).norm() < 1.1;
    const bool isPart = number % 6 == 4 && (at - Vector3(0.0, 0.0, 17.0)).norm() < 1.6;
    return isPart || (!isHole && at.norm() < scale * body.Radius(at.normalized()));
  };
  WriteImage(file, test::MakeLabelImage(grid, isInside, 1));
}

std::string ByFilters(vtkImageData* image, const FitSettings& settings)
{
  vtkNew<vtkSegmentationSurface> surface;
  surface->SetInputData(image);
  surface->SetCellsOnSurface(12000);
  vtkNew<vtkIcosahedronDirections> directions;
  directions->SetFrequency(settings.Frequency);
  vtkNew<vtkRadialSampler> sampler;
  sampler->SetInputConnection(surface->GetOutputPort());
  sampler->SetDirectionsConnection(directions->GetOutputPort());
  vtkNew<vtkRadialModelFit> fit;
  fit->SetInputConnection(sampler->GetOutputPort());
  fit->SetDegree(settings.Degree);
  fit->Update();
  RadialModel model;
  EXPECT_TRUE(FromTable(fit->GetOutput(), model));
  return TextOf(OrganModel(model));
}

std::string ByLibraryForC(vtkImageData* image, const FitSettings& settings)
{
  double axes[9]; // rows: unit vectors of the grid's axes
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int row = 0; row < 3; ++row)
    {
      axes[3 * axis + row] = image->GetDirectionMatrix()->GetElement(row, axis);
    }
  }
  std::vector<std::uint8_t> inside;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    inside.push_back(image->GetPointData()->GetScalars()->GetTuple1(i) == 1.0 ? 1 : 0);
  }
  palpate_error error{};
  const bool isRadial = settings.Model == ModelKind::Radial;
  const std::unique_ptr<palpate_model, void (*)(palpate_model*)> model(
      palpate_model_fit_mask(inside.data(), image->GetDimensions(), image->GetOrigin(),
                             image->GetSpacing(), axes, settings.Degree, isRadial ? 1 : 0, &error),
      palpate_model_free);
  EXPECT_NE(model, nullptr) << error.text;
  if (model == nullptr)
  {
    return error.text;
  }
  std::vector<double> numbers(palpate_model_coefficients(model.get(), nullptr, 0));
  palpate_model_coefficients(model.get(), numbers.data(), numbers.size());
  if (!isRadial)
  {
    return TextOf(numbers);
  }
  double center[3];
  palpate_model_center(model.get(), center);
  return TextOf({center[0], center[1], center[2]}) + TextOf(numbers);
}

std::string ByWindow(const std::filesystem::path& file, const FitSettings& settings)
{
  StudyState state;
  state.SegmentationFile = file;
  state.Structures.push_back(
      test::StudyPhantom::Structure(1, TouchRepresentation::Automatic, file));
  state.Structures[0].Degree = settings.Degree;
  state.Fit = settings;
  StudyJobs jobs;
  StudyPipeline pipeline(jobs);
  pipeline.Update(state);
  test::Settle(jobs);
  const auto made = pipeline.Newest<FitResult>(SceneStep::Model, 1);
  return made != nullptr ? TextOf(made->Model) : "no model";
}

class SameModel : public testing::TestWithParam<int>
{
};

TEST_P(SameModel, IsMadeByEveryClient)
{
  test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "mask.nii.gz";
  WriteMask(GetParam(), file);
  const Segmentation segmentation = ReadSegmentation(file);
  vtkImageData* image = segmentation.Layers[0];
  for (const ModelKind kind : {ModelKind::Radial, ModelKind::Surface})
  {
    for (const int degree : {4, 8, 12, 16})
    {
      SCOPED_TRACE(std::to_string(static_cast<int>(kind)) + " degree " + std::to_string(degree));
      FitSettings settings;
      settings.Model = kind;
      settings.Degree = degree;
      const FitResult fit = FitStructure(segmentation, segmentation.Find("1"), settings);
      ASSERT_EQ(fit.State, FitResult::Outcome::Fitted) << fit.Message;
      const std::string expected = TextOf(fit.Model);
      EXPECT_EQ(ByLibraryForC(image, settings), expected);
      EXPECT_EQ(ByWindow(file, settings), expected);
      if (kind == ModelKind::Radial) // VTK has no filter for surface models
      {
        EXPECT_EQ(ByFilters(image, settings), expected);
      }
    }
  }
}

// With a hole; with a second part; left-handed with thick slices. Then all twelve.
const int AllMasks[] = {2, 4, 9, 0, 1, 3, 5, 6, 7, 8, 10, 11};

INSTANTIATE_TEST_SUITE_P(Masks, SameModel,
                         testing::ValuesIn(AllMasks, AllMasks + test::ProofCount(3, 12)));
} // namespace
} // namespace palpate::same_model_test
