#include "CommaLocale.h"
#include "FractionalImages.h"
#include "ImageGrid.h"
#include "Volume.h"
#include "WindowTest.h"

#include <clocale>

namespace palpate::application_test
{
namespace
{
// A window of a user with a decimal comma. The environment is set before the application, of which
// a program has only one: hence a separate program.
class ApplicationTest : public test::WindowTest
{
protected:
  void SetUp() override
  {
    static const test::CommaEnvironment environment;
    WindowTest::SetUp();
  }

  ImageGrid GridOfOpened(const std::filesystem::path& file)
  {
    this->Study->New();
    this->Window->Messages()->Clear();
    this->Study->OpenVolume(file);
    WaitUntil([this] { return this->OpenedVolume() != nullptr || !this->Messages().empty(); });
    return this->OpenedVolume() != nullptr ? GridOf(this->OpenedVolume()->Image) : ImageGrid();
  }

private:
  std::shared_ptr<const Volume> OpenedVolume() const
  {
    return this->Study->Current().Pipeline().Newest<Volume>(SceneStep::Volume);
  }
};

TEST_F(ApplicationTest, KeepsNumericCLocale)
{
  EXPECT_STREQ(std::setlocale(LC_NUMERIC, nullptr), "C");
  EXPECT_STREQ(std::setlocale(LC_CTYPE, nullptr), test::CommaLocaleName())
      << "the user's elsewhere";
}

TEST_F(ApplicationTest, ReadsFractionsOfMillimetres)
{
  const test::TemporaryFolder folder;
  test::WriteFractionalImages(folder.Path());
  for (const char* name : {"a.nii", "a.seg.nrrd", "a.mha"})
  {
    const ImageGrid grid = this->GridOfOpened(folder / name);
    EXPECT_EQ(grid.Spacing, test::FractionalSpacing()) << name;
    EXPECT_EQ(grid.OriginWorld, test::FractionalOrigin()) << name;
  }
  EXPECT_EQ(this->GridOfOpened(folder / "b.nrrd").Spacing, test::FractionalSpacing());
  const ImageGrid dicom = this->GridOfOpened(folder / "dicom/0.dcm");
  EXPECT_EQ(dicom.Spacing, Vector3(2.0, 1.5, 3.25));
  EXPECT_EQ(dicom.OriginWorld, test::FractionalOrigin());
}
} // namespace
} // namespace palpate::application_test
