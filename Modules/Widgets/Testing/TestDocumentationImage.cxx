#include "BaselineImage.h"
#include "TestData.h"
#include "WidgetImage.h"
#include "WindowTest.h"

#include <QStyleFactory>

#include <set>

namespace palpate::documentation_image_test
{
namespace
{
const std::filesystem::path Head = "/usr/share/mricron/templates/ch2.nii.gz";
const std::filesystem::path Labels = "/usr/share/mricron/templates/aal.nii.gz";

using WindowImages = test::WindowTest;

// The window's image in the documentation: in Qt's own style, so that it looks the same wherever
// the test runs.
TEST_F(WindowImages, WindowShowsHeadAndModels)
{
  PALPATE_REQUIRE_FILE(Head);
  PALPATE_REQUIRE_FILE(Labels);
  if (!test::HasBaselineRows)
  {
    GTEST_SKIP() << "the picture is of Qt 5, whose rows are higher than those of Qt 6";
  }
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  this->Window->resize(1280, 800);
  this->Study->OpenVolume(Head);
  this->Study->OpenSegmentation(Labels);
  WaitUntil([this] { return !this->Study->State().Structures.empty(); });
  StudyState next = this->Study->State();
  const std::set<std::string> shown{"Thalamus_L", "Thalamus_R", "Pallidum_L", "Amygdala_R"};
  auto& all = next.Structures;
  all.erase(std::remove_if(all.begin(), all.end(),
                           [&](const SceneStructure& one) { return shown.count(one.Name) == 0; }),
            all.end());
  for (SceneStructure& structure : all)
  {
    structure.IsVisible = true;
    structure.IsTouchable = true;
  }
  this->Study->Change("Choose structures", next);
  this->Settle();
  // Now, since the camera is placed when the structures are there.
  auto view = this->Study->State().View;
  view.CrosshairWorld = Vector3(12.0, 18.0, 6.0);
  this->Study->ChangeView(view);
  this->Settle();
  this->Window->Messages()->Clear();
  DrawAll(*this->Window->Views());
  test::ExpectLikeBaseline(test::ImageOf(*this->Window),
                           std::filesystem::path(PALPATE_DOCUMENTATION_IMAGES) / "viewer.png");
}
} // namespace
} // namespace palpate::documentation_image_test
