#pragma once

#include "DeviceChoice.h"
#include "DeviceList.h"
#include "StudyController.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QWidget>

#include <optional>
#include <vector>

class QFormLayout;

namespace palpate
{
/// The device of a touch: which one, what is missing to use it, which of its buttons is the clutch,
/// and for one that was never used here, the offer to try it. Choosing a device brings its kept
/// settings back, and while touching, changes it at once.
class DevicePanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the address.
  explicit DevicePanel(StudyController& study, QWidget* parent = nullptr);
  /// Cancels a search.
  ~DevicePanel() override;

  /// Keeps a setting of the chosen device.
  void KeepScale(double scale);
  void KeepAxes(bool followCamera);

Q_SIGNALS:
  /// The user wants to try the chosen device step by step.
  void TrialAsked();

private:
  void EndOffer();
  void MakeRows();
  void TakeChoice();
  void TakeClutch();
  void ShowState();
  void ShowClutch();
  QString LineNow() const;
  void ShowLine();
  void Search(const std::string& kind);
  void SearchAgain();

  StudyController& Study;
  DeviceChoice* Device;
  QLabel* Line;
  QFormLayout* Form;
  QComboBox* Clutch;
  QWidget* Offer;
  QTimer Watch;
  std::string Shown; ///< the device whose rows are shown
  std::vector<DeviceReport> Found;
  std::optional<StudyJobs::Id> Searching;
};
} // namespace palpate
