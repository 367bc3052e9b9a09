#pragma once

#include "MarkButton.h"
#include "TrialActivity.h"

#include <QDoubleSpinBox>

#include <optional>

namespace palpate
{
/// The place over a nodule is marked with the tool, and its diameter entered; or there is none.
class NoduleActivity : public TrialActivity
{
  Q_OBJECT

public:
  NoduleActivity(const TrialPlace& place, QWidget* strip);
  ~NoduleActivity() override;

  void Begin() override {}
  void Take(const TouchState& newest, TaskWatch& watch) override;
  bool HasAnswer() const override { return this->None->isChecked() || this->Place.has_value(); }
  TaskAnswer Answer() const override;

private:
  void Show();

  ViewContents& Contents;
  std::optional<Vector3> Place; ///< world, mm
  MarkButton* Mark;
  QDoubleSpinBox* Diameter; ///< mm
  QPushButton* None;
};
} // namespace palpate
