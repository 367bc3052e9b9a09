#include "StartLink.h"

#include "CohortWindow.h"
#include "SampleScene.h"
#include "SofteningCache.h"

#include <QDir>
#include <QTimer>

#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
// Sides of the camera, as SpacePane::LookFrom takes them.
constexpr int Anterior = 0;
constexpr int Posterior = 1;
constexpr int Right = 3;

std::filesystem::path SampleFolder()
{
  const std::filesystem::path cache = SofteningCache::UserFolder();
  return (cache.empty() ? std::filesystem::path(QDir::tempPath().toStdString()) : cache) /
         "samples";
}

SampleScene SceneOf(StartCard::Kind kind)
{
  return kind == StartCard::Kind::Prostate  ? SampleScene::Prostate
         : kind == StartCard::Kind::Lesion  ? SampleScene::Lesion
         : kind == StartCard::Kind::Mastoid ? SampleScene::Mastoid
                                            : SampleScene::Head;
}
} // namespace

StartLink::StartLink(StudyController& study, const FileQuestions& questions, FileMenu& files,
                     StartPage& page, Coach& coach, ViewGrid& views)
    : QObject(&page), Study(study), Questions(questions), Files(files), Page(page), Steps(coach),
      Views(views)
{
  connect(&page, &StartPage::OpenAsked, &files, &FileMenu::OpenFiles);
  connect(&page, &StartPage::FolderAsked, &files, &FileMenu::OpenFolder);
  connect(&page, &StartPage::FileChosen, &files, &FileMenu::OpenRecent);
  connect(&page, &StartPage::CardChosen, this, &StartLink::Open);
  connect(&study, &StudyController::StepsChanged, this, &StartLink::ShowProgress);
  // Once the views show them.
  connect(&study, &StudyController::ProductsChanged, this, &StartLink::LookAtAll,
          Qt::QueuedConnection);
  connect(&study, &StudyController::StepsChanged, this,
          [this]
          {
            if (!this->Study.IsBusy())
            {
              this->LookAtAll();
            }
          });
}

void StartLink::Open(StartCard::Kind kind)
{
  switch (kind)
  {
  case StartCard::Kind::Compare:
    this->Compare();
    break;
  case StartCard::Kind::Cohort:
    this->Files.OpenCohort()->FitMasks();
    break;
  default:
    this->Make(kind,
               [scene = SceneOf(kind), folder = SampleFolder()](const ProgressFunction& progress)
               { return MakeSampleScene(scene, folder, progress); });
  }
}

// Both in one dialog, or one after the other.
void StartLink::Compare()
{
  const char* filter = "Masks (*.nii *.nii.gz *.nrrd *.mha *.mhd *.dcm);;All files (*)";
  QStringList files = this->Questions.ToOpen(this->Page.window(),
                                             "Compare: choose the first mask, or both", filter);
  if (files.size() == 1)
  {
    files += this->Questions.ToOpen(this->Page.window(), "Compare: choose the second mask", filter);
  }
  if (files.size() >= 2)
  {
    this->Make(StartCard::Kind::Compare,
               [first = files[0].toStdString(),
                second = files[1].toStdString()](const ProgressFunction& progress)
               { return CompareMasks(first, second, progress); });
  }
}

void StartLink::Make(StartCard::Kind kind, Making make)
{
  if (!this->Files.MayLeave())
  {
    return;
  }
  this->End();
  StudyJob job;
  job.IsUrgent = true;
  job.Work = [this, kind, make = std::move(make)](const ProgressFunction& progress)
  {
    return StudyJob::Delivery(
        [this, kind, state = make(progress)]
        {
          this->End();
          this->Take(kind, state);
        });
  };
  job.Fail = [this](const std::string& message)
  {
    this->End();
    this->Study.Report(message);
  };
  this->Made = kind;
  this->Job = this->Study.Current().Jobs().Start(std::move(job));
  this->ShowProgress();
}

void StartLink::Take(StartCard::Kind kind, const StudyState& state)
{
  if (!this->Page.isVisibleTo(this->Page.window()))
  {
    return; // something else was opened meanwhile
  }
  this->Study.OpenState(state);
  this->Side = kind == StartCard::Kind::Lesion    ? Posterior
               : kind == StartCard::Kind::Mastoid ? Right
                                                  : Anterior;
  this->LookAtAll();
  this->Steps.Begin(kind);
}

// The structures appear one after the other.
void StartLink::LookAtAll()
{
  if (this->Side)
  {
    this->Views.Space()->LookFrom(*this->Side);
    if (!this->Study.IsBusy() || this->Study.IsTouching())
    {
      this->Side.reset(); // the camera is the user's
    }
  }
}

void StartLink::End()
{
  if (this->Job)
  {
    this->Study.Current().Jobs().Cancel(*this->Job);
    this->Job.reset();
    this->Page.ShowProgress(this->Made, {});
  }
}

void StartLink::ShowProgress()
{
  if (!this->Job)
  {
    return;
  }
  const auto progress = this->Study.Current().Jobs().ProgressOf(*this->Job);
  if (progress)
  {
    this->Page.ShowProgress(
        this->Made,
        QString("Getting it ready, %1 %...").arg(std::lround(100.0 * progress->Fraction)));
  }
}
} // namespace palpate
