#pragma once

#include "StudyController.h"
#include "StudyRecovery.h"

#include <QFrame>
#include <QLabel>
#include <QLockFile>
#include <QObject>
#include <QTimer>

#include <deque>
#include <filesystem>
#include <functional>
#include <memory>

namespace palpate
{
/// Keeps what was not saved of a window's study every minute, and offers what a window that died
/// has left. Each window has a folder, with a lock that tells whether the window still runs.
class RecoveryLink : public QObject
{
  Q_OBJECT

public:
  /// Keeps the address. Folders are made below `root`; `mayLeave` asks whether to save what is open
  /// before it is replaced, and
  /// `mayDelete` before what was kept of a study of this title is deleted.
  RecoveryLink(StudyController& study, const std::filesystem::path& root,
               std::function<bool()> mayLeave, std::function<bool(const QString& title)> mayDelete,
               QWidget* window);
  ~RecoveryLink() override;

  /// The user's folder for this program.
  static std::filesystem::path UserFolder();

  /// Offers what is left, and is hidden if there is nothing.
  QFrame* Offer() const { return this->Strip; }
  /// Keeps what has changed since it was last kept; the timer calls it.
  void Keep();
  /// For the end of the program: keeps the last changes, or removes what was kept if the user has
  /// left the study.
  void End(bool isLeft);
  const StudyRecovery& Kept() const { return this->Recovery; }

private:
  // What a window has left.
  struct Left
  {
    std::filesystem::path Folder;
    std::unique_ptr<QLockFile> Lock; ///< so that no other window offers it
  };

  void Look();
  bool LockOwn();
  void Release();
  void Tell(const std::string& problem);
  void FindLeft();
  void ShowLeft();
  void Recover();
  void Discard();
  void MakeStrip(QWidget* window);

  StudyController& Study;
  std::filesystem::path Root;
  std::function<bool()> MayLeave;
  std::function<bool(const QString&)> MayDelete;
  StudyRecovery Recovery;
  std::unique_ptr<QLockFile> Own; ///< of Recovery's folder; null before it is needed
  std::deque<Left> All;
  QTimer Timer;
  bool IsWaiting = false; ///< for the drill to stop
  QString Told;           ///< that nothing can be kept; empty if it can
  QFrame* Strip = nullptr;
  QLabel* Text = nullptr;
};
} // namespace palpate
