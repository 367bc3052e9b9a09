#include "StudyFiles.h"

#include "ModelFile.h"
#include "SceneFile.h"
#include "StudyPhantoms.h"
#include "TouchRun.h"

#include <gtest/gtest.h>

namespace palpate::study_files_test
{
namespace
{
// Every representation, and landmarks.
TEST(StudyFiles, WrittenProductsCanBeTouchedAgain)
{
  const test::StudyPhantom phantom;
  StudyState state = phantom.State();
  state.Structures = {
      test::StudyPhantom::Structure(1, TouchRepresentation::Automatic, state.SegmentationFile),
      test::StudyPhantom::Structure(2, TouchRepresentation::Facets, state.SegmentationFile)};
  state.Structures[1].Name = "bow";
  state.Structures[1].Stiffness = 0.25;
  state.Landmarks.push_back({"apex", Vector3(1.0, 2.0, 3.0)});
  StudyJobs jobs;
  StudyPipeline pipeline(jobs);
  pipeline.Update(state);
  test::Settle(jobs);
  const auto out = phantom.Folder / "out";
  WriteStudyFiles(state, pipeline, out, "test");

  const auto fit = pipeline.Newest<FitResult>(SceneStep::Model, 1);
  const ModelDocument document = ReadModel(out / "mask_1/model.json");
  EXPECT_EQ(std::get<RadialModel>(document.Surface).Coefficients(), fit->Radial()->Coefficients());
  for (const char* name : {"mask_1/report.html", "mask_2_bow/surface.vtp", "markups.csv",
                           "markups.mrk.json", "scene.json"})
  {
    EXPECT_TRUE(std::filesystem::exists(out / name)) << name;
  }
  const PreparedTouch touch = PrepareTouch(ReadScene(out / "scene.json"), {},
                                           [](double, const std::string&) { return true; });
  ASSERT_EQ(touch.Structures.size(), 2U);
  for (std::size_t s = 0; s < 2; ++s)
  {
    const auto contact = pipeline.Newest<TouchContact>(SceneStep::Touch, state.Structures[s].Id);
    EXPECT_EQ(touch.Structures[s].Represented, contact->Represented);
    EXPECT_EQ(touch.Structures[s].Touch.Law.Stiffness, state.Structures[s].Stiffness);
  }
}
} // namespace
} // namespace palpate::study_files_test
