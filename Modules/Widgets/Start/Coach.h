#pragma once

#include "StartCard.h"
#include "StudyController.h"

#include <QFrame>
#include <QLabel>

#include <array>
#include <filesystem>
#include <optional>

namespace palpate
{
/// A strip over the views with the first three steps of a card's scene. It goes on as the user does
/// them; once it was closed, it is not shown for that card again.
class Coach : public QFrame
{
  Q_OBJECT

public:
  static constexpr int StepCount = 3;

  /// Keeps the address.
  Coach(StudyController& study, QWidget* parent);

  /// Begins with the scene of a card that is open; no effect for cards without steps, and those
  /// whose coach was closed.
  void Begin(StartCard::Kind kind);
  /// Number of steps that are done.
  int Done() const { return this->DoneCount; }

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  void ShowStep(int step);
  void Close();
  void Look();
  void LeaveOtherStudy();
  void Show();
  bool IsDone(int step);
  bool IsFelt() const;

  StudyController& Study;
  std::optional<StartCard::Kind> Of;
  std::filesystem::path Volume; ///< of the scene
  int DoneCount = 0;
  Vector3 FirstPlace = Vector3::Zero(); ///< of the tool at its first contact
  int FirstId = 0;                      ///< of the structure that was touched first
  QLabel* Title;
  std::array<QLabel*, StepCount> Steps{};
};
} // namespace palpate
