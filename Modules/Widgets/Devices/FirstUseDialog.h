#pragma once

#include "DeviceChoice.h"
#include "DeviceTrial.h"
#include "StudyController.h"
#include "StudyDevice.h"
#include "TrialPad.h"

#include <QDialog>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>

#include <array>
#include <vector>

class QVBoxLayout;

namespace palpate
{
/// The first use of a device, step by step: choose it, move it, feel a soft wall, and stop the
/// force, which a recording proves. It opens the device itself, so touch ends before.
class FirstUseDialog : public QDialog
{
  Q_OBJECT

public:
  /// Keeps the address of the study, whose device it begins with.
  explicit FirstUseDialog(StudyController& study, QWidget* parent);
  ~FirstUseDialog() override;

  const DeviceTrial& Trial() const { return this->Attempt; }

  void done(int result) override;

protected:
  bool eventFilter(QObject* object, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  enum class Page
  {
    Choose,
    Move,
    Feel,
    Stop
  };

  void MakeChoice(QVBoxLayout* column);
  void MakeBars(QVBoxLayout* column);
  void MakeButtons(QVBoxLayout* column);
  void Begin();
  void TakeDevice(std::unique_ptr<HapticDevice> device, const std::string& problem);
  void GoOn();
  void TurnTo(Page page);
  void Look();
  void LeadHand();
  void ShowProgress();
  void ShowProof();
  void ShowButtons();
  void SearchDevice();
  void Tell(const QString& text, bool isGood = false);
  bool MayGoOn() const;

  StudyController& Study;
  QTemporaryDir Folder;
  DeviceTrial Attempt;
  StudyDevice Opener;
  QTimer Timer;
  Page At = Page::Choose;
  std::optional<StudyJobs::Id> Searching;
  QString Line; ///< of the chosen device
  std::string Looked;
  // mm of the device: of a hand that the pad leads.
  Vector3 Led = Vector3::Zero();
  Vector3 Target = Vector3::Zero();

  QLabel* Title;
  QLabel* What;
  QWidget* Choice;
  DeviceChoice* Device;
  TrialPad* Pad;
  QWidget* Bars;
  std::array<QProgressBar*, 4> Axes{}; ///< x, y, z, turn
  std::array<QLabel*, 4> Names{};
  QLabel* Result;
  QPushButton* Stop;
  QPushButton* Allow;
  QPushButton* Next;
};
} // namespace palpate
