#include "DisplayTest.h"
#include "StudyFile.h"
#include "StudyPhantoms.h"
#include "StudyRecovery.h"
#include "WholeFile.h"

#include <QCoreApplication>
#include <QProcess>
#include <QProcessEnvironment>

#include <gtest/gtest.h>

namespace palpate::viewer_recovery_test
{
namespace
{
class ViewerRecoveryTest : public test::DisplayTest
{
protected:
  // The window of a saved study, which a file of landmarks then changes.
  void Start()
  {
    WriteStudy(this->Session, this->Phantom.State());
    const auto marks = this->Phantom.Folder / "marks.mrk.json";
    WriteWholeFile(marks, R"({"markups": [{"type": "Fiducial", "coordinateSystem": "LPS",
      "controlPoints": [{"label": "apex", "position": [1.5, -2.25, 3.0]}]}]})");
    std::filesystem::create_directories(this->Phantom.Folder / "Palpate");
    WriteWholeFile(this->Phantom.Folder / "Palpate" / "palpate-viewer.conf",
                   "[General]\nrecovery-seconds=1\n");
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("XDG_CONFIG_HOME", QString::fromStdString(this->Phantom.Folder.Path()));
    environment.insert("XDG_DATA_HOME", QString::fromStdString(this->Data));
    this->Viewer.setProcessEnvironment(environment);
    this->Viewer.setProcessChannelMode(QProcess::ForwardedChannels);
    this->Viewer.start(PALPATE_VIEWER,
                       {QString::fromStdString(this->Session), QString::fromStdString(marks)});
    ASSERT_TRUE(this->Viewer.waitForStarted(-1));
  }
  // The folder in which a study is kept; empty if there is none.
  std::filesystem::path Kept() const
  {
    std::error_code failure;
    const std::filesystem::path root = this->Data / "Palpate" / "palpate-viewer" / "recovery";
    for (const auto& folder : std::filesystem::directory_iterator(root, failure))
    {
      if (std::filesystem::exists(RecoverySession(folder.path())))
      {
        return folder.path();
      }
    }
    return {};
  }
  void WaitUntilKept()
  {
    while (this->Kept().empty() && !this->Viewer.waitForFinished(20))
    {
    }
    ASSERT_EQ(this->Viewer.state(), QProcess::Running);
  }

  // For QProcess.
  char Name[12] = "ViewerTests";
  char* Arguments[2] = {Name, nullptr};
  int Count = 1;
  QCoreApplication Program{Count, Arguments};
  test::StudyPhantom Phantom;
  std::filesystem::path Session = Phantom.Folder / "case.palpate.json";
  std::filesystem::path Data = Phantom.Folder / "data";
  QProcess Viewer;
};

TEST_F(ViewerRecoveryTest, KilledWindowLeavesItsChangesAndItsFile)
{
  ASSERT_NO_FATAL_FAILURE(this->Start());
  ASSERT_NO_FATAL_FAILURE(this->WaitUntilKept());
  this->Viewer.kill();
  ASSERT_TRUE(this->Viewer.waitForFinished(-1));
  const RecoveredStudy kept = ReadRecovery(this->Kept());
  ASSERT_EQ(kept.State.Landmarks.size(), 1U);
  EXPECT_EQ(kept.State.Landmarks[0].PositionWorld, Vector3(1.5, -2.25, 3.0));
  EXPECT_EQ(kept.FormerFile, this->Session);
  EXPECT_EQ(ReadStudy(this->Session).Landmarks.size(), 0U);
}

TEST_F(ViewerRecoveryTest, TerminatedWindowLeavesItsChangesToo)
{
  ASSERT_NO_FATAL_FAILURE(this->Start());
  ASSERT_NO_FATAL_FAILURE(this->WaitUntilKept());
  this->Viewer.terminate();
  ASSERT_TRUE(this->Viewer.waitForFinished(-1));
  EXPECT_EQ(ReadRecovery(this->Kept()).State.Landmarks.size(), 1U);
}
} // namespace
} // namespace palpate::viewer_recovery_test
