#include "Coach.h"
#include "CohortWindow.h"
#include "StartPage.h"
#include "StudyThumbnails.h"
#include "WindowTest.h"

#include <QDir>
#include <QKeyEvent>
#include <QScrollBar>
#include <QToolButton>

namespace palpate::start_page_test
{
namespace
{
class StartPageTest : public test::WindowTest
{
protected:
  void SetUp() override
  {
    qputenv("PALPATE_CACHE_DIR", QByteArray::fromStdString(this->Cache.Path().string()));
    test::WindowTest::SetUp();
    if (!IsSkipped())
    {
      this->Page = this->Window->findChild<StartPage*>();
      this->Steps = this->Window->findChild<Coach*>();
    }
  }
  void TearDown() override
  {
    test::WindowTest::TearDown();
    qunsetenv("PALPATE_CACHE_DIR");
  }
  StartTile* Card(const char* key) const
  {
    return this->Page->findChild<StartTile*>(QString("card-") + key);
  }
  void OpenCard(const char* key)
  {
    this->Card(key)->click();
    WaitUntil([this] { return this->Window->Views()->isVisible(); });
  }
  void StartTouch()
  {
    this->Settle();
    this->Action("Start touching")->trigger();
    WaitUntil([this] { return this->Study->IsTouching() || !this->Messages().empty(); });
    ASSERT_TRUE(this->Study->IsTouching()) << this->Messages();
  }
  // Moves the hand until something is true.
  void MoveHand(const Vector3& from, const Vector3& to, const std::function<bool()>& isTrue)
  {
    constexpr double Step = 0.02; // mm a tick
    const std::uint64_t first = this->Study->Reading().Newest.Tick.Number;
    const double length = (to - from).norm();
    this->FeelUntil(
        [&]
        {
          const auto ticks = static_cast<double>(this->Study->Reading().Newest.Tick.Number - first);
          const double part = std::min(1.0, Step * ticks / length);
          this->Study->Current().Touch().MoveHand(from + part * (to - from));
          return isTrue();
        });
  }
  QStringList RecentTitles() const
  {
    QStringList titles;
    for (QWidget* tile : this->Page->findChild<TileGrid*>("start-recent")->Tiles())
    {
      titles += qobject_cast<StartTile*>(tile)->text();
    }
    return titles;
  }

  test::TemporaryFolder Cache;
  StartPage* Page = nullptr;
  Coach* Steps = nullptr;
};

TEST_F(StartPageTest, CardOpensAStudyThatCanBeTouched)
{
  this->OpenCard("prostate");
  EXPECT_FALSE(this->Window->isWindowModified());
  this->StartTouch();
  EXPECT_TRUE(std::filesystem::exists(this->Cache / "samples" / "prostate" / "mask.nii.gz"));
}

TEST_F(StartPageTest, CoachAdvancesByWhatTheUserDoes)
{
  this->OpenCard("prostate");
  ASSERT_TRUE(this->Steps->isVisible());
  EXPECT_EQ(this->Steps->Done(), 0);
  this->StartTouch();
  WaitUntil([this] { return this->Steps->Done() == 1; });
  const Vector3 outside(0.0, -40.0, 0.0);
  const Vector3 deep(0.0, -16.0, 0.0);
  this->MoveHand(outside, deep, [this] { return this->Steps->Done() == 2; });
  const Vector3 hand = this->Study->Current().Touch().HandWorld();
  this->MoveHand(hand, hand + Vector3(14.0, 3.0, 0.0), [this] { return this->Steps->Done() == 3; });
  EXPECT_TRUE(this->Steps->findChild<QLabel*>("coach-3")->text().contains("Esc"));
}

TEST_F(StartPageTest, CoachLetsTheWindowBeSmall)
{
  this->Window->resize(800, 500);
  this->OpenCard("mastoid");
  QApplication::processEvents();
  EXPECT_EQ(this->Window->size(), QSize(800, 500));
  EXPECT_TRUE(this->Steps->findChild<QLabel*>("coach-1")->isVisible());
  EXPECT_FALSE(this->Steps->findChild<QLabel*>("coach-2")->isVisible()) << "there is no room";
  this->Window->resize(1280, 800);
  WaitUntil([this] { return this->Steps->findChild<QLabel*>("coach-2")->isVisible(); });
}

TEST_F(StartPageTest, SceneIsSeenAsAWholeAfterAnother)
{
  this->Window->resize(1280, 800);
  this->OpenCard("prostate");
  this->StartTouch();
  DrawAll(*this->Window->Views());
  this->Study->New();
  this->OpenCard("mastoid");
  this->Settle();
  DrawAll(*this->Window->Views());
  const QRectF view(this->Window->Views()->Space()->Canvas()->rect());
  for (const double side : {-19.0, 19.0})
  {
    EXPECT_TRUE(view.contains(this->PlaceOf({0.0, side, side})));
  }
  const QPointF across = this->PlaceOf({0.0, 19.0, 0.0}) - this->PlaceOf({0.0, -19.0, 0.0});
  EXPECT_GT(std::abs(across.x()), 0.3 * view.height()) << "from its side";
}

TEST_F(StartPageTest, ClosedCoachIsNotShownForThatCardAgain)
{
  this->OpenCard("prostate");
  this->Steps->findChild<QToolButton*>("coach-close")->click();
  EXPECT_FALSE(this->Steps->isVisible());
  this->Study->New();
  this->OpenCard("prostate");
  EXPECT_FALSE(this->Steps->isVisible());
  this->Study->New();
  this->OpenCard("mastoid");
  EXPECT_TRUE(this->Steps->isVisible());
}

TEST_F(StartPageTest, CoachLeavesWithItsScene)
{
  this->OpenCard("mastoid");
  ASSERT_TRUE(this->Steps->isVisible());
  this->Study->New();
  EXPECT_FALSE(this->Steps->isVisible());
}

TEST_F(StartPageTest, ComparisonAsksForTwoMasks)
{
  const auto other = this->Phantom.Folder / "other.nii.gz";
  std::filesystem::copy_file(this->MaskFile(), other);
  this->Opened.clear();
  this->Card("compare")->click();
  EXPECT_TRUE(this->Page->isVisible()) << "the user has cancelled";
  this->Opened = QStringList{QString::fromStdString(this->MaskFile().string()),
                             QString::fromStdString(other.string())};
  this->Card("compare")->click();
  WaitUntil([this] { return this->Window->Views()->isVisible(); });
  EXPECT_EQ(this->Study->State().Structures.size(), 6U);
  EXPECT_FALSE(this->Steps->isVisible());
}

TEST_F(StartPageTest, CohortCardFitsAFolderOfMasks)
{
  const auto folder = this->Phantom.Folder / "masks";
  std::filesystem::create_directory(folder);
  for (const char* name : {"a.nii.gz", "b.nii.gz", "c.nii.gz"})
  {
    std::filesystem::copy_file(this->MaskFile(), folder / name);
  }
  this->Chosen = QString::fromStdString(folder.string());
  this->Card("cohort")->click();
  auto* cohort = this->Window->findChild<CohortWindow*>();
  ASSERT_NE(cohort, nullptr);
  const auto* state = cohort->findChild<QLabel*>("cohort-state");
  WaitUntil([&] { return state->text().startsWith("3 cases"); });
  EXPECT_EQ(cohort->findChild<QTableWidget*>()->rowCount(), 3);
}

TEST_F(StartPageTest, SceneThatCannotBeMadeIsAMessage)
{
  qputenv("PALPATE_CACHE_DIR", "/dev/null/none");
  this->Card("prostate")->click();
  WaitUntil([this] { return !this->Messages().empty(); });
  EXPECT_NE(this->Messages().find("/dev/null/none"), std::string::npos);
  EXPECT_TRUE(this->Page->isVisible());
  EXPECT_FALSE(this->Card("prostate")->ShownText().contains('%'));
}

TEST_F(StartPageTest, TilesAreReachedAndPressedByKeys)
{
  Activate(*this->Window);
  this->Card("prostate")->setFocus();
  QKeyEvent next(QEvent::KeyPress, Qt::Key_Right, Qt::NoModifier);
  QApplication::sendEvent(this->Card("prostate"), &next);
  EXPECT_EQ(QApplication::focusWidget(), this->Card("lesion"));
  this->Card("mastoid")->setFocus();
  QKeyEvent press(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
  QApplication::sendEvent(this->Card("mastoid"), &press);
  WaitUntil([this] { return this->Window->Views()->isVisible(); });
  EXPECT_EQ(this->Study->State().Structures.size(), 3U);
}

TEST_F(StartPageTest, FitsEverySizeWithoutSidewaysScrolling)
{
  for (const QSize& size : {QSize(800, 500), QSize(1280, 800), QSize(1600, 1000)})
  {
    this->Window->resize(size);
    QApplication::processEvents();
    EXPECT_LE(this->Window->width(), size.width());
    for (const char* key : {"prostate", "lesion", "mastoid", "head", "compare", "cohort"})
    {
      const QRect tile(this->Card(key)->mapTo(this->Page->viewport(), QPoint()),
                       this->Card(key)->size());
      EXPECT_GE(tile.left(), 0) << key;
      EXPECT_LE(tile.right(), this->Page->viewport()->width()) << key << size.width();
      EXPECT_GE(tile.width(), 260) << key;
      EXPECT_LE(this->Card("prostate")->mapTo(this->Page->widget(), QPoint()).y(), 180) << "a gap";
    }
  }
  EXPECT_FALSE(this->Page->verticalScrollBar()->isVisible()) << "all of it at once when large";
}

TEST_F(StartPageTest, SavedStudyIsListedWithAPrivatePicture)
{
  this->OpenPhantom();
  const auto file = this->Phantom.Folder / "case.palpate.json";
  const QString name = QString::fromStdString(file.string());
  const QImage plain = StudyThumbnails::PictureOf(name, {64, 48});
  ASSERT_TRUE(this->Study->Save(file));
  const QImage picture = StudyThumbnails::PictureOf(name, {64, 48});
  EXPECT_NE(picture, plain);
  const QDir folder(StudyThumbnails::Folder());
  EXPECT_EQ(folder.entryList(QDir::Files).size(), 1);
  EXPECT_FALSE(folder.entryList(QDir::Files).front().contains("case"));
  EXPECT_EQ(std::filesystem::status(folder.path().toStdString()).permissions(),
            std::filesystem::perms::owner_all);
  QFile::remove(folder.filePath(folder.entryList(QDir::Files).front()));
  this->Study->New();
  EXPECT_EQ(this->RecentTitles().value(0), "case");
  EXPECT_NE(StudyThumbnails::PictureOf(name, {64, 48}), plain) << "it was left";
}
} // namespace
} // namespace palpate::start_page_test
