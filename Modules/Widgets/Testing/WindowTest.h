#pragma once

#include "PacedClock.h"
#include "StudyPhantoms.h"
#include "WidgetTest.h"

#include <QAction>
#include <QPushButton>

#include <memory>
#include <stdexcept>

namespace palpate::test
{
inline double Norm(const PlainVector3& vector)
{
  return Vector3(vector).norm();
}

/// A window with a phantom, whose questions the test answers.
class WindowTest : public WidgetTest
{
protected:
  void SetUp() override
  {
    WidgetTest::SetUp();
    if (IsSkipped())
    {
      return;
    }
    QSettings().clear();
    RealtimeRequest ordinary;
    ordinary.Priority = 0;
    this->Study = std::make_unique<StudyController>(*this->Time, ordinary);
    FileQuestions questions;
    questions.ToOpen = [this](QWidget*, const QString&, const QString&) { return this->Opened; };
    questions.ToSave = [this](QWidget*, const QString&, const QString&, const QString&)
    { return this->SavedTo; };
    questions.Folder = [this](QWidget*, const QString&) { return this->Chosen; };
    questions.Series = [this](QWidget*, const std::vector<DicomSeriesChoice>& series)
    {
      this->SeriesOffered.clear();
      for (const DicomSeriesChoice& one : series)
      {
        this->SeriesOffered += QString::fromStdString(one.Text());
      }
      return this->Series;
    };
    questions.Missing = [this](QWidget*, const StudyMissingFile& missing)
    {
      this->AskedFor.push_back(missing);
      return this->Found;
    };
    questions.WhetherToSave = [this](QWidget*)
    {
      ++this->TimesAskedToSave;
      return this->Leaving;
    };
    questions.WhetherToDelete = [this](QWidget*, const QString& title)
    {
      this->ToDelete = title;
      return this->MayDelete;
    };
    this->Window = std::make_unique<MainWindow>(*this->Study, questions);
    this->Window->resize(1000, 700);
    this->Window->show();
    QApplication::processEvents();
  }
  void TearDown() override
  {
    if (this->Study != nullptr)
    {
      this->Study->Close();
    }
    this->Window.reset();
  }

  std::filesystem::path VolumeFile() const { return this->Phantom.Folder / "volume.nii.gz"; }
  std::filesystem::path MaskFile() const { return this->Phantom.Folder / "mask.nii.gz"; }
  /// Waits until everything that the study needs is made or has failed.
  void Settle()
  {
    const auto isMade = [this](const SceneStructure& structure)
    {
      for (const SceneStep step :
           {SceneStep::Surface, SceneStep::Model, SceneStep::Touch, SceneStep::Cost})
      {
        const auto kind = this->Study->Current().Pipeline().StateOf(step, structure.Id).Is;
        if (kind == StudyStepState::Kind::Running || kind == StudyStepState::Kind::NeedsUpdate)
        {
          return false;
        }
      }
      return true;
    };
    WaitUntil(
        [&]
        {
          const auto& all = this->Study->State().Structures;
          return !this->Study->IsBusy() && std::all_of(all.begin(), all.end(), isMade);
        });
  }
  /// Whether all files are written or have failed.
  bool IsWritten() const { return this->Study->Current().Writing().Waiting().empty(); }
  void FinishWriting()
  {
    WaitUntil([this] { return this->IsWritten(); });
  }
  /// Saves the session, opens it in an empty study, and draws it.
  void ExpectSameStudyAfterReopening()
  {
    const auto file = this->Phantom.Folder / "case.palpate.json";
    ASSERT_TRUE(this->Study->Save(file)) << this->Messages();
    const StudyState saved = this->Study->State();
    this->Study->New();
    this->Study->OpenSession(file);
    this->Settle();
    DrawAll(*this->Window->Views());
    EXPECT_EQ(this->Study->State(), saved);
  }
  /// A coarse fit, which is enough for its shapes: most of a test's time would go to models.
  static FitSettings CoarseFit()
  {
    FitSettings fit;
    fit.Model = FitSettings::ModelKind::Radial;
    fit.Frequency = 8;
    return fit;
  }
  void OpenPhantom(const FitSettings& fit = CoarseFit())
  {
    StudyState first = this->Study->State();
    first.Fit.Model = fit.Model;
    first.Fit.Frequency = fit.Frequency;
    this->Study->BeginWith(first);
    this->Study->OpenVolume(this->VolumeFile());
    this->Study->OpenSegmentation(this->MaskFile());
    WaitUntil([this] { return this->Study->State().Structures.size() == 3; });
    this->Settle();
    DrawAll(*this->Window->Views());
  }
  /// Position of a point in the 3D view, in Qt pixels.
  QPointF PlaceOf(const Vector3& world) const
  {
    return PlaceIn(*this->Window->Views()->Space(), world);
  }
  static QPointF PlaceIn(const ViewPane& pane, const Vector3& world)
  {
    pane.Renderer()->SetWorldPoint(world.x(), world.y(), world.z(), 1.0);
    pane.Renderer()->WorldToDisplay();
    const double* display = pane.Renderer()->GetDisplayPoint();
    const double ratio = pane.Canvas()->devicePixelRatioF();
    return {display[0] / ratio, pane.Canvas()->height() - 1 - display[1] / ratio};
  }
  /// WaitUntil, with forces on or switched off. Any other fault ends the test: with a PacedClock
  /// the machine cannot be the cause.
  void FeelUntil(const std::function<bool()>& isTrue, const char* file = __builtin_FILE(),
                 int line = __builtin_LINE())
  {
    WaitUntil(
        [&]
        {
          const SafetyFault fault = this->Study->Reading().Newest.Safety.Fault;
          if (fault != SafetyFault::None && fault != SafetyFault::SwitchedOff)
          {
            throw std::runtime_error(Describe(fault));
          }
          return isTrue();
        },
        file, line);
  }
  /// Touches what is open.
  void BeginTouch()
  {
    this->Settle();
    DrawAll(*this->Window->Views());
    this->Window->Messages()->Clear(); // on structures that cannot be modelled
    this->Button("start-touch")->click();
    WaitUntil([this] { return this->Study->IsTouching() || !this->Messages().empty(); });
    ASSERT_TRUE(this->Study->IsTouching()) << this->Messages();
  }
  /// By mouse: over this point, then towards it until a structure pushes with a force (N).
  void Press(const Vector3& towardsWorld, double force, int id = 1)
  {
    QWidget* canvas = this->Window->Views()->Space()->Canvas();
    // One notch per 20 ticks near a structure: the hand follows slowly, and a faster target would
    // pass through.
    const auto isFar = [probe = this->Window->Contents().Probe()](const TouchState& state)
    {
      constexpr double Far = 5.0; // mm
      return probe->GetHasNearestPoint() &&
             (Vector3(probe->GetNearestPoint()) - Vector3(state.ProbeWorld)).norm() > Far;
    };
    std::uint64_t last = 0;
    this->FeelUntil(
        [&]
        {
          const TouchState& newest = this->Study->Reading().Newest;
          const bool isFelt =
              this->Study->Reading().TouchedId == id && Norm(newest.ForceWorld) > force;
          if (!isFelt && newest.Tick.Number >= last + 20)
          {
            last = newest.Tick.Number;
            const QPointF place = this->PlaceOf(towardsWorld); // panels may still open
            Move(canvas, place);
            for (int notch = isFar(newest) ? 5 : 1; notch > 0; --notch)
            {
              Wheel(canvas, place, 1);
            }
          }
          return isFelt;
        });
  }
  /// The action of this text, or else the first one that begins with it.
  QAction* Action(const QString& start) const
  {
    for (const bool isWhole : {true, false})
    {
      for (QAction* action : this->Window->findChildren<QAction*>())
      {
        const QString text = action->text().remove('&');
        if (isWhole ? text == start : text.startsWith(start))
        {
          return action;
        }
      }
    }
    ADD_FAILURE() << "no action " << start.toStdString();
    return nullptr;
  }
  QPushButton* Button(const char* name) const
  {
    return this->Window->findChild<QPushButton*>(name);
  }
  std::string Messages() const { return this->Window->Messages()->Text().toStdString(); }

  StudyPhantom Phantom;
  std::unique_ptr<Clock> Time = std::make_unique<PacedClock>();
  QStringList Opened;
  QString SavedTo;
  QString Chosen; ///< folder
  QStringList SeriesOffered;
  int Series = -1;
  QString Found;
  std::vector<StudyMissingFile> AskedFor;
  FileQuestions::Answer Leaving = FileQuestions::Answer::Discard;
  int TimesAskedToSave = 0;
  QString ToDelete;
  bool MayDelete = true;
  std::unique_ptr<StudyController> Study;
  std::unique_ptr<MainWindow> Window;
};
} // namespace palpate::test
