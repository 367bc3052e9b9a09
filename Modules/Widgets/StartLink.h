#pragma once

#include "Coach.h"
#include "FileMenu.h"
#include "FileQuestions.h"
#include "StartPage.h"
#include "StudyController.h"
#include "ViewGrid.h"

#include <QObject>

#include <functional>
#include <optional>

namespace palpate
{
/// Does what the start page offers. The scenes of its cards are made in the background, into the
/// user's cache.
class StartLink : public QObject
{
  Q_OBJECT

public:
  /// Keeps the addresses; belongs to the page.
  StartLink(StudyController& study, const FileQuestions& questions, FileMenu& files,
            StartPage& page, Coach& coach, ViewGrid& views);

  /// As a click on its card does.
  void Open(StartCard::Kind kind);

private:
  using Making = std::function<StudyState(const ProgressFunction& progress)>;

  void Make(StartCard::Kind kind, Making make);
  void Take(StartCard::Kind kind, const StudyState& state);
  void Compare();
  void End();
  void ShowProgress();
  void LookAtAll();

  StudyController& Study;
  const FileQuestions& Questions;
  FileMenu& Files;
  StartPage& Page;
  Coach& Steps;
  ViewGrid& Views;
  std::optional<StudyJobs::Id> Job;
  StartCard::Kind Made = StartCard::Kind::Prostate; ///< by the job
  std::optional<int> Side; ///< from which to look at all of the scene, until it is made
};
} // namespace palpate
